// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>
#include <osgTreeWind/wind/WindFiles.h>
#include <osgTreeWind/wind/WindMap.h>

#include <memory>
#include <utility>

namespace osgTreeWind {

/// What a Wind keeps of the files that it was read from: for the library's own files and its tests.
struct WindParts {
    /// The files that its field was read from; null: made by hand.
    static const WindFiles* files(const Wind& wind) {
        return wind._read == wind.field ? wind._files.get() : nullptr;
    }
    /// The map of its field's data; null: the scene's.
    static const WindMap* map(const Wind& wind) {
        return wind._read == wind.field ? wind._map.get() : nullptr;
    }

    static void setFiles(Wind& wind, WindFiles files) {
        wind._read = wind.field;
        wind._files = std::make_shared<const WindFiles>(std::move(files));
    }
    static void setMap(Wind& wind, WindMap map) {
        wind._read = wind.field;
        wind._map = std::make_shared<const WindMap>(std::move(map));
    }
};

} // namespace osgTreeWind

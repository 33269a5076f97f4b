// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>
#include <osgTreeWind/wind/WindFiles.h>
#include <osgTreeWind/wind/WindMap.h>

namespace osgTreeWind {

/// What a Wind keeps of the files that it was read from: for the library's own files and its tests.
struct WindParts {
    /// Null: made by hand.
    static std::shared_ptr<const WindFiles>& files(Wind& wind) { return wind._files; }
    static const WindFiles* files(const Wind& wind) { return wind._files.get(); }
    /// The map of the field's data; null: the scene's.
    static std::shared_ptr<const WindMap>& map(Wind& wind) { return wind._map; }
    static const WindMap* map(const Wind& wind) { return wind._map.get(); }
};

} // namespace osgTreeWind

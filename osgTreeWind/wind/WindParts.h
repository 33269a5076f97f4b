// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>
#include <osgTreeWind/wind/WindMap.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// The files that a wind was read from, and how: what a forest file says of them.
struct WindFiles {
    std::vector<std::string> files;
    bool series = false;           ///< Each is a moment of one wind, even if there is only one.
    std::vector<double> times;     ///< Of each of the files, seconds; empty: as they say.
    glm::dvec3 offset{0.0};        ///< From the files' coordinates to those of the world, metres.
    glm::dvec3 origin{0.0};        ///< Of the forest it was read for, in the world.
    std::string crs;               ///< Of that forest.
    double roughness = 0.0;        ///< Below the data, metres; 0: none is taken.
    double height = 0.0;           ///< Of data that do not say theirs.
    std::string speedUnit = "m/s"; ///< Of speeds where a file does not say.
    bool holdsBeyond =
        false; ///< Whether a forest that lies wholly beyond the data has the wind of their edge.
};

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

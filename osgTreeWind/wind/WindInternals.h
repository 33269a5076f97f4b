// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>
#include <osgTreeWind/wind/WindMap.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// The files that a wind was read from and the options used, as a forest file stores them.
struct WindFiles {
    std::vector<std::string> files;
    bool series = false;       ///< Whether the files are time steps (key `files`), even if there is only one.
    std::vector<double> times; ///< Time of each file, seconds; empty: the files contain their times.
    glm::dvec3 offset{0.0};    ///< From file to world coordinates, metres.
    glm::dvec3 origin{0.0};    ///< World origin of the forest that the wind was read for.
    std::string crs;           ///< CRS of that forest.
    double roughness = 0.0;    ///< WindFileOptions::roughness
    double height = 0.0;       ///< WindFileOptions::height
    std::string speedUnit = "m/s"; ///< WindFileOptions::speedUnit
    bool allowsOutside = false; ///< Whether a forest completely outside the data gets the wind at their edge.
};

/// Access to private members of Wind, for the library and its tests.
struct WindInternals {
    /// The files that the field was read from; null if it was not read from files.
    static const WindFiles* files(const Wind& wind) {
        return wind._fieldFromFiles == wind.field ? wind._files.get() : nullptr;
    }
    /// The transform to the field's data; null if they are in the scene's CRS.
    static const WindMap* map(const Wind& wind) {
        return wind._fieldFromFiles == wind.field ? wind._map.get() : nullptr;
    }

    static void setFiles(Wind& wind, WindFiles files) {
        wind._fieldFromFiles = wind.field;
        wind._files = std::make_shared<const WindFiles>(std::move(files));
    }
    static void setMap(Wind& wind, WindMap map) {
        wind._fieldFromFiles = wind.field;
        wind._map = std::make_shared<const WindMap>(std::move(map));
    }
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <string>
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
};

} // namespace osgTreeWind

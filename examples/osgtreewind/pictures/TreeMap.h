// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

/// A tree on a map.
struct MapTree {
    glm::dvec2 place{0.0};       ///< Metres, x east, y north.
    double radius = 0.0;         ///< Of its crown, metres.
    std::optional<double> value; ///< Empty: unknown.
};

/// Draws trees from above, coloured by their values, with a legend, a scale and an arrow to the north, as SVG
/// or PNG. The smallest values are red and drawn last. Throws CommandError on failure.
/// @param title of the map. @param quantity that the values measure, with its unit.
void drawTreeMap(const std::vector<MapTree>& trees, const std::string& title, const std::string& quantity,
                 const std::string& path);

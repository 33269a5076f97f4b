// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>

/// The place of one of `count` trees in a square of rows. @param apart metres from tree to tree.
inline glm::dvec3 placeInRows(std::size_t tree, std::size_t count, double apart) {
    const auto perRow = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const std::size_t row = tree / perRow, column = tree % perRow;
    return {apart * static_cast<double>(column), apart * static_cast<double>(row), 0.0};
}

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// A centre line with the arc length up to each of its points.
struct WoodLine {
    std::vector<glm::dvec3> points;
    std::vector<double> arc; ///< Per point; the first is 0.

    void add(const glm::dvec3& point);
    double length() const { return arc.back(); }
    glm::dvec3 at(double along) const; ///< The point at an arc length, which is clamped to the line.
};

/// The trunk, or a branch with its continuation.
struct WoodAxis {
    int parent = -1;           ///< Index of the axis it springs from, < own index; -1 for the trunk.
    int order = 0;             ///< 0: the trunk, 1: a branch of it, ...
    double attach = 0.0;       ///< Arc length along its parent's line at which it springs.
    WoodLine line;             ///< From its parent's centre line to its tip; the root starts at the origin.
    std::vector<double> radii; ///< Per segment of the line, non-increasing.
    double volume = 0.0;       ///< Of its wood, m^3.
    std::size_t pieces = 0;    ///< Number of cylinders or metamers it consists of.
    /// Arc lengths between which it bears leaves, if known; none if the second is not larger.
    std::optional<std::pair<double, double>> leafy;
};

} // namespace osgTreeWind

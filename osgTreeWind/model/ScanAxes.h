// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <cstddef>

namespace osgTreeWind {

/// A centre line with the arc length up to each of its points.
struct ScanLine {
    std::vector<glm::dvec3> points;
    std::vector<double> arc; ///< As many; the first is 0.

    void add(const glm::dvec3& point);
    double length() const { return arc.back(); }
    glm::dvec3 at(double along) const; ///< The point at an arc length, those outside at an end.
};

/// The trunk, or a branch with all that carries it on: a chain of cylinders.
struct ScanAxis {
    int parent = -1;           ///< Index of the axis it springs from, < own index; -1 for the trunk.
    int order = 0;             ///< 0 the trunk, 1 a branch of it, ...
    double attach = 0.0;       ///< Arc length along its parent's line at which it springs.
    ScanLine line;             ///< From its parent's centre line to its tip; the root's start is the origin.
    std::vector<double> radii; ///< Of each stretch of the line; none is thicker than the one before.
    std::size_t cylinders = 0;
    double volume = 0.0; ///< Of its cylinders, m^3.
};

/// Orders a sound scan (problemOfScan) by axes, the trunk first, parents before their branches.
///
/// Of the cylinders that begin at another's end, within its radius, the one that bears the greatest length of
/// wood carries the axis on; where there is none, of those that begin beyond the end. Radii are brought to
/// taper by joining cylinders that do not: sections are averaged by length, which keeps the volume.
std::vector<ScanAxis> axesOfScan(const ScanCylinders& cylinders);

} // namespace osgTreeWind

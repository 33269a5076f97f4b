// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/model/Skeleton.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A piece of a tree's wood as laser scans are fitted: a round cylinder, and which one it springs from.
struct ScanCylinder {
    glm::dvec3 start{0.0}; ///< Of its axis, metres, z up; coordinates of a map are welcome.
    glm::dvec3 end{0.0};   ///< Likewise.
    double radius = 0.0;   ///< Metres.
    int parent = -1;       ///< Index of the cylinder it springs from; -1 for the root. Any order.
    int line = 0;          ///< Of the file it stands in, 1-based; 0 when unknown.
};

/// All cylinders of one tree.
using ScanCylinders = std::vector<ScanCylinder>;

/// How much of a tree's wood moves by itself, and how much more is drawn.
struct WoodDetail {
    int ringsPerBranch = 8;         ///< Of each unit, 2 to 64.
    std::size_t mostUnits = 400;    ///< At most 4096. The trunk is taken whatever it says.
    double thinnest = 0.002;        ///< Branches thinner at their base are no units; a radius, metres.
    std::size_t mostShoots = 20000; ///< Of the branches that are no units, the thickest; at most 100,000.
};

/// What became of a scan. Metres and m^3.
struct ScanReport {
    std::string source;          ///< Where it was read from, as its reader says.
    std::string file;            ///< That file, absolute; empty: none.
    std::size_t tree = 0;        ///< Which of its trees,
    std::size_t trees = 0;       ///< of so many.
    std::size_t cylinders = 0;   ///< In the scan.
    std::size_t taken = 0;       ///< Of them, in units and shoots; the others were pruned.
    std::size_t units = 0;       ///< Of the skeleton.
    std::size_t shoots = 0;      ///< Of the skeleton.
    double height = 0.0;         ///< Of all cylinders' ends above the foot.
    double cylinderVolume = 0.0; ///< Of all cylinders.
    double woodVolume = 0.0;     ///< Of the skeleton.
    double baseDiameter = 0.0;   ///< Of the skeleton's trunk at the ground.
};

/// A tree as it was measured.
struct ScannedTree {
    Skeleton skeleton; ///< Of the cylinders, joined.
    ScanReport report; ///< What was mended on the way.
};

/// Cylinders as the skeleton of a tree that stands at the origin with the start of its root.
///
/// Each axis (the trunk, a branch with what carries it on) becomes one unit, or several where it is longer
/// than an eighth of the height or crooked; level is the order of branching, and branches spring along their
/// parent. Radii are linear on a unit, go on from unit to unit, keep the volume of the axis' cylinders
/// (between that along bent centre lines and that along straight units) and are at most the parent's where a
/// branch springs. What leads to the highest point is taken first, then the thickest branches. Those thinner
/// than `thinnest` or too many for `mostUnits` become shoots with all that they bear: they ride on the unit
/// from which they spring. Branches shorter than a thousandth of the height, or too many for `mostShoots`,
/// are pruned.
/// @return what keeps the cylinders from being one tree, with its line: no cylinder, a radius outside (0, 10]
/// m or a length below a micrometre, no root or two, a parent that is not there, a loop, a height above the
/// foot outside 0.1 to 150 m, or an extent of over 200 m.
OSGTREEWIND_EXPORT Result<ScannedTree> makeScannedTree(const ScanCylinders& cylinders,
                                                       const WoodDetail& detail = {});

} // namespace osgTreeWind

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

/// A cylinder fitted to a laser scan of a tree.
struct ScanCylinder {
    glm::dvec3 start{0.0}; ///< Start of its axis, metres, z up; may be in map coordinates.
    glm::dvec3 end{0.0};   ///< End of its axis.
    double radius = 0.0;   ///< Metres.
    int parent = -1;       ///< Index of the cylinder it springs from, in any order; -1 for the root.
    int line = 0;          ///< Line in its file, 1-based; 0 if unknown.
};

/// All cylinders of one tree.
using ScanCylinders = std::vector<ScanCylinder>;

/// Level of detail of a scanned tree's wood.
struct WoodDetail {
    int ringsPerBranch = 8;        ///< Of each unit, 2 to 64.
    std::size_t maxUnits = 400;    ///< At most 4096. The trunk is always included.
    double minRadius = 0.002;      ///< Smallest base radius of a branch that becomes a unit, metres.
    std::size_t maxShoots = 20000; ///< The thickest of the other branches; at most 100,000.
};

/// Statistics of a converted scan. Metres and m^3.
struct ScanReport {
    std::string source;            ///< As described by the reader.
    std::string file;              ///< Absolute path; empty without a file.
    std::string up;                ///< Key `up` of its species: "y" or "z"; empty: found.
    std::size_t tree = 0;          ///< Index of the tree in the file.
    std::size_t trees = 0;         ///< Number of trees in the file.
    std::size_t cylinders = 0;     ///< In the scan.
    std::size_t usedCylinders = 0; ///< Cylinders in units and shoots; the others were pruned.
    std::size_t units = 0;         ///< Of the skeleton.
    std::size_t shoots = 0;        ///< Of the skeleton.
    double height = 0.0;           ///< Of the highest cylinder end above the foot.
    double cylinderVolume = 0.0;   ///< Of all cylinders.
    double woodVolume = 0.0;       ///< Of the skeleton.
    double baseDiameter = 0.0;     ///< Of the skeleton's trunk at the ground.
};

/// A tree made from a laser scan.
struct ScannedTree {
    Skeleton skeleton; ///< Joined.
    ScanReport report; ///< Statistics of the conversion.
};

/// Converts cylinders to the skeleton of a tree with the start of its root at the origin.
///
/// Each axis (the trunk, or a branch with its continuation) becomes one unit, or several if it is crooked or
/// longer than an eighth of the height. The level is the order of branching, and branches spring along their
/// parent. Radii are linear on a unit and continuous from unit to unit, keep the volume of the axis'
/// cylinders (the mean of that along bent centre lines and that along straight units) and do not exceed the
/// parent's at the base of a branch. The path to the highest point is included first, then the thickest
/// branches. Branches thinner than `minRadius` or in excess of `maxUnits` become shoots with all their
/// branches; shoots move with the unit from which they spring. Branches shorter than a thousandth of the
/// height, or in excess of `maxShoots`, are pruned.
/// @return an error with the line, if the cylinders are not one tree: no cylinders, a radius outside (0, 10]
/// m, a length below a micrometre, no root or two, a missing parent, a loop, a height above the foot outside
/// 0.1 to 150 m, or an extent of over 200 m.
OSGTREEWIND_EXPORT Result<ScannedTree> makeScannedTree(const ScanCylinders& cylinders,
                                                       const WoodDetail& detail = {});

} // namespace osgTreeWind

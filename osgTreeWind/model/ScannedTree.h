// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/model/ScanCylinder.h>
#include <osgTreeWind/model/Skeleton.h>

#include <cstddef>
#include <string>

namespace osgTreeWind {

/// How much of a scan becomes wood; the rest is left to leaves.
struct ScanDetail {
    int ringsPerBranch = 8;      ///< Of each unit, 2 to 64.
    std::size_t mostUnits = 400; ///< At most 4096. The trunk is taken whatever it says.
    double thinnest = 0.002;     ///< Branches thinner at their base are left out; a radius, metres.
};

/// What became of a scan. Metres and m^3.
struct ScanReport {
    std::string source;          ///< Where it was read from, as its reader says.
    std::string file;            ///< That file, absolute; empty: none.
    std::size_t tree = 0;        ///< Which of its trees,
    std::size_t trees = 0;       ///< of so many.
    std::size_t cylinders = 0;   ///< In the scan.
    std::size_t taken = 0;       ///< Of them, in units; the others were pruned.
    std::size_t units = 0;       ///< Of the skeleton.
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
/// than `thinnest`, shorter than a thousandth of the height, or too many for `mostUnits` are pruned with all
/// they bear.
/// @return problemOfScan() where there is one.
OSGTREEWIND_EXPORT Result<ScannedTree> makeScannedTree(const ScanCylinders& cylinders,
                                                       const ScanDetail& detail = {});

/// Volume of the wood of a skeleton along its centre lines, m^3.
double woodVolume(const Skeleton& skeleton);

} // namespace osgTreeWind

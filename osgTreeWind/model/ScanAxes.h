// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/model/WoodAxis.h>

namespace osgTreeWind {

/// Orders a sound scan (problemOfScan) by axes, the trunk first, parents before their branches.
///
/// Of the cylinders that begin at another's end, within its radius, the one that bears the greatest length of
/// wood carries the axis on; where there is none, of those that begin beyond the end. Radii are brought to
/// taper by joining cylinders that do not: sections are averaged by length, which keeps the volume.
std::vector<WoodAxis> axesOfScan(const ScanCylinders& cylinders);

} // namespace osgTreeWind

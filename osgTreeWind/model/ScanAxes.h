// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/model/WoodAxis.h>

namespace osgTreeWind {

/// Sorts a valid scan (problemOfScan()) into axes, the trunk first, parents before their branches.
///
/// An axis continues with the child that carries the greatest length of wood, of those that begin within its
/// radius of the end; if there are none, of those that begin beyond the end. Cylinders that do not taper are
/// merged, and their sections averaged by length, which keeps the volume.
std::vector<WoodAxis> axesOfScan(const ScanCylinders& cylinders);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <optional>
#include <string>

namespace osgTreeWind {

constexpr std::size_t mostScanUnits = 4096, mostScanShoots = 100000; ///< Of a skeleton.

/// What keeps the cylinders from being one tree, with its line: no cylinder, a radius outside (0, 10] m or a
/// length below a micrometre, no root or two, a parent that is not there, a loop, a height above the foot
/// outside 0.1 to 150 m, or an extent of over 200 m. Nothing for a sound tree.
std::optional<Diagnostic> problemOfScan(const ScanCylinders& cylinders);

/// What keeps a skeleton from being one tree's wood; empty for a sound one.
std::string problemOfSkeleton(const Skeleton& skeleton);

} // namespace osgTreeWind

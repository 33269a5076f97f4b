// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <optional>
#include <string>

namespace osgTreeWind {

constexpr std::size_t maxScanUnits = 4096, maxScanShoots = 100000; ///< Limits of a skeleton.

/// The reason why cylinders do not form a tree, with their line (see makeScannedTree()); empty if they do.
std::optional<Diagnostic> problemOfScan(const ScanCylinders& cylinders);

/// The reason why a skeleton is invalid; empty if it is valid.
std::string problemOfSkeleton(const Skeleton& skeleton);

} // namespace osgTreeWind

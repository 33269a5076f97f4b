// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

namespace osgTreeWind {

/// Joins each branch whose parent was not found to the cylinder nearest to where it begins: programs leave a
/// few twigs of a scan without a parent. The root is the one that bears the most wood.
/// @return how many were joined; a problem where they have more than 5 % of the wood.
Result<std::size_t> joinOrphans(ScanCylinders& cylinders);

} // namespace osgTreeWind

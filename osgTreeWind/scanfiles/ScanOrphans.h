// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

namespace osgTreeWind {

/// Joins each branch without a parent to the cylinder nearest to its start, because programs leave a few
/// twigs of a scan without a parent. The root is the cylinder without a parent that bears the most wood.
/// @return the number of joined branches; an error if they have more than 5 % of the wood.
Result<std::size_t> joinOrphans(ScanCylinders& cylinders);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

namespace osgTreeWind {

/// Validates a forest. Reports numbers that are out of range or not finite, invalid enum values, and trees
/// without a species or too far from the origin. Keys are those of a file, with 0-based indices:
/// "species[1].wood.density". A Forest rejects a description that has problems.
/// @return the first 100 problems; empty if the description is valid.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics check(const ForestDescription& description);

/// Validates one tree for `addTree()` and `changeTree()`.
/// @param forest provides the species and the origin; its trees are ignored.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics check(const TreePlacement& tree,
                                                   const ForestDescription& forest);

/// Validates one species for `addSpecies()`.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics check(const Species& species);

} // namespace osgTreeWind

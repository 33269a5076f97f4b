// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

namespace osgTreeWind {

/// Finds what no file could say: numbers that are out of range or not finite, unknown words, a tree without a
/// species or too far from the origin. Keys are those of a file with indices from 0, as
/// "species[1].wood.density". A forest refuses a description for which this finds something.
/// @return the first 100 problems; empty when all is well.
OSGTREEWIND_EXPORT Diagnostics check(const ForestDescription& description);

/// The same for one tree, as `addTree()` and `changeTree()` take it.
/// @param forest has the species and the origin; its trees do not count.
OSGTREEWIND_EXPORT Diagnostics check(const TreePlacement& tree, const ForestDescription& forest);

/// The same for one species, as `addSpecies()` takes it.
OSGTREEWIND_EXPORT Diagnostics check(const Species& species);

} // namespace osgTreeWind

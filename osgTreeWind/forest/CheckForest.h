// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

namespace osgTreeWind {

/// What no file could say: numbers out of range or not finite, a tree without a species or far from the
/// origin. Keys are those of a file with indices from 0, as "species[1].wood.density".
/// @return the first 100 problems; empty when all is well.
OSGTREEWIND_EXPORT Diagnostics check(const ForestDescription& description);

} // namespace osgTreeWind

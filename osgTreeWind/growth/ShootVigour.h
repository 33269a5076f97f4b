// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Length by which a bud grows this year, metres. It follows from the bud's share of the tree's growth, and
/// decreases with the age of its axis and towards the surface of the intended crown. Draws one random number.
float yearlyLength(TreeState& tree, const Bud& bud);

} // namespace osgTreeWind

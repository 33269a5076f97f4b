// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Length that a bud grows in this year, metres: its share of the tree's growth, slower with the age of its
/// axis and at the outside of the crown that the tree is to have. Draws one random number.
float yearlyLength(TreeState& tree, const Bud& bud);

} // namespace osgTreeWind

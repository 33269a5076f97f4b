// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthGoal.h>
#include <osgTreeWind/growth/GrowthSite.h>
#include <osgTreeWind/growth/TreeHabit.h>
#include <osgTreeWind/growth/TreeState.h>

#include <cstdint>

namespace osgTreeWind {

/// A tree that has grown from a seedling to the size of `goal`, by self-organisation after Palubicki et al.
/// 2009: each year buds compete for light, branches that do not pay are shed.
///
/// Its age is that at which it has its height; the vigour of its side shoots is chosen so that the crown has
/// its width; what is missing then is stretched (GrownForm::heightFactor, widthFactor). Values out of range
/// are brought into it. One seed gives one tree, bit for bit, on every machine. Thread-safe.
GrownForm growTree(const TreeHabit& habit, const GrowthSite& site, const GrowthGoal& goal,
                   std::uint32_t seed);

/// A tree as it stands, stretched to fit `goal`, with radii.
GrownForm fittedForm(const TreeState& tree, const GrowthGoal& goal);

} // namespace osgTreeWind

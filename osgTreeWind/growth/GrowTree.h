// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthParameters.h>
#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// A tree that grows from a seedling to its size, by self-organisation after Palubicki et al. 2009.
///
/// Each year its leaves unfold and shade each other (ShadeGrid); branches that do not get enough light die
/// (ShedBranches); the growth that the light allows is shared out among buds (AllotGrowth); shoots grow, with
/// new side buds (GrowShoots); boughs sink (SinkBoughs). It grows until it has its height. The vigour of
/// boughs is chosen so that the crown gets its width, in at most six growths; what is missing then is
/// stretched (GrownForm::heightFactor, widthFactor). Where the site leaves no light for such a crown, the
/// factors differ much.
///
/// Values out of range are brought into it. One seed gives one tree, bit for bit, on every machine.
/// Thread-safe.
GrownForm growTree(const GrowthParameters& parameters);

/// A tree as it stands, stretched to fit `goal`, with radii.
GrownForm fittedForm(const TreeState& tree, const GrowthGoal& goal);

} // namespace osgTreeWind

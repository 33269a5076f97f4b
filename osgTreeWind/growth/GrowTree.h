// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrownForm.h>
#include <osgTreeWind/growth/GrowthParameters.h>
#include <osgTreeWind/growth/TreeState.h>

namespace osgTreeWind {

/// Grows a tree from a seedling to its goal, by self-organisation (Palubicki et al. 2009).
///
/// Each year leaves unfold and shade each other (ShadeGrid), branches without enough light die
/// (ShedBranches), the growth that the light allows is distributed among buds (AllotGrowth), shoots grow and
/// get new side buds (GrowShoots), and boughs sink (SinkBoughs). The tree grows until it reaches its height.
/// Up to six growths search the vigour of boughs that gives the crown its width. The remaining difference is
/// stretched (GrownForm::heightFactor, widthFactor); these factors differ much if the site leaves too little
/// light for such a crown.
///
/// Values out of range are clamped. One seed gives one tree, bit for bit, on every machine. Thread-safe.
GrownForm growTree(const GrowthParameters& parameters);

/// Form of a tree's present state, stretched to fit `goal`, with radii.
GrownForm fittedForm(const TreeState& tree, const GrowthGoal& goal);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <cstdint>

namespace osgTreeWind {

/// Adds fine shoots to the leafy wood of a grown tree, which bear leaves in the gaps of its crown: a growth
/// by light leaves pads of leaves with sky between them, because its shoots stand for several real ones. Of
/// some random directions, each shoot takes the one with the fewest leaves, and none leaves the crown. They
/// follow the unit that bears them.
/// @param skeleton must have `leafyUnits`. @param length typical length of a shoot, metres, at least 0.1;
/// there is one per 1.5 times this length of leafy wood. 0 adds none. @param seed determines the shoots, bit
/// for bit.
void addSideShoots(Skeleton& skeleton, float length, std::uint32_t seed);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindSource.h>

#include <vector>

namespace osgTreeWind {

/// What a person may put to a tree, one after the other: a helicopter of seven tonnes 15 m above it, a fan
/// that blows at it from the west, a whirl beside it, a place out of the wind around it.
/// @param foot of the tree, in the wind's frame. @param height of the tree, metres.
std::vector<WindSource> sourcesByHand(const glm::dvec3& foot, double height);

} // namespace osgTreeWind

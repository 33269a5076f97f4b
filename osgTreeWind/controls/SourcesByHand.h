// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindSource.h>

#include <vector>

namespace osgTreeWind {

/// What a person may put to a tree, one after the other: a helicopter of seven tonnes 15 m above it, a fan
/// that blows at it from the west, a whirl beside it, a place out of the wind around it, a hundred kilograms
/// of TNT 15 m west of it that go off a second later.
/// @param foot of the tree, in the wind's frame. @param height of the tree, metres. @param time now, seconds.
std::vector<WindSource> sourcesByHand(const glm::dvec3& foot, double height, double time);

} // namespace osgTreeWind

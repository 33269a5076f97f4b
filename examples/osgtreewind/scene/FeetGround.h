// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

/// A smooth ground through the feet of the trees, level beyond them. Null if the forest has a ground, or all
/// trees stand at height 0 of the scene.
osgTreeWind::GroundPtr groundThroughFeet(const osgTreeWind::ForestDescription& forest);

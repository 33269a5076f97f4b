// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

/// A smooth ground through the feet of the trees of a forest, level beyond them: for one that has none, and
/// whose trees do not all stand at height 0 of the scene; else null.
osgTreeWind::GroundPtr groundThroughFeet(const osgTreeWind::ForestDescription& forest);

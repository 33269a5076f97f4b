// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>

namespace osgTreeWind {

/// What holds all wood and leaves of a tree at rest, from its foot up; world coordinates, metres.
struct TreeBox {
    glm::dvec3 low{0.0}, high{0.0};
};

TreeBox treeBox(const PlacedForest& forest, const PlacedTree& tree);

} // namespace osgTreeWind

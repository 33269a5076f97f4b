// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>

namespace osgTreeWind {

/// Forest inventory measures of a tree, metres. 0 or less: not given, and then as usual for the species in a
/// forest or in the open. In a forest, a height alone gives a slender trunk.
struct TreeSize {
    float height = 0.0f;        ///< Ground to the highest point of wood or leaves, at most 150.
    float trunkDiameter = 0.0f; ///< At breastHeight(), at most 20.
    float crownWidth = 0.0f;    ///< Mean of the east-west and north-south extents, at most 150.
};

/// Height at which trunks are measured: 1.3 m, or a tenth of the tree's height if that is lower.
inline float breastHeight(float height) {
    return std::min(1.3f, 0.1f * height);
}

/// Which sizes of a TreeSize are estimates from the growth laws of its species.
struct EstimatedSizes {
    bool height = false;        ///< TreeSize::height
    bool trunkDiameter = false; ///< TreeSize::trunkDiameter
    bool crownWidth = false;    ///< TreeSize::crownWidth
};

/// Scale from a shared model to one tree: a rest point p of the centre line becomes axes * p, and radii and
/// leaf clusters are multiplied by factors.
struct TreeScale {
    glm::vec3 axes{1.0f}; ///< On positions along x, y and z.
    float radius = 1.0f;  ///< On radii of wood.
    float leaf = 1.0f;    ///< On the size of leaf clusters.
};

} // namespace osgTreeWind

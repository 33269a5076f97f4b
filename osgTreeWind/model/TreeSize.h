// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>

namespace osgTreeWind {

/// What a forester measures, in metres. 0 and less means "not given".
struct TreeSize {
    float height = 0.0f;        ///< Ground to the highest point of wood or leaves, at most 150.
    float trunkDiameter = 0.0f; ///< At breastHeight(), at most 20.
    float crownWidth = 0.0f;    ///< Mean of the east-west and north-south extents, at most 150.
};

/// Where trunks are measured, of a tree of that height: 1.3 m, or a tenth of the height if that is lower.
inline float breastHeight(float height) {
    return std::min(1.3f, 0.1f * height);
}

/// Which measures of a TreeSize nobody took: they follow from laws of its species.
struct EstimatedSizes {
    bool height = false;        ///< Metres were not given,
    bool trunkDiameter = false; ///< nor these,
    bool crownWidth = false;    ///< nor these.
};

/// How a shared model is stretched to one tree: a rest point p of the centre line becomes axes * p, radii are
/// multiplied by `radius`, leaf clusters by `leaf`.
struct TreeScale {
    glm::vec3 axes{1.0f}; ///< Of positions along x, y and z.
    float radius = 1.0f;  ///< Of radii of wood.
    float leaf = 1.0f;    ///< Of leaf clusters.
};

} // namespace osgTreeWind

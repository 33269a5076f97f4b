// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgTreeWind {

/// How the foliage of a species gives way to a wind under the law `modal` (shaders/law/reconfiguration.glsl,
/// which the pose pass and vertex shaders share).
struct Reconfiguration {
    float streamlining = 0.0f;       ///< WoodParameters', within [0, 2],
    float breezeStreamlining = 0.0f; ///< [0, 2],
    float streamlinedTo = 25.0f;     ///< and m/s, [10, 200].
    float mostPull = 0.0f;           ///< Tangent of LeafMotion::maxDownwind.

    Reconfiguration() = default;
    /// Within the ranges of WoodParameters and LeafMotion, whatever it says.
    explicit Reconfiguration(const Species& species);

    /// Toward where a wind draws petioles, in its axes, and how wide blades stay open, (0, 1].
    /// @param wind m/s; what is no wind on earth counts as one of 200 m/s, what is no number as calm.
    glm::vec4 pull(const glm::vec3& wind) const;
    /// Of foliage by the wind's pressure, over that in a calm, (0, 1].
    float drag(float speed) const;
};

/// Of a calm, and on bare twigs.
constexpr glm::vec4 noPull{0.0f, 0.0f, 0.0f, 1.0f};

/// Turn of a leaf cluster from the leaf frame to the tree's rest axes as it flutters and is drawn downwind.
/// @param orientation LeafCluster's. @param state of TreeMotion::leaves. @param pull of TreeMotion::pulls.
glm::quat drawnLeafTurn(const glm::quat& orientation, const glm::vec4& state, const glm::vec4& pull);

/// A corner of a cluster, in the leaf frame, once its blades have closed. @param pull of TreeMotion::pulls.
inline glm::vec3 closedCorner(const glm::vec3& corner, const glm::vec4& pull) {
    return {pull.w * corner.x, pull.w * corner.y, corner.z};
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgTreeWind {

/// Reconfiguration of a species' foliage in wind under the law `modal`: drag reduction, and leaves that turn
/// downwind and close (shaders/law/reconfiguration.glsl, shared with the pose pass and the vertex shaders).
struct Reconfiguration {
    float streamlining = 0.0f;       ///< WoodParameters::streamlining, [0, 2].
    float breezeStreamlining = 0.0f; ///< [0, 2]
    float streamlinedTo = 25.0f;     ///< m/s, [10, 200].
    float maxPull = 0.0f;            ///< Tangent of LeafMotion::maxDownwind.

    Reconfiguration() = default;
    /// Clamps the species' parameters to the ranges of WoodParameters and LeafMotion.
    explicit Reconfiguration(const Species& species);

    /// xyz: pull on petioles in the axes of `wind`. w: how far blades stay open, (0, 1].
    /// @param wind m/s; speeds above 200 m/s count as 200 m/s, NaN as calm.
    glm::vec4 pull(const glm::vec3& wind) const;
    /// Drag of foliage per dynamic pressure, relative to that in calm, (0, 1]. @param speed m/s.
    float dragRatio(float speed) const;
};

/// pull() in calm, and for units without leaves.
constexpr glm::vec4 noPull{0.0f, 0.0f, 0.0f, 1.0f};

/// Rotation of a leaf cluster from the leaf frame to the tree's rest axes, with flutter and downwind turn.
/// @param orientation LeafCluster::orientation. @param state from TreeMotion::leaves. @param pull from
/// TreeMotion::pulls.
glm::quat downwindLeafTurn(const glm::quat& orientation, const glm::vec4& state, const glm::vec4& pull);

/// A corner of a cluster in the leaf frame, after its blades have closed. @param pull from TreeMotion::pulls.
inline glm::vec3 closedCorner(const glm::vec3& corner, const glm::vec4& pull) {
    return {pull.w * corner.x, pull.w * corner.y, corner.z};
}

} // namespace osgTreeWind

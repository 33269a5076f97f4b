// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Span.h>
#include <osgTreeWind/model/LeafClusters.h>
#include <osgTreeWind/species/Species.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace osgTreeWind {

// How leaves flutter under the law `modal`: a function of time and of the wind that nothing is kept for
// (shaders/law/flutter.glsl, which vertex shaders share).

/// What the seed of a tree gives it of its own: colours and phases of its leaves, [0, 1).
float ownNumber(std::uint32_t seed);

/// Time in periods of a species' leaves, three of them that never meet, each wrapped to [0, 1): as exact
/// after months as at once. @param time seconds; what is not finite counts as 0.
glm::vec3 flutterPhases(double time, const LeafMotion& motion);

/// How far they turn: maxAngleX, maxAngleZ, maxRotation (radians), linkedFactor. Within the ranges of
/// LeafMotion, whatever it says.
glm::vec4 flutterLimits(const LeafMotion& motion);

/// How single leaves move within their cluster: their size, m, and the stiffness that trembleShare() takes,
/// (m/s)^2.
glm::vec2 leafTremble(const LeafMotion& motion);

/// The leaves of one tree as they stand in a wind.
struct StatelessFlutter {
    Span<LeafCluster> leaves;
    glm::vec3 axes{1.0f};   ///< TreeScale's.
    Span<glm::vec3> winds;  ///< Per unit, m/s.
    Span<glm::vec4> pulls;  ///< TreeMotion's.
    glm::vec3 phases{0.0f}; ///< flutterPhases().
    glm::vec4 limits{0.0f}; ///< flutterLimits().
    float own = 0.0f;       ///< ownNumber().

    /// @param states per cluster: TreeMotion::leaves.
    void run(glm::vec4* states) const;
};

} // namespace osgTreeWind

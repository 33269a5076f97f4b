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

// Flutter of leaves under the law `modal`, as a stateless function of time and wind
// (shaders/law/flutter.glsl, shared with the vertex shaders).

/// Random number of a tree, [0, 1), for the colours and phases of its leaves.
float treeRandom(std::uint32_t seed);

/// Time in periods of a species' leaves, for three incommensurate frequencies, each wrapped to [0, 1).
/// Precision does not degrade with time. @param time seconds; a value that is not finite counts as 0.
glm::vec3 flutterPhases(double time, const LeafMotion& motion);

/// Amplitudes of flutter: maxAngleX, maxAngleZ, maxRotation (radians), linkedFactor; clamped as LeafMotion
/// is.
glm::vec4 flutterLimits(const LeafMotion& motion);

/// Motion of single leaves within their cluster: leaf size, m, and the stiffness for trembleShare(), (m/s)^2.
glm::vec2 leafTremble(const LeafMotion& motion);

/// Computes the flutter of one tree's leaves.
struct StatelessFlutter {
    Span<LeafCluster> leaves;
    glm::vec3 axes{1.0f};   ///< TreeScale::axes.
    Span<glm::vec3> winds;  ///< Per unit, m/s.
    Span<glm::vec4> pulls;  ///< TreeMotion::pulls.
    glm::vec3 phases{0.0f}; ///< flutterPhases().
    glm::vec4 limits{0.0f}; ///< flutterLimits().
    float own = 0.0f;       ///< treeRandom().

    /// @param states written per cluster: TreeMotion::leaves.
    void run(glm::vec4* states) const;
};

} // namespace osgTreeWind

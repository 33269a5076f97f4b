// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Span.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace osgTreeWind {

/// Pose of a branch unit: a rest point p of the scaled tree moves to rotation * p + translation, in the
/// tree's own frame (metres, Z up).
struct UnitPose {
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< About the origin of the tree's frame.
    glm::vec3 translation{0.0f};                ///< After the rotation, metres.

    glm::vec3 apply(const glm::vec3& p) const {
        return rotation * p + translation;
    } ///< Where a point at rest is now.
};

/// Present state of one tree. Units run in access order.
struct TreeMotion {
    Span<UnitPose> poses;      ///< Per unit, in the tree's frame.
    Span<glm::quat> rotations; ///< Per unit: rotation about its base, in the tree's rest axes.
    /// Per unit: (angleXY, angleYZ, wind.x, wind.z) in the thesis axes of the tree's own frame; under
    /// `modal`, (angle, angle, 0, 0) about the two axes of the branch. Radians, m/s.
    Span<glm::vec4> states;
    Span<glm::vec3> winds; ///< Per unit: the last wind at the unit, scene axes, m/s.
    /// Per leaf cluster: (motionAngleX, motionAngleZ, totalRotaAngle, noise) in the leaf's own frame; under
    /// `modal`, the last one is a factor on the pull.
    Span<glm::vec4> leaves;
    /// Per unit, under `modal` only: pull of the wind on its leaf clusters, in the unit's rest axes
    /// (Reconfiguration::pull()).
    Span<glm::vec4> pulls;
};

/// Present state of one unit; see TreeMotion.
struct UnitMotion {
    UnitPose pose;                              ///< In the tree's frame.
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< About its base, in the tree's rest axes.
};

/// Memory for the values of one tree, as in TreeMotion.
struct UnitValues {
    std::vector<glm::vec2> angles;    ///< Per unit, about the two axes of the branch (law `modal`), radians.
    std::vector<UnitPose> poses;      ///< TreeMotion::poses
    std::vector<glm::quat> rotations; ///< TreeMotion::rotations
    std::vector<glm::vec4> states;    ///< TreeMotion::states
    std::vector<glm::vec3> winds;     ///< TreeMotion::winds
    std::vector<glm::vec4> leaves;    ///< TreeMotion::leaves
    std::vector<glm::vec4> pulls;     ///< TreeMotion::pulls
    /// Resizes all arrays.
    void resize(std::size_t units, std::size_t clusters) {
        angles.resize(units);
        poses.resize(units);
        rotations.resize(units);
        states.resize(units);
        winds.resize(units);
        leaves.resize(clusters);
        pulls.resize(units);
    }
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Span.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace osgTreeWind {

/// Where a branch unit stands: a rest point p of the scaled tree is drawn at rotation * p + translation,
/// in the tree's own frame (metres, Z up).
struct UnitPose {
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< About the origin,
    glm::vec3 translation{0.0f};                ///< and then this far, metres.

    glm::vec3 apply(const glm::vec3& p) const {
        return rotation * p + translation;
    } ///< Where a point at rest is now.
};

/// One tree as it stands now. Values run in access order.
struct TreeMotion {
    Span<UnitPose> poses;      ///< Per unit, in the tree's frame.
    Span<glm::quat> rotations; ///< Per unit: its own turn about its base, in the tree's rest axes.
    /// Per unit: (angleXY, angleYZ, wind.x, wind.z), thesis axes of the tree's own frame; for the law
    /// `modal` the angles about both axes of the branch, radians, 0, 0.
    Span<glm::vec4> states;
    Span<glm::vec3> winds; ///< Per unit: the wind that it was given last, scene axes, m/s.
    /// Per leaf cluster: (motionAngleX, motionAngleZ, totalRotaAngle, noise), in the leaf's own frame; for
    /// `modal` the last is a factor on the pull.
    Span<glm::vec4> leaves;
    /// Per unit, for `modal` alone: what the wind does to its leaf clusters, in its rest axes
    /// (Reconfiguration::pull()).
    Span<glm::vec4> pulls;
};

/// One unit as it stands now: a pose and a rotation of TreeMotion.
struct UnitMotion {
    UnitPose pose;                              ///< In the tree's frame.
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< Its own turn about its base, in the tree's rest axes.
};

/// Memory for the values of one tree.
struct UnitValues {
    std::vector<glm::vec2> angles;    ///< Per unit: those of the thesis, radians.
    std::vector<UnitPose> poses;      ///< As TreeMotion::poses,
    std::vector<glm::quat> rotations; ///< rotations,
    std::vector<glm::vec4> states;    ///< states,
    std::vector<glm::vec3> winds;     ///< winds,
    std::vector<glm::vec4> leaves;    ///< leaves
    std::vector<glm::vec4> pulls;     ///< and pulls.

    /// Room for so many.
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

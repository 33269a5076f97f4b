// SPDX-License-Identifier: MIT
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgTreeWind {

/// Rotation of a branch about its base, in the tree's rest axes (shaders/law/rotation.glsl).
/// @param state from TreeMotion::states.
glm::quat branchRotation(const glm::vec4& state);

/// Rotation of a branch under the law `modal`. @param angles about the two axes of the branch, radians.
/// @param direction from base to tip of the scaled unit at rest, unit length.
glm::quat swungRotation(const glm::vec2& angles, const glm::vec3& direction);

/// Where that rotation turns the tip of the branch, across it, in the tree's rest axes. Its length is the
/// angle, radians.
glm::vec3 swing(const glm::vec2& angles, const glm::vec3& direction);

/// Rotation of a leaf cluster in its own frame. A corner of the leaf mesh is drawn, before the pose of its
/// branch, at scaled anchor + size * (orientation * (leafRotation * corner)). @param state from
/// TreeMotion::leaves.
glm::quat leafRotation(const glm::vec4& state);

} // namespace osgTreeWind

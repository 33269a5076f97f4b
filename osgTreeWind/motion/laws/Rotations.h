// SPDX-License-Identifier: MIT
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgTreeWind {

/// Turn of a branch about its base, in the tree's rest axes (shaders/law/rotation.glsl).
/// @param state of TreeMotion::states.
glm::quat branchRotation(const glm::vec4& state);

/// The same for the law `modal`: from the angles about the two axes of the branch.
/// @param direction base to tip of the scaled unit at rest, unit length.
glm::quat swungRotation(const glm::vec2& angles, const glm::vec3& direction);

/// Turn of a leaf cluster in its own frame: a corner of the leaf mesh is drawn, before the pose of its
/// branch, at scaled anchor + size * (orientation * (leafRotation * corner)).
/// @param state of TreeMotion::leaves.
glm::quat leafRotation(const glm::vec4& state);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgTreeWind {

/// Turn of a branch about its base, in the tree's rest axes (shaders/law/rotation.glsl).
/// @param state of TreeMotion::states.
glm::quat branchRotation(const glm::vec4& state);

/// The same for the law `damped`.
/// @param direction base to tip of the scaled unit at rest, unit length.
glm::quat dampedRotation(const glm::vec4& state, const glm::vec3& direction);

/// Turn of a leaf cluster in its own frame: a corner of the leaf mesh is drawn, before the pose of its
/// branch, at scaled anchor + size * (orientation * (leafRotation * corner)).
/// @param state of TreeMotion::leaves.
glm::quat leafRotation(const glm::vec4& state);

} // namespace osgTreeWind

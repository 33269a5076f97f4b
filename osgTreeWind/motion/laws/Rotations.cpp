// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/Rotations.h>

#include <osgTreeWind/motion/laws/Laws.h>

namespace osgTreeWind {

namespace {

glm::quat asQuat(const glm::vec4& q) {
    return glm::quat(q.w, q.x, q.y, q.z);
}

} // namespace

glm::quat branchRotation(const glm::vec4& state) {
    return asQuat(Laws().branchRotation(state.x, state.y));
}

glm::quat swungRotation(const glm::vec2& angles, const glm::vec3& direction) {
    return asQuat(Laws().swungRotation(angles.x, angles.y, direction));
}

glm::vec3 swing(const glm::vec2& angles, const glm::vec3& direction) {
    return angles.x * Laws().branchAxis1(direction) + angles.y * Laws().branchAxis3(direction);
}

glm::quat leafRotation(const glm::vec4& state) {
    return asQuat(Laws().leafRotation(state.x, state.y, state.z));
}

} // namespace osgTreeWind

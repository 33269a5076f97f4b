// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/DataTransform.h>

#include <osgTreeWind/wind/WindLimits.h>

#include <glm/common.hpp>

namespace osgTreeWind {

namespace {

glm::dvec2 onMap(const WindPlace& place, const glm::dvec2& origin) {
    return origin + glm::clamp(glm::dvec2(place.position), -maxCoordinate, maxCoordinate);
}

} // namespace

WindPlace DataTransform::toData(const WindPlace& place) const {
    WindPlace moved = place;
    const glm::dvec2 at = mesh->transformed(onMap(place, origin)) - dataOrigin;
    moved.position.x = static_cast<float>(at.x);
    moved.position.y = static_cast<float>(at.y);
    return moved;
}

glm::vec3 DataTransform::toScene(const WindPlace& place, const glm::vec3& velocity) const {
    const glm::vec2 north(mesh->north(onMap(place, origin)));
    return {velocity.x * north.y + velocity.y * north.x, velocity.y * north.y - velocity.x * north.x,
            velocity.z};
}

} // namespace osgTreeWind

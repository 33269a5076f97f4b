// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/MappedWind.h>

#include <osgTreeWind/wind/SampleElsewhere.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <glm/common.hpp>

#include <utility>

namespace osgTreeWind {

namespace {

glm::dvec2 onMap(const WindPlace& place, const glm::dvec2& origin) {
    return origin + glm::clamp(glm::dvec2(place.position), -maxCoordinate, maxCoordinate);
}

} // namespace

MappedWind::MappedWind(WindFieldPtr wind, std::shared_ptr<const CrsMesh> mesh, const glm::dvec2& origin,
                       const glm::dvec2& itsOrigin)
    : _wind(std::move(wind)), _mesh(std::move(mesh)), _origin(origin), _itsOrigin(itsOrigin) {}

WindPlace MappedWind::there(const WindPlace& place) const {
    WindPlace moved = place;
    const glm::dvec2 at = _mesh->there(onMap(place, _origin)) - _itsOrigin;
    moved.position.x = static_cast<float>(at.x);
    moved.position.y = static_cast<float>(at.y);
    return moved;
}

glm::vec3 MappedWind::turned(const WindPlace& place, const glm::vec3& velocity) const {
    const glm::vec2 north(_mesh->north(onMap(place, _origin)));
    return {velocity.x * north.y + velocity.y * north.x, velocity.y * north.y - velocity.x * north.x,
            velocity.z};
}

glm::vec3 MappedWind::velocity(const WindPlace& place, double time) const {
    return turned(place, _wind->velocity(there(place), time));
}

void MappedWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    sampleElsewhere(
        *_wind, places, count, time, out, [&](const WindPlace& place) { return there(place); },
        [&](const glm::vec3& v, const WindPlace& place) { return turned(place, v); });
}

} // namespace osgTreeWind

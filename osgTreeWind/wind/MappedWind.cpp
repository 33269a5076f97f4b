// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/MappedWind.h>

#include <glm/common.hpp>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t placesAtOnce = 64;

glm::dvec2 onMap(const WindPlace& place, const glm::dvec2& origin) {
    constexpr double farthest = 1e9; // metres
    return origin + glm::clamp(glm::dvec2(place.position), -farthest, farthest);
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
    WindPlace moved[placesAtOnce];
    for (std::size_t first = 0; first < count; first += placesAtOnce) {
        const std::size_t some = std::min(placesAtOnce, count - first);
        std::transform(places + first, places + first + some, moved,
                       [&](const WindPlace& place) { return there(place); });
        _wind->sample(moved, some, time, out + first);
        std::transform(out + first, out + first + some, places + first, out + first,
                       [&](const glm::vec3& v, const WindPlace& place) { return turned(place, v); });
    }
}

} // namespace osgTreeWind

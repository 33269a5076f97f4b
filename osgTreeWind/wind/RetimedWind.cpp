// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/RetimedWind.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <utility>

namespace osgTreeWind {

RetimedWind::RetimedWind(WindFieldPtr inner, double start, double scale)
    : _inner(inner ? std::move(inner) : std::make_shared<UniformWind>(glm::vec3(0.0f))), _start(start),
      _scale(scale) {}

glm::vec3 RetimedWind::velocity(const glm::vec3& position, double time) const {
    return _inner->velocity(position, _start + _scale * time);
}

void RetimedWind::sample(const glm::vec3* positions, std::size_t count, double time, glm::vec3* out) const {
    _inner->sample(positions, count, _start + _scale * time, out);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/AdjustedWind.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

double held(double value, double low, double high, double otherwise) {
    return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

} // namespace

AdjustedWind::AdjustedWind(WindFieldPtr inner, const Adjustment& adjustment)
    : _inner(inner ? std::move(inner) : std::make_shared<UniformWind>(glm::vec3(0.0f))),
      _adjustment(adjustment) {
    if (const auto adjusted = std::dynamic_pointer_cast<const AdjustedWind>(_inner)) {
        _inner = adjusted->_inner;
        _adjustment.strength *= adjusted->_adjustment.strength;
        _adjustment.turn = std::fmod(_adjustment.turn + adjusted->_adjustment.turn, 360.0);
    }
    _adjustment = {held(_adjustment.strength, 0.0, 10.0, 1.0), held(_adjustment.turn, -360.0, 360.0, 0.0)};
    const double angle = glm::radians(_adjustment.turn);
    const auto along = static_cast<float>(_adjustment.strength * std::cos(angle)),
               right = static_cast<float>(_adjustment.strength * std::sin(angle)),
               up = static_cast<float>(_adjustment.strength);
    _adjust = {{along, -right, 0.0f}, {right, along, 0.0f}, {0.0f, 0.0f, up}};
}

glm::vec3 AdjustedWind::velocity(const WindPlace& place, double time) const {
    return _adjust * _inner->velocity(place, time);
}

void AdjustedWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    _inner->sample(places, count, time, out);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = _adjust * out[i];
}

WindFieldPtr AdjustedWind::withoutGusts() const {
    WindFieldPtr inner = _inner->withoutGusts();
    return inner ? std::make_shared<AdjustedWind>(std::move(inner), _adjustment) : nullptr;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/MovedWind.h>

#include <osgTreeWind/wind/SampleElsewhere.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <utility>

namespace osgTreeWind {

namespace {

/// The matrix without scale and shear; the identity where that has no answer.
glm::dmat3 rotationOf(const glm::dmat4& matrix) {
    const glm::dvec3 z(matrix[2]), x = glm::dvec3(matrix[0]);
    const glm::dvec3 y = glm::cross(z, x);
    if (!(glm::length(y) > 0.0))
        return glm::dmat3(1.0);
    const glm::dvec3 up = glm::normalize(z), north = glm::normalize(y);
    return {glm::cross(north, up), north, up};
}

} // namespace

MovedWind::MovedWind(WindFieldPtr world, const glm::dmat4& frameToWorld, Up up)
    : _world(world ? std::move(world) : std::make_shared<UniformWind>(glm::vec3(0.0f))),
      _frameToWorld(frameToWorld), _turnBack(glm::transpose(rotationOf(frameToWorld))), _up(up) {
    const auto moved = std::dynamic_pointer_cast<const MovedWind>(_world);
    if (moved && moved->_up == up) {
        _world = moved->_world;
        _frameToWorld = moved->_frameToWorld * _frameToWorld;
        _turnBack = _turnBack * moved->_turnBack;
    }
    _rise = _up == Up::OfTheWorld ? _frameToWorld[2].z : glm::length(glm::dvec3(_frameToWorld[2]));
}

MovedWind::MovedWind(const MovedWind& moved, WindFieldPtr ofFrame)
    : _world(std::move(ofFrame)), _frameToWorld(glm::inverse(moved._frameToWorld)),
      _turnBack(glm::transpose(moved._turnBack)), _up(moved._up),
      _rise(moved._rise != 0.0 ? 1.0 / moved._rise : 0.0) {}

WindPlace MovedWind::inWorld(const WindPlace& place) const {
    const glm::dvec3 at(place.position);
    const glm::dvec3 position(_frameToWorld * glm::dvec4(at, 1.0));
    WindPlace moved = place;
    moved.position = glm::vec3(position);
    moved.height = static_cast<float>(_rise * static_cast<double>(place.height));
    return moved;
}

glm::vec3 MovedWind::velocity(const WindPlace& place, double time) const {
    return glm::vec3(_turnBack * glm::dvec3(_world->velocity(inWorld(place), time)));
}

void MovedWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    sampleElsewhere(
        *_world, places, count, time, out, [&](const WindPlace& place) { return inWorld(place); },
        [&](const glm::vec3& v, const WindPlace&) { return glm::vec3(_turnBack * glm::dvec3(v)); });
}

WindFieldPtr MovedWind::withoutGusts() const {
    WindFieldPtr world = _world->withoutGusts();
    return world ? std::make_shared<MovedWind>(std::move(world), _frameToWorld, _up) : nullptr;
}

WindFieldPtr MovedWind::changedBesideSources(const WindChange& change) const {
    WindFieldPtr world = _world->changedBesideSources([&](const WindFieldPtr& open) -> WindFieldPtr {
        const WindFieldPtr changed = change(std::make_shared<MovedWind>(open, _frameToWorld, _up));
        return changed ? WindFieldPtr(new MovedWind(*this, changed)) : nullptr;
    });
    return world ? std::make_shared<MovedWind>(std::move(world), _frameToWorld, _up) : nullptr;
}

} // namespace osgTreeWind

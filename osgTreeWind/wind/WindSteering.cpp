// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindSteering.h>

#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindFiles.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr LogProfile overShortGrass{10.0, openCountryRoughness};

/// The uniform wind that a synthetic wind has; null for another wind and a calm.
const UniformWind* uniformOf(const Wind& wind) {
    return dynamic_cast<const UniformWind*>(wind.field.get());
}

} // namespace

void WindSteering::strengthen(double metresPerSecond) {
    speed = std::clamp(speed + metresPerSecond, 0.0, maxSpeed);
    strength = std::clamp(0.01 * std::round(100.0 * strength + 10.0 * metresPerSecond), 0.0, maxStrength);
}

void WindSteering::turnClockwise(double degrees) {
    from = std::fmod(from + degrees + 720.0, 360.0);
    turn = std::fmod(turn + degrees, 360.0);
}

void WindSteering::changeGustiness(double by) {
    gustiness = std::clamp(gustiness + by, 0.0, 1.0);
}

WindSteering steeringOf(const Wind& wind) {
    WindSteering steering;
    if (!wind.field)
        return steering;
    steering.gustiness = wind.gusts.intensity;
    const UniformWind* const uniform = uniformOf(wind);
    steering.isSynthetic = uniform && !mapOf(wind) && wind.clock.isIdentity() && wind.adjustment.isIdentity();
    if (steering.isSynthetic) {
        const WindReading reading = windReading(uniform->velocity(), DirectionSense::From);
        steering.speed = reading.speed;
        steering.from = glm::degrees(reading.direction);
    } else {
        steering.strength = wind.adjustment.strength;
        steering.turn = glm::degrees(static_cast<double>(wind.adjustment.turn));
    }
    return steering;
}

Wind steered(Wind like, const WindSteering& steering) {
    like.gusts.intensity = steering.gustiness;
    if (!steering.isSynthetic) {
        like.adjustment = {steering.strength, static_cast<float>(glm::radians(steering.turn))};
    } else if (steering.speed > 0.0) {
        const UniformWind* const before = uniformOf(like);
        like.field = std::make_shared<UniformWind>(
            windVelocity({steering.speed, glm::radians(steering.from)}, DirectionSense::From),
            before ? before->profile() : overShortGrass);
    } else {
        like.field = nullptr;
    }
    return like;
}

} // namespace osgTreeWind

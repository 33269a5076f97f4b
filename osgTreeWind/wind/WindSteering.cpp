// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindSteering.h>

#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindFiles.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace osgTreeWind {

namespace {

constexpr LogProfile overShortGrass{10.0, 0.03}; // Wieringa 1993

WindSteering steeringOf(const glm::vec3& mean, double gustiness) {
    const WindReading reading = windReading(mean, DirectionSense::From);
    WindSteering steering;
    steering.speed = reading.speed;
    steering.from = glm::degrees(reading.direction);
    steering.gustiness = gustiness;
    return steering;
}

/// The steering of a synthetic field; empty for other fields.
std::optional<WindSteering> syntheticSteering(const WindField& field) {
    if (const auto* uniform = dynamic_cast<const UniformWind*>(&field))
        return steeringOf(uniform->velocity(), 0.0);
    if (const auto* gusts = dynamic_cast<const GustWind*>(&field))
        return steeringOf(gusts->parameters().mean, gusts->parameters().intensity);
    return {};
}

WindFieldPtr steerSynthetic(const WindFieldPtr& like, const WindSteering& steering) {
    if (!(steering.speed > 0.0))
        return nullptr;
    GustWind::Parameters gusts;
    if (!like)
        gusts.profile = overShortGrass;
    else if (const auto* before = dynamic_cast<const GustWind*>(like.get()))
        gusts = before->parameters();
    gusts.mean = windVelocity({steering.speed, glm::radians(steering.from)}, DirectionSense::From);
    gusts.intensity = steering.gustiness;
    if (like && gusts.intensity == 0.0 && dynamic_cast<const UniformWind*>(like.get()))
        return std::make_shared<UniformWind>(gusts.mean);
    return GustWind::create(gusts).value();
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
    if (!wind.field)
        return {};
    const bool isUnmodified = !mapOf(wind) && wind.clock.isIdentity() && wind.adjustment.isIdentity();
    if (const auto steering = isUnmodified ? syntheticSteering(*wind.field) : std::nullopt)
        return *steering;
    WindSteering steering;
    steering.isSynthetic = false;
    steering.strength = wind.adjustment.strength;
    steering.turn = glm::degrees(static_cast<double>(wind.adjustment.turn));
    return steering;
}

Wind steered(Wind like, const WindSteering& steering) {
    if (steering.isSynthetic)
        like.field = steerSynthetic(like.field, steering);
    else
        like.adjustment = {steering.strength, static_cast<float>(glm::radians(steering.turn))};
    return like;
}

} // namespace osgTreeWind

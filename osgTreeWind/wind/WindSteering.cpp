// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindSteering.h>

#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindInternals.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace osgTreeWind {

namespace {

constexpr LogProfile overShortGrass{10.0, 0.03}; // Wieringa 1993

WindSteering steeringOf(const glm::vec3& mean, double gustiness) {
    const WindReading reading = windReading(mean, DirectionSense::From);
    WindSteering steering;
    steering.speed = reading.speed;
    steering.from = reading.direction;
    steering.gustiness = gustiness;
    return steering;
}

/// Visitor: the steering of a synthetic field; empty for other fields.
struct SyntheticSteering {
    std::optional<WindSteering> operator()(const UniformWind* wind) const {
        return steeringOf(wind->velocity(), 0.0);
    }
    std::optional<WindSteering> operator()(const GustWind* wind) const {
        return steeringOf(wind->parameters().mean, wind->parameters().intensity);
    }
    template <typename Other>
    std::optional<WindSteering> operator()(const Other*) const {
        return {};
    }
};

WindFieldPtr steerSynthetic(const WindFieldPtr& like, const WindSteering& steering) {
    if (!(steering.speed > 0.0))
        return nullptr;
    GustWind::Parameters gusts;
    if (!like)
        gusts.profile = overShortGrass;
    else if (const KindOfWind kind = like->kind(); const auto* before = std::get_if<const GustWind*>(&kind))
        gusts = (*before)->parameters();
    gusts.mean = windVelocity({steering.speed, steering.from}, DirectionSense::From);
    gusts.intensity = steering.gustiness;
    if (like && gusts.intensity == 0.0 && std::holds_alternative<const UniformWind*>(like->kind()))
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
    const bool isUnmodified =
        !WindInternals::map(wind) && wind.clock.isIdentity() && wind.adjustment.isIdentity();
    if (const auto steering =
            isUnmodified ? std::visit(SyntheticSteering(), wind.field->kind()) : std::nullopt)
        return *steering;
    WindSteering steering;
    steering.isSynthetic = false;
    steering.strength = wind.adjustment.strength;
    steering.turn = wind.adjustment.turn;
    return steering;
}

Wind steered(Wind like, const WindSteering& steering) {
    if (steering.isSynthetic)
        like.field = steerSynthetic(like.field, steering);
    else
        like.adjustment = {steering.strength, steering.turn};
    return like;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindSteering.h>

#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindParts.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace osgTreeWind {

namespace {

constexpr LogProfile overShortGrass{10.0, 0.03}; // Wieringa 1993

WindSteering madeUp(const glm::vec3& mean, double gustiness) {
    const WindReading reading = windReading(mean, DirectionSense::From);
    WindSteering steering;
    steering.speed = reading.speed;
    steering.from = reading.direction;
    steering.gustiness = gustiness;
    return steering;
}

/// Mean speed and gusts of a field that is made up of them; nothing where it is not.
struct MadeUp {
    std::optional<WindSteering> operator()(const UniformWind* wind) const {
        return madeUp(wind->velocity(), 0.0);
    }
    std::optional<WindSteering> operator()(const GustWind* wind) const {
        return madeUp(wind->parameters().mean, wind->parameters().intensity);
    }
    template <typename Other>
    std::optional<WindSteering> operator()(const Other*) const {
        return {};
    }
};

WindFieldPtr madeUpLike(const WindFieldPtr& like, const WindSteering& steering) {
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
    speed = std::clamp(speed + metresPerSecond, 0.0, fastest);
    strength = std::clamp(0.01 * std::round(100.0 * strength + 10.0 * metresPerSecond), 0.0, strongest);
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
    const bool isAsMade = !WindParts::map(wind) && wind.clock.isNone() && wind.adjustment.isNone();
    if (const auto steering = isAsMade ? std::visit(MadeUp(), wind.field->kind()) : std::nullopt)
        return *steering;
    WindSteering steering;
    steering.isMadeUp = false;
    steering.strength = wind.adjustment.strength;
    steering.turn = wind.adjustment.turn;
    return steering;
}

Wind steered(Wind like, const WindSteering& steering) {
    if (steering.isMadeUp)
        like.field = madeUpLike(like.field, steering);
    else
        like.adjustment = {steering.strength, steering.turn};
    return like;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindSteering.h>

#include <osgTreeWind/wind/AdjustedWind.h>
#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindWithSources.h>

#include <algorithm>
#include <cmath>

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

WindFieldPtr madeUpLike(const WindField* like, const WindSteering& steering) {
    if (!(steering.speed > 0.0))
        return nullptr;
    GustWind::Parameters gusts;
    if (const auto* before = dynamic_cast<const GustWind*>(like))
        gusts = before->parameters();
    else if (!like)
        gusts.profile = overShortGrass;
    gusts.mean = windVelocity({steering.speed, steering.from}, DirectionSense::From);
    gusts.intensity = steering.gustiness;
    if (dynamic_cast<const UniformWind*>(like) && gusts.intensity == 0.0)
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

WindSteering steeringOf(const WindFieldPtr& wind) {
    WindSteering steering;
    if (!wind)
        return steering;
    if (const auto* sourced = dynamic_cast<const WindWithSources*>(wind.get()))
        return steeringOf(sourced->wind());
    if (const auto* gusts = dynamic_cast<const GustWind*>(wind.get()))
        return madeUp(gusts->parameters().mean, gusts->parameters().intensity);
    if (const auto* uniform = dynamic_cast<const UniformWind*>(wind.get()))
        return madeUp(uniform->velocity(), 0.0);
    steering.isMadeUp = false;
    if (const auto* adjusted = dynamic_cast<const AdjustedWind*>(wind.get())) {
        steering.strength = adjusted->adjustment().strength;
        steering.turn = adjusted->adjustment().turn;
    }
    return steering;
}

WindFieldPtr steered(const WindFieldPtr& like, const WindSteering& steering) {
    if (const auto* sourced = dynamic_cast<const WindWithSources*>(like.get()))
        return std::make_shared<WindWithSources>(steered(sourced->wind(), steering), sourced->sources());
    if (steering.isMadeUp)
        return madeUpLike(like.get(), steering);
    const auto* adjusted = dynamic_cast<const AdjustedWind*>(like.get());
    return std::make_shared<AdjustedWind>(adjusted ? adjusted->inner() : like,
                                          AdjustedWind::Adjustment{steering.strength, steering.turn});
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GustyWind.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/HorizontalWind.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

/// The terrain where the wind has this intensity: 1 / ln(z / z0) (EN 1991-1-4). Above 0 for any intensity.
LogProfile terrainOf(double intensity) {
    return {10.0, 10.0 * math::exp(-1.0 / std::max(intensity, 0.01))};
}

/// Height below which the intensity is constant: 1, 2, 5 and 10 m for a roughness of 0.01, 0.05, 0.3 and 1 m
/// (EN 1991-1-4).
double lowestHeight(const LogProfile& terrain) {
    return std::min(std::max(10.0 * std::sqrt(terrain.roughness), 2.0 * terrain.roughness), terrain.height);
}

} // namespace

GustyWind::GustyWind(WindFieldPtr mean, WindFieldPtr turbulence, const WindGusts& given,
                     const std::optional<LogProfile>& profile, const WindClock& clock)
    : _mean(std::move(mean)), _turbulence(std::move(turbulence)), _clock(clock) {
    const WindGusts gusts = clampedKeys(given);
    const LogProfile terrain = profile.value_or(terrainOf(gusts.intensity));
    _logRoughness = static_cast<float>(math::log(terrain.roughness));
    _lowest = static_cast<float>(lowestHeight(terrain));
    _timesLog = static_cast<float>(gusts.intensity * math::log(terrain.height / terrain.roughness));
    _travel = hourlyMean(*_mean, static_cast<float>(terrain.height));
    _along = HorizontalWind(_travel).along;
    _noise.emplace(gusts.seed, gusts.lengthScale, _along,
                   gusts.intensity * static_cast<double>(glm::length(gustDeviations)));
}

void GustyWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    _mean->sample(places, count, time, out);
    const GustNoise::Advected noise =
        _noise->advected(_travel * clampedTime(_clock.at(_clock.origin, time), 1e12));
    for (std::size_t first = 0; first < count; first += GustNoise::blockSize) {
        const std::size_t size = std::min(count - first, GustNoise::blockSize);
        NoisePoint noises[GustNoise::blockSize];
        noise.sample(places + first, size, noises);
        glm::vec3 known[GustNoise::blockSize];
        if (_turbulence)
            _turbulence->sample(places + first, size, time, known);
        float intensity = 0.0f;
        glm::vec3 given(0.0f);
        HorizontalWind mean(given);
        for (std::size_t n = 0; n < size; ++n) {
            const float height = places[first + n].height;
            if (n == 0 || height != places[first + n - 1].height)
                intensity = _timesLog / (math::log(std::max(_lowest, height)) - _logRoughness);
            glm::vec3& wind = out[first + n];
            if (wind != given) {
                given = wind;
                mean = HorizontalWind(given);
            }
            const float deviation = _turbulence ? glm::length(known[n]) : intensity * mean.speed;
            const glm::vec3& along = _turbulence ? _along : mean.along;
            const float* u = noises[n].values;
            const glm::vec3 left(-along.y, along.x, 0.0f), up(0.0f, 0.0f, 1.0f);
            wind += deviation * (gustDeviations.x * u[0] * along + gustDeviations.y * u[1] * left +
                                 gustDeviations.z * u[2] * up);
        }
    }
}

} // namespace osgTreeWind

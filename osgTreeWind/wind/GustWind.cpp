// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GustWind.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/GustNoise.h>
#include <osgTreeWind/wind/WindKeys.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Deviations of the velocity along the wind, across it and upward over that along (IEC 61400-1, Kaimal).
constexpr glm::vec3 deviations(1.0f, 0.8f, 0.5f);

/// The terrain where the wind has this intensity: 1 / ln(z / z0) (EN 1991-1-4). Above 0 for any intensity.
LogProfile terrainOf(double intensity) {
    return {10.0, 10.0 * std::exp(-1.0 / std::max(intensity, 0.01))};
}

/// Height below which the intensity is constant: 1, 2, 5 and 10 m for a roughness of 0.01, 0.05, 0.3 and 1 m
/// (EN 1991-1-4).
double lowestHeight(const LogProfile& terrain) {
    return std::min(std::max(10.0 * std::sqrt(terrain.roughness), 2.0 * terrain.roughness), terrain.height);
}

} // namespace

Result<std::shared_ptr<const GustWind>> GustWind::create(const Parameters& parameters) {
    Diagnostics problems;
    const auto check = [&](const char* key, double value, double low, double high, const char* what) {
        if (!(value >= low && value <= high))
            problems.push_back(
                keyProblem(key, std::string("expected ") + what + ", found " + numberText(value)));
    };
    check("mean", glm::length(glm::dvec3(parameters.mean)), 0.0, maxMeasuredSpeed, "at most 200 m/s");
    check("mean", parameters.mean.z, 0.0, 0.0, "a horizontal wind");
    checkKeys(parameters, "", problems);
    if (parameters.profile && !parameters.profile->valid())
        problems.push_back(keyProblem("profile", "expected 0 < roughness < height in metres"));
    if (!problems.empty())
        return problems;
    return std::shared_ptr<const GustWind>(new GustWind(parameters));
}

GustWind::GustWind(const Parameters& parameters)
    : _parameters(parameters), _terrain(parameters.profile.value_or(terrainOf(parameters.intensity))),
      _lowestFactor(_terrain.factor(lowestHeight(_terrain))) {
    const float speed = glm::length(parameters.mean), intensity = static_cast<float>(parameters.intensity);
    const glm::vec3 along = speed > 0.0f ? parameters.mean / speed : glm::vec3(0.0f);
    const glm::vec3 spread = intensity * speed * deviations;
    _axes = {along * spread.x, glm::vec3(-along.y, along.x, 0.0f) * spread.y,
             glm::vec3(0.0f, 0.0f, spread.z)};
    _noise = std::make_shared<const GustNoise>(parameters.seed, parameters.lengthScale, along,
                                               intensity * glm::length(deviations));
}

glm::vec3 GustWind::velocity(const WindPlace& place, double time) const {
    glm::vec3 result;
    sample(&place, 1, time, &result);
    return result;
}

WindFieldPtr GustWind::withoutGusts() const {
    Parameters mean = _parameters;
    mean.intensity = 0.0;
    return std::shared_ptr<const GustWind>(new GustWind(mean));
}

void GustWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    const glm::dvec3 travelled = glm::dvec3(_parameters.mean) * clampedTime(time, 1e12);
    const GustNoise::Advected noise = _noise->advected(travelled);
    for (std::size_t first = 0; first < count; first += GustNoise::blockSize) {
        const std::size_t size = std::min(count - first, GustNoise::blockSize);
        NoisePoint turbulence[GustNoise::blockSize] = {};
        if (_parameters.intensity > 0.0)
            noise.sample(places + first, size, turbulence);
        float mean = 1.0f, gusts = 1.0f; // factors
        for (std::size_t n = 0; n < size; ++n) {
            const float* u = turbulence[n].values;
            const float height = places[first + n].height;
            if (n == 0 || height != places[first + n - 1].height) {
                const double factor = _terrain.factor(static_cast<double>(height));
                mean = _parameters.profile ? static_cast<float>(factor) : 1.0f;
                gusts = mean / static_cast<float>(std::max(factor, _lowestFactor));
            }
            out[first + n] = _parameters.mean * mean + _axes * glm::vec3(u[0], u[1], u[2]) * gusts;
        }
    }
}

} // namespace osgTreeWind

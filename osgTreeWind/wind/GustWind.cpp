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

namespace osgTreeWind {

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
    : _parameters(parameters),
      _noise(std::make_shared<const GustNoise>(parameters.seed, parameters.lengthScale)) {
    const float speed = glm::length(parameters.mean);
    const glm::vec3 along = speed > 0.0f ? parameters.mean / speed : glm::vec3(0.0f);
    const float deviation = static_cast<float>(parameters.intensity) * speed;
    _axes = {along * deviation, glm::vec3(-along.y, along.x, 0.0f) * (0.8f * deviation),
             glm::vec3(0.0f, 0.0f, 0.5f * deviation)};
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
        float factor = 1.0f;
        for (std::size_t n = 0; n < size; ++n) {
            const float* u = turbulence[n].values;
            const float height = places[first + n].height;
            if (_parameters.profile && (n == 0 || height != places[first + n - 1].height))
                factor = static_cast<float>(_parameters.profile->factor(static_cast<double>(height)));
            out[first + n] = (_parameters.mean + _axes * glm::vec3(u[0], u[1], u[2])) * factor;
        }
    }
}

} // namespace osgTreeWind

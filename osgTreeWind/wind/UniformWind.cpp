// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/UniformWind.h>

#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/LogFactor.h>

#include <algorithm>

namespace osgTreeWind {

UniformWind::UniformWind(const glm::vec3& velocity, const std::optional<LogProfile>& profile)
    : _velocity(calmUnlessFinite(velocity)), _profile(profile && profile->valid() ? profile : std::nullopt) {}

glm::vec3 UniformWind::velocity(const WindPlace& place, double time) const {
    glm::vec3 result;
    sample(&place, 1, time, &result);
    return result;
}

void UniformWind::sample(const WindPlace* places, std::size_t count, double, glm::vec3* out) const {
    if (!_profile) {
        std::fill_n(out, count, _velocity);
        return;
    }
    const LogFactor factor(*_profile);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = i > 0 && places[i].height == places[i - 1].height
                     ? out[i - 1]
                     : clampedVelocity(glm::dvec3(_velocity) * static_cast<double>(factor(places[i].height)));
}

} // namespace osgTreeWind

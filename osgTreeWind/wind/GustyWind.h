// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/GustNoise.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/WindClock.h>
#include <osgTreeWind/wind/WindGusts.h>
#include <osgTreeWind/wind/WindLayer.h>

#include <glm/vec3.hpp>

#include <optional>

namespace osgTreeWind {

/// Standard deviations of gusts along the wind, across it and upward over that along (IEC 61400-1, Kaimal).
constexpr glm::vec3 gustDeviations(1.0f, 0.8f, 0.5f);

/// Adds gusts to a mean wind.
class GustyWind final : public WindLayer {
public:
    /// @param mean not null. @param turbulence WindField::turbulence() of the mean; null: the intensity
    /// holds. @param gusts values out of range are clamped. @param profile that of the mean; if empty, the
    /// roughness of the ground is that which makes the intensity at 10 m.
    /// @param clock for the time of the gusts; the mean wind has its own.
    GustyWind(WindFieldPtr mean, WindFieldPtr turbulence, const WindGusts& gusts,
              const std::optional<LogProfile>& profile, const WindClock& clock);

    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

private:
    WindFieldPtr _mean, _turbulence;
    WindClock _clock;
    float _logRoughness; ///< ln of that of the ground in metres.
    float _lowest;       ///< Height below which the intensity is constant, metres.
    float _timesLog;     ///< Intensity times ln(height / roughness), at any height above.
    glm::dvec3 _travel;  ///< Velocity with which the gusts travel, m/s.
    glm::vec3 _along; ///< Its direction, which gusts of known turbulence have at every place, even in a calm.
    std::optional<GustNoise> _noise; ///< Never empty.
};

} // namespace osgTreeWind

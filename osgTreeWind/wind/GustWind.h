// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <memory>
#include <optional>

namespace osgTreeWind {

class GustNoise;

/// A mean wind with synthetic gusts that travel with it and change on their way (Simley and Pao 2015).
///
/// The spectrum along the wind is flat at low frequencies and falls with the power -5/3 above those of the
/// length scale (Kolmogorov), over two decades. Coherence across the wind decays as exp(-8.8 f d / U) (IEC
/// 61400-1:1999). The standard deviations across the wind and upward are 0.8 and 0.5 of that along it (IEC
/// 61400-1, Kaimal). The intensity falls with height as the inverse of the logarithmic profile (EN 1991-1-4).
/// The wind follows the terrain: it depends on the height above the ground, not on z.
///
///     GustWind::Parameters gusts;
///     gusts.mean = windVelocity({8.0, glm::radians(240.0)}, DirectionSense::From);
///     gusts.profile = LogProfile{10.0, 0.05};
///     if (const auto wind = GustWind::create(gusts))
///         report(forest->setWind(wind.value()));
class OSGTREEWIND_EXPORT GustWind final : public WindField {
public:
    /// Mean wind and turbulence.
    struct Parameters {
        glm::vec3 mean{5.0f, 0.0f, 0.0f}; ///< Horizontal, m/s toward, at most 200; at the profile's height.
        /// Standard deviation along the wind over the mean speed, [0, 1]; at the profile's height, or at 10
        /// m.
        double intensity = 0.2;
        double lengthScale = 60.0; ///< Integral length scale along the wind, metres, [1, 1e5].
        /// Scales the mean with the height above the ground; empty: the same mean at all heights.
        std::optional<LogProfile> profile;
        std::uint32_t seed = 1; ///< The same seed gives the same wind.
    };

    /// Checks the parameters and returns the wind, or diagnostics with the member's name or file key as key.
    static Result<std::shared_ptr<const GustWind>> create(const Parameters& parameters);

    const Parameters& parameters() const { return _parameters; } ///< The parameters as given.

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    WindFieldPtr withoutGusts() const override;

private:
    explicit GustWind(const Parameters& parameters);

    Parameters _parameters;
    LogProfile _terrain;  ///< Its factor divides the intensity.
    double _lowestFactor; ///< Limits it near the ground.
    std::shared_ptr<const GustNoise> _noise;
    glm::mat3 _axes; ///< Columns: along the wind, to its left, up; scaled by the standard deviations.
};

} // namespace osgTreeWind

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

/// A mean wind with turbulence that it carries along unchanged (Taylor's frozen turbulence).
///
/// Its spectrum along the wind is flat below the length scale and falls with frequency to the power -5/3
/// above (Kolmogorov), over two decades. Standard deviations across the wind and upward are 0.8 and 0.5 of
/// that along it (IEC 61400-1, Kaimal). One seed gives one wind. The whole follows the ground: what counts is
/// the height of a place above it.
///
///     GustWind::Parameters gusts;
///     gusts.mean = windVelocity({8.0, 240.0}, DirectionSense::From);
///     gusts.profile = LogProfile{10.0, 0.05};
///     if (const auto wind = GustWind::create(gusts))
///         forest->setWind(wind.value());
class OSGTREEWIND_EXPORT GustWind final : public WindField {
public:
    /// How fast, how gusty, how large.
    struct Parameters {
        glm::vec3 mean{5.0f, 0.0f, 0.0f}; ///< m/s toward, horizontal, at most 200; at the profile's height.
        double intensity = 0.2;           ///< Standard deviation along the wind over mean speed.
        double lengthScale = 60.0;        ///< Integral length scale of the turbulence along the wind, metres.
        std::optional<LogProfile>
            profile; ///< Scales mean and turbulence with height above the ground; empty: all heights alike.
        std::uint32_t seed = 1; ///< One seed gives one wind.
    };

    /// A field, or what is wrong with the parameters: diagnostics with the member's name, or its key in
    /// WindFields.h.
    static Result<std::shared_ptr<const GustWind>> create(const Parameters& parameters);

    const Parameters& parameters() const { return _parameters; } ///< As given.

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    KindOfWind kind() const override { return this; }
    WindFieldPtr withoutGusts() const override;

private:
    explicit GustWind(const Parameters& parameters);

    Parameters _parameters;
    std::shared_ptr<const GustNoise> _noise;
    glm::mat3 _axes; ///< Columns: along the wind, to its left, up; scaled by standard deviation.
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/wind/LogProfile.h>

#include <algorithm>
#include <limits>

namespace osgTreeWind {

/// LogProfile::factor() for many heights, as floats.
class LogFactor {
public:
    /// @param profile valid.
    explicit LogFactor(const LogProfile& profile)
        : _roughness(static_cast<float>(profile.roughness)),
          _logRoughness(static_cast<float>(math::log(profile.roughness))),
          _logRatio(static_cast<float>(math::log(profile.height / profile.roughness))) {}

    float operator()(float z) const {
        if (!(z > _roughness))
            return 0.0f;
        const float log = math::log(std::min(z, std::numeric_limits<float>::max()));
        return std::max((log - _logRoughness) / _logRatio, 0.0f);
    }

private:
    float _roughness, _logRoughness, _logRatio;
};

} // namespace osgTreeWind

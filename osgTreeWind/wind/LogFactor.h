// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/wind/LogProfile.h>

#include <algorithm>
#include <limits>

namespace osgTreeWind {

/// LogProfile::factor() for many heights.
class LogFactor {
public:
    /// @param profile valid.
    explicit LogFactor(const LogProfile& profile)
        : _roughness(profile.roughness), _logOfHeight(math::log(profile.height / profile.roughness)) {}

    double operator()(double z) const {
        if (!(z > _roughness))
            return 0.0;
        return math::log(std::min(z / _roughness, std::numeric_limits<double>::max())) / _logOfHeight;
    }

private:
    double _roughness, _logOfHeight;
};

} // namespace osgTreeWind

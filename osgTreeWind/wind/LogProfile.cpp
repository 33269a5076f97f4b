// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/LogProfile.h>

#include <osgTreeWind/wind/LogFactor.h>

#include <cmath>

namespace osgTreeWind {

bool LogProfile::valid() const {
    return roughness > 0.0 && roughness < height && std::isfinite(height);
}

double LogProfile::factor(double z) const {
    return LogFactor(*this)(z);
}

} // namespace osgTreeWind

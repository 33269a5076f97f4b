// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/LogProfile.h>

#include <osgTreeWind/base/PortableMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

bool LogProfile::valid() const {
    return roughness > 0.0 && roughness < height && std::isfinite(height);
}

double LogProfile::factor(double z) const {
    if (!(z > roughness))
        return 0.0;
    const double ratio = std::min(z / roughness, std::numeric_limits<double>::max());
    return math::log(ratio) / math::log(height / roughness);
}

} // namespace osgTreeWind

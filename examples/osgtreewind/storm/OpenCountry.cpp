// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/OpenCountry.h>

#include <osgTreeWind/wind/GustWind.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

LogProfile openCountryProfile(double height) {
    return {height, 0.03};
}

WindFieldPtr openCountryWind(double height, const glm::vec3& mean, std::uint32_t seed) {
    GustWind::Parameters gusts;
    gusts.profile = openCountryProfile(height);
    gusts.mean = mean;
    gusts.intensity = std::min(2.4 * 0.4 / std::log(height / gusts.profile->roughness), 1.0);
    gusts.seed = seed;
    return GustWind::create(gusts).value();
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/OpenCountry.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <algorithm>

namespace osgTreeWind {

LogProfile openCountryProfile(double height) {
    return {height, openCountryRoughness};
}

Wind openCountryWind(double height, const glm::vec3& mean, std::uint32_t seed) {
    const LogProfile profile = openCountryProfile(height);
    Wind wind(std::make_shared<UniformWind>(mean, profile));
    wind.gusts.intensity = std::min(2.4 * 0.4 / math::log(height / profile.roughness), 1.0);
    wind.gusts.seed = seed;
    return wind;
}

} // namespace osgTreeWind

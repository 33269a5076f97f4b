// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/SwingingWind.h>

#include <osgTreeWind/base/PortableMath.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

SwingingWind::SwingingWind(float along, const WindSpread& spread, float skewAlong) {
    const float variance = spread.along * spread.along,
                square = along * along + variance + spread.across * spread.across;
    const float cos2 = std::sqrt(std::max(1.0f - 2.0f * spread.across * spread.across / square, 0.04f));
    cosine = std::sqrt(cos2);
    mean = along / cosine;
    deviation = std::sqrt(std::max(square - mean * mean, 0.1f * variance));
    const float third = along * along * along + 3.0f * along * variance +
                        skewAlong * variance * spread.along, // of the wind along
        cubes = 0.25f * cosine * (3.0f + cos2 * cos2 * cos2 * cos2);
    const float own = third / cubes - mean * (mean * mean + 3.0f * deviation * deviation);
    skewness = std::clamp(own / (deviation * deviation * deviation), 0.0f, 2.0f);
}

float SwingingWind::swing() const {
    return std::sqrt(-2.0f * math::log(cosine));
}

} // namespace osgTreeWind

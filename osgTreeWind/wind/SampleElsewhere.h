// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <algorithm>

namespace osgTreeWind {

/// WindField::sample() of a field that is another one seen from elsewhere. Does not allocate.
/// @param there takes a place to the other field. @param back its velocity from there, with the place here.
template <typename There, typename Back>
void sampleElsewhere(const WindField& wind, const WindPlace* places, std::size_t count, double time,
                     glm::vec3* out, There there, Back back) {
    constexpr std::size_t placesAtOnce = 64;
    WindPlace moved[placesAtOnce];
    for (std::size_t first = 0; first < count; first += placesAtOnce) {
        const std::size_t some = std::min(placesAtOnce, count - first);
        std::transform(places + first, places + first + some, moved, there);
        wind.sample(moved, some, time, out + first);
        std::transform(out + first, out + first + some, places + first, out + first, back);
    }
}

} // namespace osgTreeWind

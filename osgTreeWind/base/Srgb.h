// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>

namespace osgTreeWind {

/// Linear light of a value of sRGB (IEC 61966-2-1), both from 0 to 1.
inline float linearOfSrgb(float value) {
    return value <= 0.04045f ? value / 12.92f : math::pow((value + 0.055f) / 1.055f, 2.4f);
}
/// The inverse.
inline float srgbOfLinear(float light) {
    return light < 0.0031308f ? 12.92f * light : 1.055f * math::pow(light, 1.0f / 2.4f) - 0.055f;
}

} // namespace osgTreeWind

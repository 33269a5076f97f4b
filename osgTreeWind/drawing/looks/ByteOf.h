// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>

#include <cmath>
#include <cstdint>

namespace osgTreeWind {

/// A share as a texel holds it: 0 to 255 of what is 0 to 1; beyond, the nearest.
inline std::uint8_t byteOf(float share) {
    return static_cast<std::uint8_t>(std::lround(255.0f * glm::clamp(share, 0.0f, 1.0f)));
}

} // namespace osgTreeWind

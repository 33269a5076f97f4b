// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>

#include <cmath>
#include <cstdint>

namespace osgTreeWind {

/// Converts a share to a texel value: [0, 1] to [0, 255], clamped.
inline std::uint8_t byteOf(float share) {
    return static_cast<std::uint8_t>(std::lround(255.0f * glm::clamp(share, 0.0f, 1.0f)));
}

} // namespace osgTreeWind

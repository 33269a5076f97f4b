// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>

#include <cstdint>

namespace osgTreeWind {

/// Converts a share to a texel value: [0, 1] to [0, 255], clamped.
inline std::uint8_t byteOf(float share) {
    const float value = 255.0f * glm::clamp(share, 0.0f, 1.0f);
    const int whole = static_cast<int>(value); // std::lround() is slow
    return static_cast<std::uint8_t>(value - static_cast<float>(whole) < 0.5f ? whole : whole + 1);
}

} // namespace osgTreeWind

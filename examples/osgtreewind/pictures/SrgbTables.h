// SPDX-License-Identifier: MIT
#pragma once

#include <glm/gtc/color_space.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>

/// Conversion between sRGB bytes and linear light.
struct SrgbTables {
    std::array<float, 256> linear;
    std::array<unsigned char, 16384> bytes; ///< Indexed by linear light, finely enough for dark bytes.

    SrgbTables() {
        for (std::size_t i = 0; i < linear.size(); ++i)
            linear[i] = glm::convertSRGBToLinear(glm::vec3(static_cast<float>(i) / 255.0f)).x;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const float light = static_cast<float>(i) / static_cast<float>(bytes.size() - 1);
            bytes[i] = static_cast<unsigned char>(
                std::lround(255.0f * glm::convertLinearToSRGB(glm::vec3(light)).x));
        }
    }
    unsigned char byte(float light) const {
        return bytes[static_cast<std::size_t>(light * static_cast<float>(bytes.size() - 1) + 0.5f)];
    }
};

inline const SrgbTables& srgbTables() {
    static const SrgbTables tables;
    return tables;
}

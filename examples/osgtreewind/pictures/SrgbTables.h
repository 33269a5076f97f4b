// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Srgb.h>

#include <array>
#include <cmath>

/// Conversion between sRGB bytes and linear light.
struct SrgbTables {
    std::array<float, 256> linear;
    std::array<unsigned char, 16384> bytes; ///< Indexed by linear light, finely enough for dark bytes.

    SrgbTables() {
        for (std::size_t i = 0; i < linear.size(); ++i)
            linear[i] = osgTreeWind::linearOfSrgb(static_cast<float>(i) / 255.0f);
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const float light = static_cast<float>(i) / static_cast<float>(bytes.size() - 1);
            bytes[i] = static_cast<unsigned char>(std::lround(255.0f * osgTreeWind::srgbOfLinear(light)));
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

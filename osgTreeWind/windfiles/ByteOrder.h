// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace osgTreeWind {

enum class ByteOrder { Little, Big };

/// Reads a number of type T at `offset`, which the caller has checked.
template <typename T>
T numberAt(std::string_view bytes, std::size_t offset, ByteOrder order) {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes.data() + offset, sizeof(T));
    const std::uint16_t probe = 1;
    const bool littleHost = *reinterpret_cast<const unsigned char*>(&probe) == 1;
    if ((order == ByteOrder::Little) != littleHost)
        std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
}

} // namespace osgTreeWind

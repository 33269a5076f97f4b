// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace osgTreeWind {

/// The 64-bit FNV-1a hash of the text.
inline std::uint64_t hashOf(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return hash;
}

} // namespace osgTreeWind

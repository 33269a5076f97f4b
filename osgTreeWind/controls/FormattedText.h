// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <string>

namespace osgTreeWind {

/// Formats a string as std::printf() does, truncated to 199 bytes.
template <class... Values>
std::string formatted(const char* format, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

/// Recognizes files of weather services by their first bytes.
namespace osgTreeWind {

/// Number of first bytes by which formats are recognised.
constexpr std::size_t headSize = 1024;

/// Whether a file is NetCDF, classic or HDF5.
inline bool isNetCdf(std::string_view head) {
    const auto starts = [&](std::string_view mark) { return head.substr(0, mark.size()) == mark; };
    return starts("CDF") || starts("\x89HDF");
}

/// Whether a file is GRIB, edition 1 or 2; a bulletin heading may come first. @param head its first headSize
/// bytes.
inline bool isGrib(std::string_view head) {
    constexpr std::size_t editionAt = 7;
    for (std::size_t at = head.find("GRIB"); at != std::string_view::npos; at = head.find("GRIB", at + 1))
        if (at + editionAt < head.size() &&
            (head[at + editionAt] == '\x01' || head[at + editionAt] == '\x02'))
            return true;
    return false;
}

} // namespace osgTreeWind

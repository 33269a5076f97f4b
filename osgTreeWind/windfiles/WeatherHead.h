// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// How files of weather services begin. Not part of the interface.
namespace osgTreeWind {

/// NetCDF, classic or HDF5.
inline bool beginsNetCdf(std::string_view head) {
    const auto starts = [&](std::string_view mark) { return head.substr(0, mark.size()) == mark; };
    return starts("CDF") || starts("\x89HDF");
}

/// Whether there is GRIB of edition 1 or 2 in the first kilobyte of a file, at its beginning or after the
/// heading of a bulletin.
inline bool beginsGrib(std::string_view head) {
    constexpr std::size_t editionAt = 7;
    for (std::size_t at = head.find("GRIB"); at != std::string_view::npos; at = head.find("GRIB", at + 1))
        if (at + editionAt < head.size() &&
            (head[at + editionAt] == '\x01' || head[at + editionAt] == '\x02'))
            return true;
    return false;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <array>
#include <string_view>

namespace osgTreeWind {

/// Where a table of cylinders has what is needed of them; found by name, without regard to case, dots and
/// underscores. Not part of the interface.
struct ScanColumns {
    enum Column { id, parent, radius, start, end = start + 3, axis = end + 3, length = axis + 3, count };

    std::string format;                ///< Whose names they are; "table" where they are of several.
    std::array<std::size_t, count> at; ///< Start, end and axis three each: x, y, z.
    bool hasEnds = true;               ///< Else cylinders have an axis and a length.
    bool idsAreExtensions = false;     ///< TreeQSM's, which are ids only once rTwig has numbered them.

    /// Whether a line of names is that of such a table.
    static bool knows(std::string_view names);
    /// A column that is missing is a problem that says how it may be called.
    static Result<ScanColumns> of(const CsvTable& table);
};

} // namespace osgTreeWind

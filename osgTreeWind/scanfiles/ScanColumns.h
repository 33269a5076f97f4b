// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <array>
#include <string_view>

namespace osgTreeWind {

/// Columns of a table of cylinders, found by name without regard to case, dots and underscores. Not part of
/// the interface.
struct ScanColumns {
    enum Column { id, parent, radius, start, end = start + 3, axis = end + 3, length = axis + 3, count };

    std::string format;                ///< Program with these column names; "table" if several share them.
    std::array<std::size_t, count> at; ///< Index of each Column in the table; vectors have x, y, z.
    bool hasEnds = true;               ///< False if the cylinders have an axis and a length instead.
    bool idsAreExtensions = false; ///< TreeQSM's extensions; they are ids only if rTwig has numbered them.

    /// Whether a header line is that of such a table.
    static bool matches(std::string_view names);
    /// Finds the columns of a table. The error for a missing column lists its possible names.
    static Result<ScanColumns> find(const CsvTable& table);
};

} // namespace osgTreeWind

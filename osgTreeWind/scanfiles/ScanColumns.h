// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <array>
#include <optional>
#include <string_view>

namespace osgTreeWind {

/// Columns of a table of cylinders or of points, found by name without regard to case, dots, underscores and
/// blanks. Not part of the interface.
struct ScanColumns {
    enum Column {
        id,
        parent,
        radius,
        diameter,
        length,
        start,
        end = start + 3,
        axis = end + 3,
        place = axis + 3,
        count = place + 3
    };

    std::string format; ///< Program with these column names; "table" if several share them.
    std::array<std::optional<std::size_t>, count> at; ///< Index in the table; vectors have x, y, z.
    /// First column of what a row has besides a radius: `end` and `axis` go with a start, `place` with a
    /// parent.
    Column kind = end;
    bool idsAreExtensions = false; ///< TreeQSM's extensions; they are ids only if rTwig has numbered them.

    /// Whether a header line, in which blanks separate names, has columns of places, or of radii.
    static bool havePlaces(std::string_view names);
    static bool haveRadii(std::string_view names);
    /// Finds the columns of a table. The error for a missing column lists its possible names, and those
    /// found.
    static Result<ScanColumns> find(const CsvTable& table);
};

} // namespace osgTreeWind

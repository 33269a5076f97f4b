// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/TableText.h>

#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// Where a table stands in a text.
struct TableLayout {
    CsvFormat format;               ///< The delimiter may be ' ', for any number of blanks.
    std::vector<std::string> names; ///< Of the columns.
    int headerLine = 0;             ///< 0 if there is none.
    std::vector<std::string> notes; ///< Assumptions.
    std::size_t foundCount = 0;     ///< Number of the columns asked for that the header has.
    bool isCertain = false; ///< Whether it has some of them, or else several cells, none of them a number.
};

/// Finds the delimiter and the header of a table from the first rows.
/// @param text UTF-8 without a byte-order mark.
TableLayout findTable(std::string_view text, const TableOptions& options);

/// The text with one tab for blanks between cells; quoted cells keep theirs.
std::string blanksToTabs(std::string_view text);

} // namespace osgTreeWind

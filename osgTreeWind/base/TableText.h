// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The decoded text of a delimited table, as spreadsheets, databases and loggers export it, and its format.
struct TableText {
    std::string text; ///< UTF-8, without a byte-order mark. Blanks that separate cells are replaced by a tab.
    CsvFormat format;
    std::vector<std::string> notes; ///< One for each assumption: "is no UTF-8 and is read as Windows-1252".
};

/// Format of a table as far as the user states it. The rest is detected from the beginning of the text.
struct TableOptions {
    /// Default: the one of ; tab | comma and blanks with which the header has most of `columns`, or else with
    /// which it comes first and has most cells. ' ' stands for any number of blanks.
    std::optional<char> delimiter;
    std::optional<bool> decimalComma; ///< Default: true unless the delimiter is a comma.
    std::optional<int> headerLine; ///< 1-based; 0: no header. Default: the first line with most of `columns`,
                                   ///< or else with as many cells as most rows. It may be in a comment.
    std::string comment;           ///< Lines that begin with it are skipped. Default: see beginsAsComment().
    std::vector<std::string> columns; ///< Names and expressions that are asked for.
};

/// Decodes the bytes of a table: UTF-8, UTF-16 with a byte-order mark, or else Windows-1252.
/// @param file name for diagnostics only. @return an error if the bytes are not text, or if columns are asked
/// for, none of them is an expression, and the table has none of them.
Result<TableText> decodeTable(std::string bytes, const std::string& file, const TableOptions& options = {});

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The decoded text of a delimited table, as spreadsheets and databases export it, and its format.
struct TableText {
    std::string text; ///< UTF-8, without a byte-order mark.
    CsvFormat format;
    std::vector<std::string> notes; ///< One for each assumption: "is no UTF-8 and is read as Windows-1252".
};

/// Format of a table as far as the user states it. The rest is detected from the bytes.
struct TableOptions {
    std::optional<char> delimiter;    ///< Default: the most frequent of ; tab | and comma in the header.
    std::optional<bool> decimalComma; ///< Default: true unless the delimiter is a comma.
};

/// Decodes the bytes of a table: UTF-8, UTF-16 with a byte-order mark, or else Windows-1252.
/// @param file name for diagnostics only. @return an error if the bytes are not text.
Result<TableText> decodeTable(std::string bytes, const std::string& file, const TableOptions& options = {});

} // namespace osgTreeWind

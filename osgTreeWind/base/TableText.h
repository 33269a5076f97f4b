// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// A delimited table as spreadsheets and databases export it, and what had to be assumed to read it.
struct TableText {
    std::string text; ///< UTF-8, without a byte-order mark.
    CsvFormat format;
    std::vector<std::string> notes; ///< One for each assumption: "is read as Windows-1252, ...".
};

/// What a file says of the way its cells are written; what it does not say is found from the bytes.
struct TableOptions {
    std::optional<char> delimiter; ///< Else the one that is most frequent in the header: ; tab | or a comma.
    std::optional<bool> decimalComma; ///< Else numbers may have one where cells are not parted by commas.
};

/// A table from its bytes: UTF-8, UTF-16 behind a byte-order mark, or else Windows-1252.
/// @param file name for diagnostics only. @return a problem where the bytes are no text.
Result<TableText> tableText(std::string bytes, const std::string& file, const TableOptions& options = {});

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// A delimited text file with a header row (RFC 4180 quoting, parsed with libcsv).
struct CsvTable {
    struct Row {
        int line = 0; ///< 1-based line of the file on which the row starts.
        std::vector<std::string> cells;
    };

    std::string file;                 ///< Name used in diagnostics.
    int headerLine = 1;               ///< 1-based line of the file on which the header row starts.
    std::vector<std::string> columns; ///< Header names, trimmed of blanks and a byte-order mark.
    std::vector<Row> rows;            ///< Every row has columns.size() cells.

    /// Index of the column called `name` (exact match), or empty.
    std::optional<std::size_t> column(const std::string& name) const;

    /// The cell as a finite number, or a diagnostic naming line, column name and the text found.
    Result<double> number(const Row& row, std::size_t column) const;
};

/// Reads a whole table. Ragged rows, no header, unterminated quotes and NUL bytes are errors with a line.
/// @param file name for diagnostics only.
Result<CsvTable> readCsvTable(std::istream& input, const std::string& file, char delimiter = ',');

/// The same without ever holding all rows.
/// @param take gets the table without rows, and each row in turn. All of it counts for nothing where the
/// result is an error.
Result<CsvTable> readCsvRows(std::string_view text, const std::string& file, char delimiter,
                             const std::function<void(const CsvTable& table, CsvTable::Row& row)>& take);

} // namespace osgTreeWind

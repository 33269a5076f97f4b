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

struct Range;

/// How the cells of a table are written.
struct CsvFormat {
    CsvFormat(char parted = ',', bool comma = false) : delimiter(parted), decimalComma(comma) {}

    std::optional<double> numberOf(const std::string& cell) const;

    char delimiter;
    bool decimalComma; ///< Whether "1,5" and "1.234,5" are numbers.
};

/// Whether a cell says that there is no value: empty, or "NA", "null", "M", "-" and the like.
bool isMissing(std::string_view cell);
/// Whether a number is one that programs write where there is no value: -99, -99.9, -9999, 999, 999.9 and the
/// like. Below zero two nines are enough, above it takes three.
bool isMissing(double number);

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
    CsvFormat format;

    /// Index of the column called `name` (exact match), or empty.
    std::optional<std::size_t> column(const std::string& name) const;

    /// The cell as a finite number, or a diagnostic naming line, column name and the text found.
    Result<double> number(const Row& row, std::size_t column) const;
};

/// Reads a whole table. Ragged rows, no header, unterminated quotes and NUL bytes are errors with a line.
/// @param file name for diagnostics only.
Result<CsvTable> readCsvTable(std::istream& input, const std::string& file, CsvFormat format = {});

/// The same without ever holding all rows.
/// @param take gets the table without rows, and each row in turn. All of it counts for nothing where the
/// result is an error.
Result<CsvTable> readCsvRows(std::string_view text, const std::string& file, CsvFormat format,
                             const std::function<void(const CsvTable& table, CsvTable::Row& row)>& take);

/// The cells of a row as what they say; the first that is not as it should be is remembered.
class CsvCells {
public:
    CsvCells(const CsvTable& table, const CsvTable::Row& row) : _table(table), _row(row) {}

    int line() const { return _row.line; }
    const std::string& text(std::size_t column) const { return _row.cells[column]; }
    bool has(std::size_t column) const { return !text(column).empty(); }
    /// @param what it has to be, for the message; null: a number of that range. @return 0 where it is not.
    double number(std::size_t column, const Range& range, const char* what = nullptr);
    /// Remembers that a cell is not what was expected.
    void expect(std::size_t column, const std::string& what);
    /// The same in other words.
    void fail(std::size_t column, const std::string& message);
    const std::optional<Diagnostic>& problem() const { return _problem; }

private:
    const CsvTable& _table;
    const CsvTable::Row& _row;
    std::optional<Diagnostic> _problem;
};

/// Reads rows parted by commas below a header of just these columns.
/// @param take gets one after the other, up to one that has a problem. @return what is wrong; empty: nothing.
Diagnostics readCsvOf(std::istream& input, const std::string& file, const std::vector<std::string>& columns,
                      const std::function<void(CsvCells& row)>& take);

} // namespace osgTreeWind

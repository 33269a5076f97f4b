// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

struct Range;

/// The form of a table.
struct CsvFormat {
    CsvFormat(char delimiter = ',', bool decimalComma = false)
        : delimiter(delimiter), decimalComma(decimalComma) {}

    /// The cell as a finite number, or empty.
    std::optional<double> numberOf(const std::string& cell) const;
    /// As numberOf(), for a number with thousands separators: apostrophes or blanks between groups of three
    /// digits, as in "2'600'100.5".
    std::optional<double> groupedNumberOf(const std::string& cell) const;

    char delimiter;
    bool decimalComma;   ///< Whether "1,5" and "1.234,5" are numbers.
    int firstLine = 1;   ///< 1-based; earlier lines are skipped.
    std::string comment; ///< Lines that begin with it are skipped; may be empty.
    /// Names of the columns, if the first row does not have them, and their line; 0: the table has none.
    std::vector<std::string> columns;
    int headerLine = 0;
    std::vector<std::string> units; ///< Cells of a row of units below the header; may be empty.
    std::string hint;               ///< How to correct the form, at the end of messages; may be empty.
};

/// Whether a cell marks a missing value: empty, "NA", "null", "M", "-" and similar.
bool isMissing(std::string_view cell);
/// Whether a number marks a missing value: -99, -99.9, -9999, 999, 999.9 and similar, which is at least two
/// nines for negative numbers and at least three for positive ones.
bool isMissing(double number);

/// A delimited text file with a header row (RFC 4180 quoting, parsed with libcsv).
struct CsvTable {
    struct Row {
        int line = 0; ///< 1-based line of the file on which the row starts.
        std::vector<std::string> cells;
    };

    std::string file;                 ///< Name used in diagnostics.
    int headerLine = 1;               ///< 1-based line of the file on which the header row starts.
    std::vector<std::string> columns; ///< Header names, trimmed of blanks and a byte-order mark. A name that
                                      ///< several have gets the number of the column: "name [3]".
    std::vector<Row> rows;            ///< Every row has columns.size() cells.
    CsvFormat format;
    std::size_t commentCount = 0; ///< Rows left out because they begin with a mark and differ in cells.

    /// "3 lines begin as comments and are left out", or empty.
    std::string commentNote() const;
    /// The unit that a row of units or the name of the column gives, as by unitInName().
    std::string unitOf(Dimension dimension, std::size_t column) const;
    /// Index of the column called `name` (exact match), or empty.
    std::optional<std::size_t> column(const std::string& name) const;

    /// The cell as a finite number, or a diagnostic naming line, column name and the text found.
    Result<double> number(const Row& row, std::size_t column) const;
};

/// Whether a row begins as a comment: with #, %, // or a semicolon.
bool beginsAsComment(const CsvTable::Row& row);

/// Reads a whole table. Ragged rows, no header, unterminated quotes and NUL bytes are errors with a line. A
/// row may end in further delimiters.
/// @param file name for diagnostics only.
Result<CsvTable> readCsvTable(std::istream& input, const std::string& file, CsvFormat format = {});

/// Like readCsvTable(), but holds one row at a time. @return the table without rows.
/// @param onRow gets the table without rows and each row. Discard what it collected if reading fails.
Result<CsvTable> readCsvRows(std::string_view text, const std::string& file, CsvFormat format,
                             const std::function<void(const CsvTable& table, CsvTable::Row& row)>& onRow);

/// Parses the cells of one row and keeps the first problem found.
class CsvCells {
public:
    CsvCells(const CsvTable& table, const CsvTable::Row& row) : _table(table), _row(row) {}

    int line() const { return _row.line; }
    const std::string& text(std::size_t column) const { return _row.cells[column]; }
    bool has(std::size_t column) const { return !text(column).empty(); }
    /// The cell as a number in `range`; otherwise 0, and a problem.
    /// @param expected for the message; null: "a number" and the range.
    double number(std::size_t column, const Range& range, const char* expected = nullptr);
    /// Records the problem "expected EXPECTED, found 'CELL'".
    void failExpected(std::size_t column, const std::string& expected);
    void fail(std::size_t column, const std::string& message);
    const std::optional<Diagnostic>& problem() const { return _problem; }

private:
    const CsvTable& _table;
    const CsvTable::Row& _row;
    std::optional<Diagnostic> _problem;
};

/// Reads comma-separated rows below a header that must consist of exactly these columns.
/// @param onRow is called for each row, up to the first that has a problem.
Diagnostics readCsvWithColumns(std::istream& input, const std::string& file,
                               const std::vector<std::string>& columns,
                               const std::function<void(CsvCells& row)>& onRow);

} // namespace osgTreeWind

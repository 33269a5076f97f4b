// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <csv.h>

#include <string>
#include <string_view>

namespace osgTreeWind {

/// Reads delimited text row by row with libcsv. It feeds libcsv one line at a time to know each row's line
/// number. Blank lines are skipped. A quotation mark within a cell that does not begin with one is part of
/// it.
class CsvReader {
public:
    /// @param text from plainText(); must outlive the reader. @param format its delimiter, comment and first
    /// line.
    CsvReader(std::string_view text, std::string file, const CsvFormat& format);
    CsvReader(const CsvReader&) = delete;
    CsvReader& operator=(const CsvReader&) = delete;
    ~CsvReader();

    /// Advances to the next row. @return false at the end of the text, or an error for misplaced quotes.
    Result<bool> next();
    CsvTable::Row& row() { return _row; }
    const CsvTable::Row& row() const { return _row; }

private:
    static void onCell(void* cell, std::size_t length, void* self);
    static void onRowEnd(int, void* self);
    std::size_t parse(std::size_t length);
    Diagnostic problem(int line, int column, const char* syntax) const;

    std::string_view _text; ///< Not parsed yet.
    std::string _file;
    const std::string _comment;
    mutable csv_parser _parser; // csv_error takes no const
    CsvTable::Row _row;
    int _line = 0;
    bool _isInRow = false, _isRowComplete = false;
    bool _isFlushed = false; ///< csv_fini() was called.
};

} // namespace osgTreeWind

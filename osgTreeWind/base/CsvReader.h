// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>

#include <csv.h>

#include <string>
#include <string_view>

namespace osgTreeWind {

/// Rows of a delimited text, one after the other, by libcsv, which is fed one line of the file at a time so
/// that every row knows its line. Blank lines are none.
class CsvReader {
public:
    /// @param text as plainText() gives it; it outlives the reader.
    CsvReader(std::string_view text, std::string file, char delimiter);
    CsvReader(const CsvReader&) = delete;
    CsvReader& operator=(const CsvReader&) = delete;
    ~CsvReader();

    /// Goes on to the next row; false: there is none. An error where quotes are not as they should be.
    Result<bool> next();
    CsvTable::Row& row() { return _row; }
    const CsvTable::Row& row() const { return _row; }

private:
    static void onCell(void* cell, std::size_t length, void* self);
    static void onRowEnd(int, void* self);
    Diagnostic problem(int line, int column, const char* syntax) const;

    std::string_view _text; ///< That is left.
    std::string _file;
    mutable csv_parser _parser; // csv_error takes no const
    CsvTable::Row _row;
    int _line = 0;
    bool _isBegun = false, _isWhole = false, _isFinished = false; ///< The row; the text.
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindSeriesColumns.h>

namespace osgTreeWind {

/// Converts the rows of a table to a wind record, row by row.
class WindSeriesRows {
public:
    /// @param head the table; its rows are not used.
    WindSeriesRows(const CsvTable& head, const WindSeriesColumns& columns);

    void addRow(const CsvTable::Row& row);

    /// Call after the last row. Returns the record, in seconds since the first row with wind, or all
    /// problems: columns of both forms or neither, a missing column, an unknown unit, no row with wind, and,
    /// with its line, a cell that is not a number, a time that does not increase, or an impossible value
    /// (negative speed, more than 200 m/s). Rows without wind are skipped; speed 0 needs no direction.
    /// @param components their meaning, if the columns have no directions.
    Result<WindContent> content(const char* format, const char* components,
                                std::vector<std::string> assumptions = {});
    /// Text of the time in the first row with wind.
    const std::string& start() const { return _startText; }

private:
    using Row = CsvTable::Row;

    void report(int line, const std::string& key, std::string message);
    std::size_t find(const char* role, const std::string& name);
    double number(const Row& row, std::size_t column, double scale, double low, double high,
                  const char* what);
    bool isMissing(const Row& row, std::size_t column) const;
    bool hasWind(const Row& row) const;
    double speed(const Row& row, std::size_t column, double low);
    double time(const Row& row);
    glm::vec3 velocity(const Row& row);

    const CsvTable _table; ///< The header, without rows.
    const WindSeriesColumns _columns;
    bool _polar = false;
    std::size_t _time = 0, _first = 0, _second = 0, _up = 0;
    double _secondsPerUnit = 1.0, _speedPerUnit = 1.0, _start = 0.0;
    WindSeries _series;
    Diagnostics _problems;
    bool _areColumnsValid = false;
    std::string _startText;
    std::size_t _rowCount = 0, _skippedCount = 0; ///< All rows; those without wind.
};

} // namespace osgTreeWind

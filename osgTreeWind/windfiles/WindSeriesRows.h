// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/RowExpression.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>
#include <osgTreeWind/windfiles/TimeColumns.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindSeriesColumns.h>

namespace osgTreeWind {

/// Converts the rows of a table to a wind record, row by row.
class WindSeriesRows {
public:
    /// @param head the table; its rows are not used.
    WindSeriesRows(const CsvTable& head, const WindSeriesColumns& columns);

    void addRow(const CsvTable::Row& row);

    /// Call after the last row. Returns the record, in seconds since the first row with wind and in the unit
    /// of speed of the table, or all problems: columns of both forms or neither, a missing column, an unknown
    /// unit, no row with wind, dates without a known order of day and month, and, with its line, a cell that
    /// is not a number, a time before that of the row above (for dates more than an hour, as clocks go back),
    /// or an impossible value (negative speed, more than 200 m/s). Rows without wind or with a variable
    /// direction are skipped; speed 0 needs no direction. Rows of one time are averaged.
    /// @param components their meaning, if the columns have no directions.
    Result<WindContent> content(const char* format, const char* components,
                                std::vector<std::string> assumptions = {});

private:
    using Row = CsvTable::Row;

    void report(int line, const std::string& key, std::string message);
    std::size_t find(const char* role, const std::string& name);
    double number(const Row& row, std::size_t column, double scale, double low, double high,
                  const char* what);
    Row withExpressions(const Row& row);
    void addRecord(const Row& row);
    bool isMissing(const Row& row, std::size_t column) const;
    bool hasWind(const Row& row) const;
    bool isVariable(const Row& row) const;
    double speed(const Row& row, std::size_t column, double low);
    double degrees(const Row& row);
    glm::vec3 velocity(const Row& row);
    std::string unitOf(Dimension dimension, std::size_t column) const;
    void chooseSpeedUnit();
    void chooseDirectionUnit();
    void joinRecords();

    CsvTable _table; ///< The header, without rows. Expressions follow the columns.
    std::vector<RowExpression> _expressions;
    const WindSeriesColumns _columns;
    const std::size_t _columnCount; ///< Of the file.
    struct Record {
        double dayFirst, monthFirst; ///< The readings of its time.
        glm::vec3 velocity;
        int line;
    };

    bool _polar = false;
    std::vector<std::size_t> _time;
    std::size_t _first = 0, _second = 0, _up = 0;
    double _speedPerUnit = 1.0, _degreesPerUnit = 1.0, _maxDegrees = 0.0;
    TimeColumns _times;
    std::vector<Record> _records;
    WindSeries _series;
    Diagnostics _problems;
    std::vector<std::string> _notes;
    bool _areColumnsValid = false;
    std::string
        _start;        ///< The first time, as by isoTimeText() but with milliseconds, if the times are dates.
    std::string _unit; ///< Unit of speed that columns give.
    std::size_t _rowCount = 0, _skippedCount = 0, _variableCount = 0; ///< All rows; those left out.
};

} // namespace osgTreeWind

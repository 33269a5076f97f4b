// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/windfiles/WindSeriesColumns.h>

namespace osgTreeWind {

/// The rows of a table as a wind record, one after the other. Not part of the interface.
class WindSeriesRows {
public:
    /// @param head the table, whose rows it does not ask for.
    WindSeriesRows(const CsvTable& head, const WindSeriesColumns& columns);

    void take(const CsvTable::Row& row);

    /// After the last row: the record, its times seconds since the first row with a wind; or every problem: a
    /// column map that names both forms or neither, a missing column, an unknown unit, no row with a wind,
    /// and, with its line, a cell that is no number, a time that does not increase, or a value no wind has
    /// (negative speed, more than 200 m/s). Rows whose wind is missing are left out, but of a calm without a
    /// direction.
    Result<WindSeries> series();
    /// Adds a note where rows were left out.
    void noteLeftOut(std::vector<std::string>& notes) const;
    /// The time of the first row with a wind, as it stands there.
    const std::string& start() const { return _startText; }

    /// What the directions or components mean, as a summary says it.
    static std::string direction(const WindSeriesColumns& columns, const char* components);

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

    const CsvTable _table; ///< Without rows.
    const WindSeriesColumns _map;
    bool _polar = false;
    std::size_t _time = 0, _first = 0, _second = 0, _up = 0;
    double _secondsPerUnit = 1.0, _speedPerUnit = 1.0, _start = 0.0;
    WindSeries _series;
    Diagnostics _problems;
    bool _sound = false; ///< The column map is.
    std::string _startText;
    std::size_t _taken = 0, _left = 0; ///< Rows that came; those without a wind.
};

} // namespace osgTreeWind

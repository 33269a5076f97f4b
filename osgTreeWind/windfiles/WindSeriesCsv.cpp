// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindSeriesCsv.h>

#include <osgTreeWind/base/IsoTime.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <cmath>

namespace osgTreeWind {

namespace {

using Row = CsvTable::Row;

constexpr const char* isoTime = "iso8601";

/// The table read through the column map. Problems gather; `problems` empty means all is well.
class SeriesReader {
public:
    SeriesReader(const CsvTable& table, const WindSeriesColumns& columns) : _table(table), _map(columns) {
        _polar = !_map.speed.empty() || !_map.direction.empty();
        if (_polar == !(_map.u.empty() && _map.v.empty() && _map.w.empty())) {
            report(0, {}, "expected columns for u and v, or for speed and direction");
            return;
        }
        _time = find("time", _map.time);
        if (_polar) {
            _first = find("speed", _map.speed);
            _second = find("direction", _map.direction);
        } else {
            _first = find("u", _map.u);
            _second = find("v", _map.v);
            if (!_map.w.empty())
                _up = find("w", _map.w);
        }
        if (const Result<double> seconds = timeUnit(_map.timeUnit))
            _secondsPerUnit = seconds.value();
        else if (_map.timeUnit != isoTime)
            report(0, "time unit", expectedFound("s, min, h or iso8601", _map.timeUnit));
        if (const Result<double> speed = speedUnit(_map.speedUnit))
            _speedPerUnit = speed.value();
        else
            report(0, "speed unit", speed.problems().front().message);
        if (_table.rows.empty())
            report(_table.headerLine, {}, "expected at least one record below the header");
    }

    Diagnostics problems;

    WindSeries read() {
        WindSeries series;
        for (const Row& row : _table.rows) {
            if (problems.size() >= maxRecordProblems)
                break;
            readRow(row, series);
        }
        return series;
    }

private:
    void report(int line, const std::string& key, std::string message) {
        problems.push_back({_table.file, line, 0, key, std::move(message)});
    }

    std::size_t find(const char* role, const std::string& name) {
        if (const auto column = _table.column(name); column && !name.empty())
            return *column;
        std::string known;
        for (const std::string& column : _table.columns)
            known += (known.empty() ? "" : ", ") + column;
        report(_table.headerLine, name.empty() ? role : name,
               name.empty() ? std::string("no column is named for ") + role
                            : std::string("no such column for ") + role + "; the header has " + known);
        return 0;
    }

    /// A cell within [low, high] after scaling; 0 with a problem otherwise.
    double number(const Row& row, std::size_t column, double scale, double low, double high,
                  const char* what) {
        const Result<double> cell = _table.number(row, column);
        if (!cell) {
            problems.push_back(cell.problems().front());
            return 0.0;
        }
        const double value = cell.value() * scale;
        if (value >= low && value <= high)
            return value;
        report(row.line, _table.columns[column], expectedFound(what, row.cells[column]));
        return 0.0;
    }

    double speed(const Row& row, std::size_t column, double low) {
        return number(row, column, _speedPerUnit, low, maxMeasuredSpeed,
                      low < 0.0 ? "a wind of at most 200 m/s either way" : "a wind speed of 0 to 200 m/s");
    }

    double time(const Row& row) {
        if (_map.timeUnit != isoTime)
            return number(row, _time, _secondsPerUnit, -1e15, 1e15, "a time");
        if (const auto seconds = parseIsoTime(row.cells[_time]))
            return *seconds;
        report(row.line, _map.time,
               expectedFound("a date and time such as 2015-06-29T12:00:00Z", row.cells[_time]));
        return 0.0;
    }

    glm::vec3 velocity(const Row& row) {
        if (_polar) {
            const double s = speed(row, _first, 0.0);
            const double d = number(row, _second, 1.0, -maxDirection, maxDirection, "degrees of -360 to 360");
            return windVelocity({s, d}, _map.sense);
        }
        const double u = speed(row, _first, -maxMeasuredSpeed), v = speed(row, _second, -maxMeasuredSpeed);
        return {u, v, _map.w.empty() ? 0.0 : speed(row, _up, -maxMeasuredSpeed)};
    }

    void readRow(const Row& row, WindSeries& series) {
        const std::size_t before = problems.size();
        const double now = time(row);
        const glm::vec3 wind = velocity(row);
        if (problems.size() != before)
            return;
        if (series.times.empty())
            _start = now;
        else if (now - _start <= series.times.back())
            return report(row.line, _map.time,
                          expectedFound("a later time than in the row before", row.cells[_time]));
        series.times.push_back(now - _start);
        series.velocities.push_back(wind);
    }

    const CsvTable& _table;
    const WindSeriesColumns& _map;
    bool _polar = false;
    std::size_t _time = 0, _first = 0, _second = 0, _up = 0;
    double _secondsPerUnit = 1.0, _speedPerUnit = 1.0, _start = 0.0;
};

} // namespace

Result<WindSeries> windSeriesOf(const CsvTable& table, const WindSeriesColumns& columns) {
    SeriesReader reader(table, columns);
    if (!reader.problems.empty())
        return reader.problems;
    WindSeries series = reader.read();
    if (!reader.problems.empty())
        return reader.problems;
    return series;
}

Result<WindSeries> readWindSeriesCsv(std::istream& input, const std::string& file,
                                     const WindSeriesColumns& columns) {
    const Result<CsvTable> table = readCsvTable(input, file, columns.delimiter);
    if (!table)
        return table.problems();
    return windSeriesOf(table.value(), columns);
}

} // namespace osgTreeWind

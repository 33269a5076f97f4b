// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindSeriesRows.h>

#include <osgTreeWind/base/IsoTime.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <glm/trigonometric.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr const char* isoTime = "iso8601";

} // namespace

WindSeriesRows::WindSeriesRows(const CsvTable& head, const WindSeriesColumns& columns)
    : _table{head.file, head.headerLine, head.columns, {}, head.format}, _columns(columns),
      _polar(!columns.speed.empty() || !columns.direction.empty()) {
    if (_polar == !(_columns.u.empty() && _columns.v.empty() && _columns.w.empty())) {
        report(0, {}, "expected columns for u and v, or for speed and direction");
        return;
    }
    _time = find("time", _columns.time);
    _first = _polar ? find("speed", _columns.speed) : find("u", _columns.u);
    _second = _polar ? find("direction", _columns.direction) : find("v", _columns.v);
    if (!_columns.w.empty())
        _up = find("w", _columns.w);
    if (const Result<double> seconds = timeUnit(_columns.timeUnit))
        _secondsPerUnit = seconds.value();
    else if (_columns.timeUnit != isoTime)
        report(0, "time unit", expectedFound("s, min, h or iso8601", _columns.timeUnit));
    if (const Result<double> speed = speedUnit(_columns.speedUnit))
        _speedPerUnit = speed.value();
    else
        report(0, "speed unit", speed.problems().front().message);
    _areColumnsValid = _problems.empty();
}

void WindSeriesRows::report(int line, const std::string& key, std::string message) {
    _problems.push_back({_table.file, line, 0, key, std::move(message)});
}

std::size_t WindSeriesRows::find(const char* role, const std::string& name) {
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

/// A cell times `scale` if in [low, high]; otherwise 0, with a problem.
double WindSeriesRows::number(const Row& row, std::size_t column, double scale, double low, double high,
                              const char* what) {
    const Result<double> cell = _table.number(row, column);
    if (!cell) {
        _problems.push_back(cell.problems().front());
        return 0.0;
    }
    const double value = cell.value() * scale;
    if (value >= low && value <= high)
        return value;
    report(row.line, _table.columns[column], expectedFound(what, row.cells[column]));
    return 0.0;
}

bool WindSeriesRows::isMissing(const Row& row, std::size_t column) const {
    if (osgTreeWind::isMissing(row.cells[column]))
        return true;
    const std::optional<double> number = _table.format.numberOf(row.cells[column]);
    return number && (osgTreeWind::isMissing(*number) ||
                      std::count(_columns.missing.begin(), _columns.missing.end(), *number) > 0);
}

/// A row with speed 0 needs no direction.
bool WindSeriesRows::hasWind(const Row& row) const {
    if (osgTreeWind::isMissing(row.cells[_time]) || // 999 s is a valid time
        isMissing(row, _first) || (!_columns.w.empty() && isMissing(row, _up)))
        return false;
    return !isMissing(row, _second) || (_polar && _table.format.numberOf(row.cells[_first]) == 0.0);
}

double WindSeriesRows::speed(const Row& row, std::size_t column, double low) {
    return number(row, column, _speedPerUnit, low, maxMeasuredSpeed,
                  low < 0.0 ? "a wind of at most 200 m/s either way" : "a wind speed of 0 to 200 m/s");
}

double WindSeriesRows::time(const Row& row) {
    if (_columns.timeUnit != isoTime)
        return number(row, _time, _secondsPerUnit, -maxTime, maxTime, "a time");
    if (const auto seconds = parseIsoTime(row.cells[_time]))
        return *seconds;
    report(row.line, _columns.time,
           expectedFound("a date and time such as 2015-06-29T12:00:00Z", row.cells[_time]));
    return 0.0;
}

glm::vec3 WindSeriesRows::velocity(const Row& row) {
    if (_polar) {
        const double s = speed(row, _first, 0.0);
        const double d = isMissing(row, _second) ? 0.0
                                                 : number(row, _second, 1.0, -maxDirection, maxDirection,
                                                          "degrees of -360 to 360");
        return windVelocity({s, glm::radians(d)}, _columns.sense);
    }
    const double u = speed(row, _first, -maxMeasuredSpeed), v = speed(row, _second, -maxMeasuredSpeed);
    return {u, v, _columns.w.empty() ? 0.0 : speed(row, _up, -maxMeasuredSpeed)};
}

void WindSeriesRows::addRow(const Row& row) {
    ++_rowCount;
    if (!_areColumnsValid || _problems.size() >= maxRecordProblems)
        return;
    if (!hasWind(row)) {
        ++_skippedCount;
        return;
    }
    const std::size_t before = _problems.size();
    const double now = time(row);
    const glm::vec3 wind = velocity(row);
    if (_problems.size() != before)
        return;
    if (_series.times.empty()) {
        _start = now;
        _startText = row.cells[_time];
    } else if (now - _start <= _series.times.back())
        return report(row.line, _columns.time,
                      expectedFound("a later time than in the row before", row.cells[_time]));
    _series.times.push_back(now - _start);
    _series.velocities.push_back(wind);
}

Result<WindContent> WindSeriesRows::content(const char* format, const char* components,
                                            std::vector<std::string> assumptions) {
    if (_areColumnsValid && _rowCount == 0)
        report(_table.headerLine, {}, "expected at least one record below the header");
    else if (_areColumnsValid && _skippedCount == _rowCount)
        report(_table.headerLine, {},
               "expected at least one record with wind, found none in " + std::to_string(_rowCount));
    if (!_problems.empty())
        return _problems;
    WindContent content;
    content.summary.format = format;
    content.summary.direction = _columns.speed.empty() ? components
                                : _columns.sense == DirectionSense::From
                                    ? "from, degrees clockwise from north"
                                    : "toward, degrees clockwise from north";
    content.assumptions = std::move(assumptions);
    if (_skippedCount > 0)
        content.assumptions.push_back(std::to_string(_skippedCount) + " of " + std::to_string(_rowCount) +
                                      " records have no wind and are skipped");
    content.data = std::move(_series);
    return content;
}

} // namespace osgTreeWind

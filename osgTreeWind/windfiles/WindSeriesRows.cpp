// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindSeriesRows.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/places/UnitSize.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/windfiles/DirectionText.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

WindSeriesRows::WindSeriesRows(const CsvTable& head, const WindSeriesColumns& columns)
    : _table{head.file, head.headerLine, head.columns, {}, head.format}, _columns(columns),
      _columnCount(head.columns.size()), _polar(!columns.speed.empty() || !columns.direction.empty()),
      _times(_columns) {
    if (_polar == !(_columns.u.empty() && _columns.v.empty() && _columns.w.empty())) {
        report(0, {}, "expected columns for u and v, or for speed and direction");
        return;
    }
    for (const std::string& name : _columns.time.empty() ? std::vector<std::string>{""} : _columns.time)
        _time.push_back(find("time", name));
    _first = _polar ? find("speed", _columns.speed) : find("u", _columns.u);
    _second = _polar ? find("direction", _columns.direction) : find("v", _columns.v);
    if (!_columns.w.empty())
        _up = find("w", _columns.w);
    for (const Diagnostic& problem : _times.check())
        report(0, problem.key, problem.message);
    if (_problems.empty())
        chooseSpeedUnit();
    if (_polar && _problems.empty())
        chooseDirectionUnit();
    _areColumnsValid = _problems.empty();
}

std::string WindSeriesRows::unitOf(Dimension dimension, std::size_t column) const {
    return column < _columnCount ? _table.unitOf(dimension, column) : std::string();
}

void WindSeriesRows::chooseSpeedUnit() {
    std::vector<std::size_t> columns = {_first};
    if (!_polar)
        columns.push_back(_second);
    if (!_columns.w.empty())
        columns.push_back(_up);
    std::optional<double> size;
    for (const std::size_t column : columns) {
        const std::string& name = _table.columns[column];
        const std::string unit = unitOf(Dimension::Speed, column);
        if (unit.empty())
            continue;
        const Result<double> named = sizeOfUnit(Dimension::Speed, unit);
        if (!named)
            _notes.push_back("the column " + inQuotes(name) + " gives " + inQuotes(unit) +
                             ", which is no known unit of speed");
        else if (size && *size != named.value() && _columns.speedUnit.empty())
            report(_table.headerLine, name, expectedFound("the unit of the other columns, " + _unit, unit));
        else {
            size = named.value();
            _unit = canonicalUnit(Dimension::Speed, unit);
        }
    }
    _speedPerUnit = size.value_or(1.0);
    if (!_columns.speedUnit.empty()) {
        if (const Result<double> asked = sizeOfUnit(Dimension::Speed, _columns.speedUnit))
            _speedPerUnit = asked.value();
        else
            report(0, "speed unit", asked.problems().front().message);
    } else if (_speedPerUnit != 1.0)
        _notes.push_back("the column " + inQuotes(_table.columns[_first]) + " gives the unit of speed, " +
                         _unit);
}

void WindSeriesRows::chooseDirectionUnit() {
    const std::string& asked = _columns.directionUnit;
    const std::optional<double> named =
        knownUnit(Dimension::Direction, unitOf(Dimension::Direction, _second));
    const std::optional<double> unit =
        asked.empty() ? named.value_or(1.0) : knownUnit(Dimension::Direction, asked);
    if (!unit)
        return report(0, "direction unit", expectedFound(expectedUnit(Dimension::Direction), asked));
    _degreesPerUnit = *unit;
    if (named && asked.empty() && *named != 1.0)
        _notes.push_back("the column " + inQuotes(_columns.direction) + " gives the unit of directions");
    else if (named && *named != *unit)
        _notes.push_back("direction_unit replaces the unit of the column " + inQuotes(_columns.direction));
}

void WindSeriesRows::report(int line, const std::string& key, std::string message) {
    _problems.push_back({_table.file, line, 0, key, std::move(message)});
}

std::size_t WindSeriesRows::find(const char* role, const std::string& name) {
    if (const auto column = _table.column(name); column && !name.empty())
        return *column;
    if (name.empty()) {
        report(_table.headerLine, role, std::string("no column is named for ") + role);
        return 0;
    }
    const std::vector<std::string> cells(_table.columns.begin(), _table.columns.end() - _expressions.size());
    auto expression = RowExpression::parse(name, cells, _table.file);
    if (!expression) {
        report(_table.headerLine, name,
               mayBeColumn(name)
                   ? std::string("no such column for ") + role + "; the header has " + joined(cells)
                   : expression.problems().front().message);
        return 0;
    }
    _expressions.push_back(std::move(expression.value()));
    _table.columns.push_back(name);
    return _table.columns.size() - 1;
}

/// A cell, if `scale` times it is in [low, high]; otherwise 0, with a problem.
double WindSeriesRows::number(const Row& row, std::size_t column, double scale, double low, double high,
                              const char* what) {
    const Result<double> cell = _table.number(row, column);
    if (!cell) {
        _problems.push_back(cell.problems().front());
        return 0.0;
    }
    const double value = cell.value() * scale;
    if (value >= low && value <= high)
        return cell.value();
    report(row.line, _table.columns[column], expectedFound(what, row.cells[column]));
    return 0.0;
}

bool WindSeriesRows::isMissing(const Row& row, std::size_t column) const {
    if (osgTreeWind::isMissing(row.cells[column]))
        return true;
    const std::optional<double> number = _table.format.numberOf(row.cells[column]);
    constexpr double buoyCode = 99.0; // NDBC's, in m/s, where it is no wind
    return number && (osgTreeWind::isMissing(*number) ||
                      (_polar && column == _first && _speedPerUnit == 1.0 && *number == buoyCode) ||
                      std::count(_columns.missing.begin(), _columns.missing.end(), *number) > 0);
}

/// A row with speed 0 needs no direction.
bool WindSeriesRows::hasWind(const Row& row) const {
    if (isMissing(row, _first) || (!_columns.w.empty() && isMissing(row, _up)))
        return false;
    return !isMissing(row, _second) || (_polar && _table.format.numberOf(row.cells[_first]) == 0.0);
}

/// Whether the row has a direction that varies: VRB, 990, or 99 tens of degrees.
bool WindSeriesRows::isVariable(const Row& row) const {
    const std::string& cell = row.cells[_second];
    constexpr double variableDirection = 990.0; // in degrees, FM 12 of the WMO
    return _polar && (isVariableDirection(cell) ||
                      _table.format.numberOf(cell).value_or(0.0) * _degreesPerUnit == variableDirection);
}

double WindSeriesRows::speed(const Row& row, std::size_t column, double low) {
    return number(row, column, _speedPerUnit, low, maxMeasuredSpeed,
                  low < 0.0 ? "a wind of at most 200 m/s either way" : "a wind speed of 0 to 200 m/s");
}

/// The direction; 0 for a calm, whose direction may be missing or variable.
double WindSeriesRows::degrees(const Row& row) {
    if (const auto point = compassDirection(row.cells[_second]))
        return *point;
    if (isMissing(row, _second) || isVariable(row))
        return 0.0;
    const Result<double> cell = _table.number(row, _second);
    const double degrees = cell ? cell.value() * _degreesPerUnit : HUGE_VAL;
    _maxDegrees = std::max(_maxDegrees, std::abs(degrees));
    if (std::abs(degrees) <= maxDirection * (1.0 + 1e-6)) // for rounded radians
        return degrees;
    report(row.line, _columns.direction,
           expectedFound(
               "a direction of -360 to 360 degrees (other units: direction_unit) or an English compass "
               "point (others: an expression such as replace(column, 'O', 'E'))",
               row.cells[_second]));
    return 0.0;
}

glm::vec3 WindSeriesRows::velocity(const Row& row) {
    if (_polar) {
        const double s = speed(row, _first, 0.0);
        return windVelocity({s, glm::radians(degrees(row))}, _columns.sense);
    }
    const double u = speed(row, _first, -maxMeasuredSpeed), v = speed(row, _second, -maxMeasuredSpeed);
    return {u, v, _columns.w.empty() ? 0.0 : speed(row, _up, -maxMeasuredSpeed)};
}

/// The row with the values of the expressions behind its cells.
CsvTable::Row WindSeriesRows::withExpressions(const Row& row) {
    struct Cells final : RowCells {
        std::string text(std::size_t column) const override { return row.cells[column]; }
        std::optional<double> number(std::size_t column) const override {
            return format.numberOf(row.cells[column]);
        }
        Cells(const Row& row, const CsvFormat& format) : row(row), format(format) {}
        const Row& row;
        const CsvFormat& format;
    };
    Row extended = row;
    for (const RowExpression& expression : _expressions) {
        auto value = expression.evaluate(Cells(row, _table.format));
        if (!value)
            report(row.line, {}, value.problems().front().message);
        extended.cells.push_back(value ? std::move(value.value().text) : std::string());
    }
    return extended;
}

void WindSeriesRows::addRow(const Row& row) {
    ++_rowCount;
    if (!_areColumnsValid || _problems.size() >= maxRecordProblems)
        return;
    if (_expressions.empty())
        addRecord(row);
    else
        addRecord(withExpressions(row));
}

void WindSeriesRows::addRecord(const Row& row) {
    std::string cell;
    for (const std::size_t column : _time) {
        if (osgTreeWind::isMissing(row.cells[column])) { // 999 s is a valid time
            ++_skippedCount;
            return;
        }
        cell += (cell.empty() ? "" : " ") + row.cells[column];
    }
    const Result<DateReadings> time =
        _times.read(cell, row.line, _table.format); // also tells the order of day and month
    if (!hasWind(row)) {
        ++_skippedCount;
        return;
    }
    if (isVariable(row) && _table.format.numberOf(row.cells[_first]) != 0.0) {
        ++_variableCount;
        return;
    }
    const std::size_t before = _problems.size();
    if (!time)
        report(row.line, _columns.time.front(), time.problems().front().message);
    const glm::vec3 wind = velocity(row);
    if (_problems.size() != before)
        return;
    const DateReadings& readings = time.value();
    if (!_times.areDates() && !_records.empty() && *readings.dayFirst < _records.back().dayFirst)
        return report(row.line, _columns.time.front(),
                      expectedFound("a time not before that of the row above", cell));
    _records.push_back({readings.dayFirst.value_or(0.0), readings.monthFirst.value_or(0.0), wind, row.line});
}

/// Sorts the records by time and averages those of one time.
void WindSeriesRows::joinRecords() {
    const Result<bool> isDayFirst = _times.isDayFirst();
    if (!isDayFirst)
        return report(isDayFirst.problems().front().line, _columns.time.front(),
                      isDayFirst.problems().front().message);
    const auto timeOf = [&](const Record& record) {
        return isDayFirst.value() ? record.dayFirst : record.monthFirst;
    };
    if (_times.areDates() && timeOf(_records.back()) < timeOf(_records.front())) {
        std::reverse(_records.begin(), _records.end());
        _notes.push_back("its records run backward in time and are reversed");
    }
    constexpr double summerTime = 3600.0;
    double latest = -HUGE_VAL;
    std::size_t lateCount = 0;
    for (const Record& record : _records) {
        const double time = timeOf(record);
        lateCount += time <= latest ? 1 : 0;
        if (time < latest - summerTime && _problems.size() < maxRecordProblems)
            report(record.line, _columns.time.front(),
                   expectedFound("a time at most an hour before those above", isoTimeText(time)));
        latest = std::max(latest, time);
    }
    std::stable_sort(_records.begin(), _records.end(),
                     [&](const Record& a, const Record& b) { return timeOf(a) < timeOf(b); });
    const double start = timeOf(_records.front());
    if (_times.areDates()) {
        _start = isoTimeText(start);
        const double fraction = std::round((start - std::floor(start)) * 1000.0) / 1000.0;
        if (fraction > 0.0 && fraction < 1.0)
            _start.insert(_start.size() - 1, numberText(fraction).substr(1));
    }
    for (auto record = _records.begin(); record != _records.end();) {
        const auto first = record;
        glm::dvec3 sum(0.0);
        for (; record != _records.end() && timeOf(*record) == timeOf(*first); ++record)
            sum += glm::dvec3(record->velocity);
        _series.times.push_back(timeOf(*first) - start);
        _series.velocities.emplace_back(sum / static_cast<double>(record - first));
    }
    if (lateCount > 0)
        _notes.push_back(
            std::to_string(lateCount) + " of " + std::to_string(_rowCount) +
            " records are not later than those above; records are sorted, and those of one time averaged");
}

Result<WindContent> WindSeriesRows::content(const char* format, const char* components,
                                            std::vector<std::string> assumptions) {
    if (_areColumnsValid && _rowCount == 0)
        report(_table.headerLine, {}, "expected at least one record below the header");
    else if (_areColumnsValid && _skippedCount + _variableCount == _rowCount)
        report(_table.headerLine, {},
               "expected at least one record with wind, found none in " + std::to_string(_rowCount));
    if (_problems.empty())
        joinRecords();
    if (!_problems.empty())
        return _problems;
    WindContent content;
    content.summary.format = format;
    content.summary.unit = _unit;
    content.summary.start = _start;
    content.summary.direction = _columns.speed.empty() ? components
                                : _columns.sense == DirectionSense::From
                                    ? "from, degrees clockwise from north"
                                    : "toward, degrees clockwise from north";
    content.assumptions = std::move(assumptions);
    if (_skippedCount > 0)
        content.assumptions.push_back(std::to_string(_skippedCount) + " of " + std::to_string(_rowCount) +
                                      " records have no wind and are skipped");
    if (_variableCount > 0)
        content.assumptions.push_back(std::to_string(_variableCount) + " of " + std::to_string(_rowCount) +
                                      " records have a variable direction and are skipped");
    constexpr double circleInTens = 36.0;
    if (_columns.directionUnit.empty() && _degreesPerUnit == 1.0 && _maxDegrees > 0.0 &&
        _maxDegrees <= circleInTens)
        content.assumptions.push_back(
            "its directions are taken as degrees, though none is above 36; direction_unit sets another unit");
    for (const std::vector<std::string>& notes : {_times.notes(), _notes})
        content.assumptions.insert(content.assumptions.end(), notes.begin(), notes.end());
    content.data = std::move(_series);
    return content;
}

} // namespace osgTreeWind

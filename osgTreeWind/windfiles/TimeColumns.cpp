// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/TimeColumns.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <cmath>

namespace osgTreeWind {

namespace {

constexpr const char* isoTime = "iso8601";
constexpr double maxSeconds = 1e11; // year 5138: larger numbers are milliseconds or compact dates
constexpr double secondsPerDay = 86400.0,
                 firstDay = -25569.0 * secondsPerDay; // 1899-12-30, day 0 of spreadsheets

} // namespace

Diagnostics TimeColumns::check() const {
    Diagnostics problems;
    const std::string &unit = _columns.timeUnit, &order = _columns.timeOrder;
    if (!unit.empty() && unit != isoTime && !knownUnit(Dimension::Time, unit))
        problems.push_back(
            {{}, 0, 0, "time unit", expectedFound("iso8601 or " + expectedUnit(Dimension::Time), unit)});
    if (!order.empty() && order != "dmy" && order != "mdy")
        problems.push_back({{}, 0, 0, "time order", expectedFound("dmy or mdy", order)});
    if (!_columns.timeFormat.empty() && !unit.empty() && unit != isoTime)
        problems.push_back({{}, 0, 0, "time format", "cannot be used with the time unit " + unit});
    return problems;
}

void TimeColumns::chooseUnit(const std::string& cell, const CsvFormat& format) {
    const std::optional<double> number = format.numberOf(cell);
    if (_columns.timeUnit == isoTime || !_columns.timeFormat.empty())
        _secondsPerUnit = 0.0;
    else if (!_columns.timeUnit.empty())
        _secondsPerUnit = *knownUnit(Dimension::Time, _columns.timeUnit);
    else if (!number)
        _secondsPerUnit = 0.0;
    else if (readDate(cell).isRead()) {
        _secondsPerUnit = 0.0;
        _unitNote = "times such as " + cell + " are taken as dates; time_unit sets another unit";
    } else if (std::abs(*number) >= maxSeconds) {
        _secondsPerUnit = 0.001;
        _unitNote = "its times are taken as milliseconds; time_unit sets another unit";
    } else {
        _secondsPerUnit = 1.0;
        _unitNote = "its times are taken as seconds; time_unit sets another unit";
    }
}

Result<DateReadings> TimeColumns::readDateCell(const std::string& cell, int line) {
    const std::string &format = _columns.timeFormat, &order = _columns.timeOrder;
    const DateReadings readings = format.empty() ? readDate(cell) : readDate(cell, format);
    if (!readings.isRead())
        return fileProblem({},
                           expectedFound(format.empty()
                                             ? "a date and time such as 2015-06-29T12:00:00Z (other forms: "
                                               "time_format; several columns: time = [\"date\", \"time\"])"
                                             : "a time as in time_format, " + format,
                                         cell),
                           line);
    if (!(order == "mdy" ? readings.monthFirst : order == "dmy" ? readings.dayFirst : 0.0))
        return fileProblem({}, expectedFound("a date in the order " + order, cell), line);
    if (!readings.monthFirst)
        _dayFirst = cell;
    else if (!readings.dayFirst)
        _monthFirst = cell;
    else if (*readings.dayFirst != *readings.monthFirst)
        _open = cell;
    if (readings.dayFirst != readings.monthFirst)
        _orderLine = line;
    _lacksZone = _lacksZone || !readings.hasZone;
    return readings;
}

Result<DateReadings> TimeColumns::read(const std::string& cell, int line, const CsvFormat& format) {
    if (!_secondsPerUnit)
        chooseUnit(cell, format);
    if (areDates())
        return readDateCell(cell, line);
    const std::optional<double> number = format.numberOf(cell);
    if (!number)
        return fileProblem({}, expectedFound("a number", cell), line);
    const double seconds = *number * *_secondsPerUnit + (*_secondsPerUnit == secondsPerDay ? firstDay : 0.0);
    if (!(std::abs(seconds) < maxSeconds))
        return fileProblem({},
                           expectedFound("a time below 1e11 s (milliseconds: time_unit = \"ms\"; dates: "
                                         "\"iso8601\")",
                                         cell),
                           line);
    return DateReadings{seconds, seconds, true};
}

bool TimeColumns::isDotted() const {
    return !_open.empty() && _open.find('.') < _open.find_first_of("-/ ");
}

Result<bool> TimeColumns::isDayFirst() const {
    if (!_columns.timeOrder.empty())
        return _columns.timeOrder == "dmy";
    if (!_dayFirst.empty() && !_monthFirst.empty())
        return fileProblem({},
                           "expected one order of day and month, found " + inQuotes(_dayFirst) + " and " +
                               inQuotes(_monthFirst),
                           _orderLine);
    if (_dayFirst.empty() && _monthFirst.empty() && !_open.empty() && !isDotted())
        return fileProblem({},
                           expectedFound("a day above 12 that tells the order of day and month, or "
                                         "time_order = \"dmy\" or \"mdy\"",
                                         _open),
                           _orderLine);
    return _monthFirst.empty();
}

std::vector<std::string> TimeColumns::notes() const {
    std::vector<std::string> notes;
    if (!_unitNote.empty())
        notes.push_back(_unitNote);
    if (_columns.timeOrder.empty() && _dayFirst.empty() && _monthFirst.empty() && isDotted())
        notes.push_back("dates such as " + _open +
                        " are taken with the day first; time_order sets another order");
    if (_lacksZone)
        notes.push_back("its times name no zone and are taken as UTC");
    return notes;
}

} // namespace osgTreeWind

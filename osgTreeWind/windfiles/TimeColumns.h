// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/windfiles/WindSeriesColumns.h>

namespace osgTreeWind {

/// Reads the times of a table, finds the order of day and month in them, and keeps what it assumed.
class TimeColumns {
public:
    explicit TimeColumns(const WindSeriesColumns& columns) : _columns(columns) {}

    /// An unknown unit or order; otherwise empty.
    Diagnostics check() const;
    /// Reads the joined cells of one row. Numbers have two equal readings in seconds. Errors have no file.
    Result<DateReadings> read(const std::string& cell, int line, const CsvFormat& format);
    /// Whether the times are dates. Call after the first read().
    bool areDates() const { return _secondsPerUnit == 0.0; }
    /// Whether the day comes before the month; an error if the dates do not tell.
    Result<bool> isDayFirst() const;
    /// One for each assumption. Call after the last read().
    std::vector<std::string> notes() const;

private:
    void chooseUnit(const std::string& cell, const CsvFormat& format);
    /// Whether a cell that does not tell the order has dots, which stand after the day.
    bool isDotted() const;
    Result<DateReadings> readDateCell(const std::string& cell, int line);

    const WindSeriesColumns _columns;
    std::optional<double> _secondsPerUnit;     ///< 0 for dates; empty before the first row.
    std::string _unitNote;                     ///< What the unit was taken for.
    std::string _dayFirst, _monthFirst, _open; ///< Cells that tell the order, and one that does not.
    int _orderLine = 0;                        ///< Of the last of these cells.
    bool _lacksZone = false;
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindSeriesRows.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <algorithm>
#include <optional>

namespace osgTreeWind {

namespace {

constexpr int unitLine = 3; // of the header

/// The given columns, or the usual TOA5 names if none are named.
WindSeriesColumns namedColumns(WindSeriesColumns columns) {
    if (!columns.named()) {
        columns.time = {"TIMESTAMP"};
        columns.u = "Ux";
        columns.v = "Uy";
        columns.w = "Uz";
    }
    columns.timeUnit = "iso8601";
    return columns;
}

/// Reads the rows below the column names: units, processing types, records.
class Toa5Rows {
public:
    explicit Toa5Rows(const WindSeriesColumns& columns) : _columns(namedColumns(columns)) {}

    void addRow(const CsvTable& table, const CsvTable::Row& row) {
        if (_rowCount++ == 0)
            readUnits(table, row);
        else if (_rowCount > 2)
            readRecord(table, row);
    }

    /// After the last row.
    Result<WindContent> content(const CsvTable& table) {
        if (_rowCount <= 2 || _unitLine != unitLine)
            return fileProblem(table.file, "expected lines of units and of processing types below the names",
                               unitLine);
        if (!_problems.empty())
            return _problems;
        if (!_records)
            _records.emplace(table, _columns);
        Result<WindContent> content = _records->content(
            "Campbell TOA5", "components of the instrument, taken as toward east, north and up");
        if (content && !_unit.empty())
            content.value().summary.unit = _unit;
        return content;
    }

private:
    /// Reads the unit of speed, which must be the same for all columns.
    void readUnits(const CsvTable& table, const CsvTable::Row& row) {
        _unitLine = row.line;
        for (const std::string* name :
             {&_columns.u, &_columns.v, &_columns.w, &_columns.speed, &_columns.direction}) {
            const auto column = table.column(*name);
            if (!column || name->empty())
                continue;
            if (name == &_columns.direction || !_problems.empty())
                continue;
            const std::string found = canonicalUnit(Dimension::Speed, row.cells[*column]);
            if (!_unit.empty() && found != _unit)
                _problems = {{table.file, row.line, 0, *name, expectedFound(_unit + " as before", found)}};
            _unit = found;
        }
    }

    void readRecord(const CsvTable& table, const CsvTable::Row& row) {
        if (!_records)
            _records.emplace(table, _columns);
        _records->addRow(row);
    }

    const WindSeriesColumns _columns;
    std::string _unit;
    Diagnostics _problems;
    std::optional<WindSeriesRows> _records;
    int _rowCount = 0, _unitLine = 0;
};

} // namespace

Result<WindContent> readToa5(std::string_view bytes, const std::string& file,
                             const WindSeriesColumns& columns) {
    Toa5Rows rows(columns);
    const std::size_t second = std::min(bytes.find('\n'), bytes.size()); // keeps the line numbers
    const Result<CsvTable> table =
        readCsvRows(second < bytes.size() ? bytes.substr(second) : "\n", file, ',',
                    [&](const CsvTable& head, const CsvTable::Row& row) { rows.addRow(head, row); });
    if (!table)
        return table.problems();
    return rows.content(table.value());
}

} // namespace osgTreeWind

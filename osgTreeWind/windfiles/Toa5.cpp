// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindSeriesRows.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <algorithm>
#include <optional>

namespace osgTreeWind {

namespace {

constexpr int unitLine = 3; // of the header

/// The map itself, or the usual names where it has none.
WindSeriesColumns namedColumns(WindSeriesColumns columns) {
    if (!columns.named()) {
        columns.time = "TIMESTAMP";
        columns.u = "Ux";
        columns.v = "Uy";
        columns.w = "Uz";
    }
    columns.timeUnit = "iso8601";
    columns.speedUnit = "m/s"; // converted with all other formats
    return columns;
}

/// The rows below the names: units, kinds, records.
class Toa5Rows {
public:
    explicit Toa5Rows(const WindSeriesColumns& columns) : _map(namedColumns(columns)) {}

    void take(const CsvTable& table, const CsvTable::Row& row) {
        if (_taken++ == 0)
            readUnits(table, row);
        else if (_taken > 2)
            readRecord(table, row);
    }

    /// After the last row.
    Result<WindContent> content(const CsvTable& table) {
        if (_taken <= 2 || _unitLine != unitLine)
            return fileProblem(table.file, "expected lines of units and of kinds below the names", unitLine);
        if (!_problems.empty())
            return _problems;
        if (!_records)
            _records.emplace(table, _map);
        Result<WindSeries> series = _records->series();
        if (!series)
            return series.problems();
        WindContent content;
        content.summary.format = "Campbell TOA5";
        content.summary.unit = _unit;
        content.summary.start = _records->start();
        content.summary.direction = WindSeriesRows::direction(
            _map, "components of the instrument, taken as toward east, north and up");
        _records->noteLeftOut(content.assumed);
        content.data = std::move(series.value());
        return content;
    }

private:
    /// The unit that the header gives for all of the columns of speeds.
    void readUnits(const CsvTable& table, const CsvTable::Row& row) {
        _unitLine = row.line;
        for (const std::string* name : {&_map.u, &_map.v, &_map.w, &_map.speed, &_map.direction}) {
            const auto column = table.column(*name);
            if (!column || name->empty())
                continue;
            if (name == &_map.direction || !_problems.empty())
                continue;
            const std::string found = usualSpeedUnit(row.cells[*column]);
            if (const auto known = speedUnit(found); !known)
                _problems = {{table.file, row.line, 0, *name, known.problems().front().message}};
            else if (!_unit.empty() && found != _unit)
                _problems = {{table.file, row.line, 0, *name, expectedFound(_unit + " as before", found)}};
            _unit = found;
        }
    }

    void readRecord(const CsvTable& table, const CsvTable::Row& row) {
        if (!_records)
            _records.emplace(table, _map);
        _records->take(row);
    }

    const WindSeriesColumns _map;
    std::string _unit;
    Diagnostics _problems;
    std::optional<WindSeriesRows> _records;
    int _taken = 0, _unitLine = 0;
};

} // namespace

Result<WindContent> readToa5(std::string_view bytes, const std::string& file,
                             const WindSeriesColumns& columns) {
    Toa5Rows rows(columns);
    const std::size_t second = std::min(bytes.find('\n'), bytes.size()); // so that lines keep their numbers
    const Result<CsvTable> table =
        readCsvRows(second < bytes.size() ? bytes.substr(second) : "\n", file, ',',
                    [&](const CsvTable& head, const CsvTable::Row& row) { rows.take(head, row); });
    if (!table)
        return table.problems();
    return rows.content(table.value());
}

} // namespace osgTreeWind

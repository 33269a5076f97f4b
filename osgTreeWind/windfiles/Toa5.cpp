// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <algorithm>
#include <sstream>

namespace osgTreeWind {

namespace {

constexpr std::size_t unitLine = 2, kindLine = 3; // of the header, from 0

/// Blanks out the first line, so that the second is the header and every line keeps its number.
std::string withoutFirstLine(std::string_view bytes) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    return std::string(bytes.substr(end));
}

/// Whether a cell that the map uses is marked as not measured.
bool notMeasured(const CsvTable::Row& row, const std::vector<std::size_t>& used) {
    return std::any_of(used.begin(), used.end(),
                       [&](std::size_t column) { return row.cells[column] == "NAN"; });
}

Diagnostic at(const CsvTable& table, int line, const std::string& key, const std::string& message) {
    return {table.file, line, 0, key, message};
}

/// The unit that the header gives for all of these columns.
Result<std::string> unitOf(const CsvTable& table, const std::vector<std::size_t>& speeds) {
    const CsvTable::Row& units = table.rows.front();
    std::string unit;
    for (std::size_t column : speeds) {
        const std::string found = usualSpeedUnit(units.cells[column]);
        if (const auto known = speedUnit(found); !known)
            return at(table, units.line, table.columns[column], known.problems().front().message);
        if (!unit.empty() && found != unit)
            return at(table, units.line, table.columns[column], expectedFound(unit + " as before", found));
        unit = found;
    }
    return unit;
}

} // namespace

Result<WindContent> readToa5(std::string_view bytes, const std::string& file,
                             const WindSeriesColumns& columns) {
    WindSeriesColumns map = columns;
    if (map.time.empty()) {
        map.time = "TIMESTAMP";
        map.u = "Ux";
        map.v = "Uy";
        map.w = "Uz";
    }
    map.timeUnit = "iso8601";
    std::istringstream text("\n" + withoutFirstLine(bytes).erase(0, 1));
    Result<CsvTable> read = readCsvTable(text, file, ',');
    if (!read)
        return read.problems();
    CsvTable& table = read.value();
    if (table.rows.size() < kindLine || table.rows[0].line != unitLine + 1)
        return at(table, unitLine + 1, {}, "expected lines of units and of kinds below the names");

    std::vector<std::size_t> used, speeds;
    for (const std::string* name : {&map.u, &map.v, &map.w, &map.speed, &map.direction})
        if (const auto column = table.column(*name); column && !name->empty()) {
            used.push_back(*column);
            if (name != &map.direction)
                speeds.push_back(*column);
        }
    const Result<std::string> unit = unitOf(table, speeds);
    if (!unit)
        return unit.problems();
    table.rows.erase(table.rows.begin(), table.rows.begin() + 2);
    const auto kept = std::remove_if(table.rows.begin(), table.rows.end(),
                                     [&](const CsvTable::Row& row) { return notMeasured(row, used); });
    const auto left = table.rows.end() - kept;
    table.rows.erase(kept, table.rows.end());
    const std::string start = table.rows.empty() || !table.column(map.time)
                                  ? ""
                                  : table.rows.front().cells[*table.column(map.time)];

    Result<WindSeries> series = windSeriesOf(table, map);
    if (!series)
        return series.problems();
    WindContent content;
    content.summary.format = "Campbell TOA5";
    content.summary.unit = unit.value();
    content.summary.start = start;
    if (map.speed.empty())
        content.summary.direction = "components of the instrument, taken as toward east, north and up";
    else
        content.summary.direction = map.sense == DirectionSense::From
                                        ? "from, degrees clockwise from north"
                                        : "toward, degrees clockwise from north";
    if (left > 0)
        content.summary.notes = {std::to_string(left) + " records marked NAN are left out"};
    content.data = std::move(series.value());
    return content;
}

} // namespace osgTreeWind

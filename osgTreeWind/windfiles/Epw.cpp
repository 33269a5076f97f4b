// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/CsvReader.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/TableText.h>
#include <osgTreeWind/windfiles/WindSeriesRows.h>

namespace osgTreeWind {

namespace {

// The data dictionary of EnergyPlus, chapter 2.9: fields of a row, from 0.
constexpr std::size_t directionField = 20, speedField = 21, fewestFields = 22;
constexpr int headerLines = 8;

} // namespace

Result<WindContent> readEpw(std::string_view bytes, const std::string& file) {
    const Result<TableText> text = tableText(std::string(bytes), file, {',', false});
    if (!text)
        return text.problems();
    WindSeriesColumns columns;
    columns.time = "hour";
    columns.timeUnit = "h";
    columns.speed = "wind speed";
    columns.direction = "wind direction";
    WindSeriesRows rows({file, headerLines, {columns.time, columns.speed, columns.direction}, {}, {}},
                        columns);
    CsvReader reader(text.value().text, file, ',');
    int hour = 0;
    for (Result<bool> found = reader.next();; found = reader.next()) {
        if (!found)
            return found.problems();
        if (!found.value())
            break;
        const CsvTable::Row& row = reader.row();
        if (row.line <= headerLines)
            continue;
        if (row.cells.size() < fewestFields)
            return fileProblem(file,
                               "expected at least " + std::to_string(fewestFields) +
                                   " cells of an EPW, found " + std::to_string(row.cells.size()),
                               row.line);
        rows.take({row.line, {std::to_string(hour++), row.cells[speedField], row.cells[directionField]}});
    }
    Result<WindSeries> series = rows.series();
    if (!series)
        return series.problems();
    WindContent content;
    content.summary.format = "EPW";
    content.summary.unit = "m/s";
    content.summary.direction = WindSeriesRows::direction(columns, "");
    content.assumed = {
        "winds of an hour each, 10 m above the ground; the hours are counted from the first row"};
    rows.noteLeftOut(content.assumed);
    content.data = std::move(series.value());
    return content;
}

} // namespace osgTreeWind

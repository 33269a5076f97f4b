// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/CsvReader.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/TableText.h>
#include <osgTreeWind/windfiles/WindSeriesRows.h>

namespace osgTreeWind {

namespace {

// Field indices from the EnergyPlus data dictionary, chapter 2.9.
constexpr std::size_t directionField = 20, speedField = 21, minFields = 22;
constexpr int headerLines = 8;

} // namespace

Result<WindContent> readEpw(std::string_view bytes, const std::string& file) {
    const Result<TableText> text = decodeTable(std::string(bytes), file);
    if (!text)
        return text.problems();
    WindSeriesColumns columns;
    columns.time = {"hour"};
    columns.timeUnit = "h";
    columns.speed = "wind speed";
    columns.direction = "wind direction";
    WindSeriesRows rows({file, headerLines, {columns.time.front(), columns.speed, columns.direction}, {}, {}},
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
        if (row.cells.size() < minFields)
            return fileProblem(file,
                               "expected at least " + std::to_string(minFields) + " cells of an EPW, found " +
                                   std::to_string(row.cells.size()),
                               row.line);
        rows.addRow({row.line, {std::to_string(hour++), row.cells[speedField], row.cells[directionField]}});
    }
    Result<WindContent> content =
        rows.content("EPW", "", {"hourly winds 10 m above the ground; hours are counted from the first row"});
    if (content)
        content.value().summary.unit = "m/s";
    return content;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/TableText.h>
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindSeriesRows.h>

#include <optional>

namespace osgTreeWind {

namespace {

/// The given columns, or the usual names if none are named.
WindSeriesColumns namedColumns(WindSeriesColumns columns, const CsvTable& table) {
    if (columns.named())
        return columns;
    columns.time = {"time"};
    if (table.column("speed")) {
        columns.speed = "speed";
        columns.direction = "direction";
    } else {
        columns.u = "u";
        columns.v = "v";
        columns.w = table.column("w") ? "w" : "";
    }
    return columns;
}

/// All columns that may be read.
std::vector<std::string> askedColumns(const WindSeriesColumns& columns) {
    if (!columns.named())
        return {"time", "u", "v", "speed", "direction"};
    std::vector<std::string> names = columns.time;
    for (const std::string& name : {columns.u, columns.v, columns.w, columns.speed, columns.direction})
        if (!name.empty())
            names.push_back(name);
    return names;
}

} // namespace

Result<WindContent> readWindCsv(std::string_view bytes, const std::string& file,
                                const WindSeriesColumns& columns) {
    const Result<TableText> text = decodeTable(std::string(bytes), file,
                                               {columns.delimiter, columns.decimalComma, columns.headerLine,
                                                columns.comment, askedColumns(columns)});
    if (!text)
        return text.problems();
    std::optional<WindSeriesRows> rows;
    const Result<CsvTable> table = readCsvRows(text.value().text, file, text.value().format,
                                               [&](const CsvTable& head, const CsvTable::Row& row) {
                                                   if (!rows)
                                                       rows.emplace(head, namedColumns(columns, head));
                                                   rows->addRow(row);
                                               });
    if (!table)
        return table.problems();
    if (!rows)
        rows.emplace(table.value(), namedColumns(columns, table.value()));
    std::vector<std::string> notes = text.value().notes;
    if (const std::string note = table.value().commentNote(); !note.empty())
        notes.push_back(note);
    return rows->content("CSV", "components toward east, north and up", std::move(notes));
}

} // namespace osgTreeWind

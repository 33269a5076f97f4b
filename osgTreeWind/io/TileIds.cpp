// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TileIds.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

#include <vector>

namespace osgTreeWind {

Result<TileIds> readTileIds(std::istream& input, const std::string& file) {
    const Result<std::string> text = readText(input, file);
    if (!text)
        return text.problems();
    const std::vector<std::string> expected = {"id", "place"};
    TileIds ids;
    const auto take = [&](const CsvTable& table, CsvTable::Row& row) {
        if (table.columns == expected)
            ids.emplace(row.cells[0], row.cells[1]);
    };
    const Result<CsvTable> table = readCsvRows(text.value(), file, ',', take);
    if (!table)
        return table.problems();
    if (table.value().columns != expected)
        return fileProblem(file, "expected the columns id, place", 1);
    return ids;
}

std::string tileIdsHead() {
    return "id,place\n";
}

std::string tileIdsRow(const std::string& id, const std::string& place) {
    return csvCell(id) + ',' + place + '\n';
}

} // namespace osgTreeWind

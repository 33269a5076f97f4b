// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TileIds.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>

namespace osgTreeWind {

Result<TileIds> readTileIds(std::istream& input, const std::string& file) {
    TileIds ids;
    const Diagnostics problems = readCsvWithColumns(
        input, file, {"id", "place"}, [&](CsvCells& row) { ids.emplace(row.text(0), row.text(1)); });
    if (!problems.empty())
        return problems;
    return ids;
}

std::string tileIdsHeader() {
    return "id,place\n";
}

std::string tileIdsRow(const std::string& id, const std::string& place) {
    return csvCell(id) + ',' + place + '\n';
}

} // namespace osgTreeWind

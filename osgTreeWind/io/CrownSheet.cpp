// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/CrownSheet.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestFields.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace osgTreeWind {

namespace {

struct SheetColumn {
    enum : std::size_t { Cell, Row, Trees, Foot, Height, Width, Species };
};
const std::vector<std::string> sheetColumnNames = {"column", "row",   "trees",  "foot",
                                                   "height", "width", "species"};
constexpr Range counts = within(0, 4294967295.0);
const std::array<Range, SheetColumn::Species> ranges = {
    counts, counts, within(1, 4294967295.0), worldCoordinates, above(0, 150.0), above(0, 150.0)};

std::string decimetres(double metres) {
    return numberText(std::round(10.0 * metres) / 10.0);
}

} // namespace

std::uint32_t CrownSheet::cellsAcrossTile(const ForestTiles& tiles) {
    return static_cast<std::uint32_t>(std::clamp(std::round(tiles.size / 125.0), 1.0, 8.0));
}

std::string crownSheetHead() {
    return csvLine(sheetColumnNames);
}

void CrownSums::add(const TreePlacement& tree, const TreeSize& size, const ForestTiles& tiles) {
    const glm::dvec2 place = glm::max((glm::dvec2(tree.position) - tiles.corner) / tiles.size, 0.0) *
                             static_cast<double>(CrownSheet::cellsAcrossTile(tiles));
    Cell& cell = _cells[{static_cast<std::uint32_t>(place.y), static_cast<std::uint32_t>(place.x)}];
    cell.trees += 1.0;
    cell.foot += tree.position.z;
    cell.height += static_cast<double>(size.height);
    cell.squareWidth += static_cast<double>(size.crownWidth * size.crownWidth);
    ++cell.bySpecies[tree.species];
}

std::string CrownSums::text(const std::vector<Species>& species) const {
    std::string text;
    for (const auto& [place, cell] : _cells) {
        const auto most = std::max_element(cell.bySpecies.begin(), cell.bySpecies.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        text += std::to_string(place.second) + ',' + std::to_string(place.first) + ',' +
                numberText(cell.trees) + ',' + decimetres(cell.foot / cell.trees) + ',' +
                decimetres(std::max(cell.height / cell.trees, 0.1)) + ',' +
                decimetres(std::max(std::sqrt(cell.squareWidth / cell.trees), 0.1)) + ',' +
                csvCell(species[most->first].name) + '\n';
    }
    return text;
}

Result<CrownSheet> readCrownSheet(std::istream& input, const std::string& file) {
    CrownSheet sheet;
    std::map<std::string, std::size_t> species;
    const Diagnostics problems = readCsvOf(input, file, sheetColumnNames, [&](CsvCells& row) {
        std::array<double, SheetColumn::Species> numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = row.number(i, ranges[i]);
        if (row.problem())
            return;
        const auto [known, isNew] = species.emplace(row.text(SheetColumn::Species), sheet.species.size());
        if (isNew)
            sheet.species.push_back(known->first);
        sheet.cells.push_back({static_cast<std::uint32_t>(numbers[SheetColumn::Cell]),
                               static_cast<std::uint32_t>(numbers[SheetColumn::Row]),
                               static_cast<std::uint32_t>(numbers[SheetColumn::Trees]),
                               static_cast<float>(numbers[SheetColumn::Foot]),
                               static_cast<float>(numbers[SheetColumn::Height]),
                               static_cast<float>(numbers[SheetColumn::Width]), known->second});
    });
    if (!problems.empty())
        return problems;
    return sheet;
}

} // namespace osgTreeWind

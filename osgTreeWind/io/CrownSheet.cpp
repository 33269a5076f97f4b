// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/CrownSheet.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/ForestFields.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace osgTreeWind {

namespace {

enum Column { CellColumn, CellRow, Trees, Foot, Height, Width, SpeciesName, ColumnCount };
constexpr std::array<const char*, ColumnCount> columnNames = {"column", "row",   "trees",  "foot",
                                                              "height", "width", "species"};
constexpr Range counts = within(0, 4294967295.0);
const std::array<Range, SpeciesName> ranges = {counts,           counts,          within(1, 4294967295.0),
                                               worldCoordinates, above(0, 150.0), above(0, 150.0)};

/// What is added up over a cell.
struct Sums {
    double trees = 0.0, foot = 0.0, height = 0.0, squareWidth = 0.0;
    std::map<std::size_t, std::uint32_t> bySpecies;
};

std::string decimetres(double metres) {
    return numberText(std::round(10.0 * metres) / 10.0);
}

} // namespace

std::uint32_t CrownSheet::cellsAcrossTile(const ForestTiles& tiles) {
    return static_cast<std::uint32_t>(std::clamp(std::round(tiles.size / 125.0), 1.0, 8.0));
}

std::string crownSheetHead() {
    std::string text;
    for (const char* name : columnNames)
        text.append(text.empty() ? "" : ",").append(name);
    return text + '\n';
}

std::string crownSheetText(const ForestDescription& forest, const PlacedForest& shapes,
                           const std::vector<std::uint32_t>& trees, const ForestTiles& tiles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Sums> cells; // by row, column
    for (const std::uint32_t index : trees) {
        const TreePlacement& tree = forest.trees[index];
        const std::optional<PlacedTree> placed = shapes.fitted(tree);
        if (!placed)
            continue;
        const TreeSize size = shapes.measured(*placed);
        const glm::dvec2 cell = glm::max((glm::dvec2(tree.position) - tiles.corner) / tiles.size, 0.0) *
                                static_cast<double>(CrownSheet::cellsAcrossTile(tiles));
        Sums& sums = cells[{static_cast<std::uint32_t>(cell.y), static_cast<std::uint32_t>(cell.x)}];
        sums.trees += 1.0;
        sums.foot += tree.position.z;
        sums.height += static_cast<double>(size.height);
        sums.squareWidth += static_cast<double>(size.crownWidth * size.crownWidth);
        ++sums.bySpecies[tree.species];
    }
    std::string text;
    for (const auto& [place, sums] : cells) {
        const auto most = std::max_element(sums.bySpecies.begin(), sums.bySpecies.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        text += std::to_string(place.second) + ',' + std::to_string(place.first) + ',' +
                numberText(sums.trees) + ',' + decimetres(sums.foot / sums.trees) + ',' +
                decimetres(std::max(sums.height / sums.trees, 0.1)) + ',' +
                decimetres(std::max(std::sqrt(sums.squareWidth / sums.trees), 0.1)) + ',' +
                csvCell(forest.species[most->first].name) + '\n';
    }
    return text;
}

Result<CrownSheet> readCrownSheet(std::istream& input, const std::string& file) {
    const std::string text{std::istreambuf_iterator<char>(input), {}};
    const std::vector<std::string> expected(columnNames.begin(), columnNames.end());
    CrownSheet sheet;
    std::map<std::string, std::size_t> species;
    std::optional<Diagnostic> problem;
    const auto take = [&](const CsvTable& table, CsvTable::Row& row) {
        std::array<double, SpeciesName> numbers{};
        if (problem || table.columns != expected)
            return;
        for (std::size_t i = 0; i < numbers.size() && !problem; ++i) {
            const std::optional<double> number = parseNumber(row.cells[i]);
            if (!number || !ranges[i].contains(*number))
                problem = Diagnostic{table.file, row.line, 0, columnNames[i],
                                     expectedFound("a number " + ranges[i].text(), row.cells[i])};
            numbers[i] = number.value_or(0.0);
        }
        const auto [known, isNew] = species.emplace(row.cells[SpeciesName], sheet.species.size());
        if (isNew)
            sheet.species.push_back(known->first);
        sheet.cells.push_back(
            {static_cast<std::uint32_t>(numbers[CellColumn]), static_cast<std::uint32_t>(numbers[CellRow]),
             static_cast<std::uint32_t>(numbers[Trees]), static_cast<float>(numbers[Foot]),
             static_cast<float>(numbers[Height]), static_cast<float>(numbers[Width]), known->second});
    };
    const Result<CsvTable> table = readCsvRows(text, file, ',', take);
    if (!table)
        return table.problems();
    if (table.value().columns != expected)
        return fileProblem(file, "expected the columns " + joined(expected), 1);
    if (problem)
        return *problem;
    return sheet;
}

} // namespace osgTreeWind

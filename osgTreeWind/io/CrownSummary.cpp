// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/CrownSummary.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestKeys.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace osgTreeWind {

namespace {

struct SummaryColumn {
    enum : std::size_t { Cell, Row, Trees, Foot, Height, Width, Species };
};
const std::vector<std::string> summaryColumnNames = {"column", "row",   "trees",  "foot",
                                                     "height", "width", "species"};
constexpr Range counts = within(0, 4294967295.0);
const std::array<Range, SummaryColumn::Species> ranges = {
    counts, counts, within(1, 4294967295.0), worldCoordinates, above(0, 150.0), above(0, 150.0)};

std::string decimetres(double metres) {
    return numberText(std::round(10.0 * metres) / 10.0);
}

} // namespace

std::uint32_t CrownSummary::cellsAcrossTile(const ForestTiles& tiles) {
    return static_cast<std::uint32_t>(std::clamp(std::round(tiles.size / 125.0), 1.0, 8.0));
}

std::string crownSummaryHeader() {
    return csvLine(summaryColumnNames);
}

void CrownAccumulator::add(const TreePlacement& tree, const TreeSize& size, const ForestTiles& tiles) {
    const glm::dvec2 place = glm::max((glm::dvec2(tree.position) - tiles.corner) / tiles.size, 0.0) *
                             static_cast<double>(CrownSummary::cellsAcrossTile(tiles));
    Cell& cell = _cells[{static_cast<std::uint32_t>(place.y), static_cast<std::uint32_t>(place.x)}];
    cell.trees += 1.0;
    cell.foot += tree.position.z;
    cell.height += static_cast<double>(size.height);
    cell.squaredWidth += static_cast<double>(size.crownWidth * size.crownWidth);
    ++cell.bySpecies[tree.species];
}

std::string CrownAccumulator::text(const std::vector<Species>& species) const {
    std::string text;
    for (const auto& [rowColumn, cell] : _cells) {
        const auto mostFrequent =
            std::max_element(cell.bySpecies.begin(), cell.bySpecies.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        text += std::to_string(rowColumn.second) + ',' + std::to_string(rowColumn.first) + ',' +
                numberText(cell.trees) + ',' + decimetres(cell.foot / cell.trees) + ',' +
                decimetres(std::max(cell.height / cell.trees, 0.1)) + ',' +
                decimetres(std::max(std::sqrt(cell.squaredWidth / cell.trees), 0.1)) + ',' +
                csvCell(species[mostFrequent->first].name) + '\n';
    }
    return text;
}

Result<CrownSummary> readCrownSummary(std::istream& input, const std::string& file) {
    CrownSummary summary;
    std::map<std::string, std::size_t> species;
    const Diagnostics problems = readCsvWithColumns(input, file, summaryColumnNames, [&](CsvCells& row) {
        std::array<double, SummaryColumn::Species> numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = row.number(i, ranges[i]);
        if (row.problem())
            return;
        const auto [known, isNew] = species.emplace(row.text(SummaryColumn::Species), summary.species.size());
        if (isNew)
            summary.species.push_back(known->first);
        summary.cells.push_back({static_cast<std::uint32_t>(numbers[SummaryColumn::Cell]),
                                 static_cast<std::uint32_t>(numbers[SummaryColumn::Row]),
                                 static_cast<std::uint32_t>(numbers[SummaryColumn::Trees]),
                                 static_cast<float>(numbers[SummaryColumn::Foot]),
                                 static_cast<float>(numbers[SummaryColumn::Height]),
                                 static_cast<float>(numbers[SummaryColumn::Width]), known->second});
    });
    if (!problems.empty())
        return problems;
    return summary;
}

} // namespace osgTreeWind

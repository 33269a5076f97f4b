// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TileTrees.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/forest/TileFiles.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

namespace osgTreeWind {

namespace {

enum TreeColumn {
    SpeciesName,
    X,
    Y,
    Z,
    Heading,
    Height,
    TrunkDiameter,
    CrownWidth,
    Leaves,
    Seed,
    OpenGrown,
    Estimated,
    Id
};
const std::vector<std::string> treeColumnNames = {
    "species",     "x",      "y",    "z",          "heading",   "height", "trunk_diameter",
    "crown_width", "leaves", "seed", "open_grown", "estimated", "id"};

template <typename Number>
void append(std::string& text, Number number) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    text.append(digits.data(), end);
}

double rounded(double metres) {
    constexpr double partsPerMetre = 10000.0;
    return std::round(metres * partsPerMetre) / partsPerMetre;
}

void appendSize(std::string& text, float size) {
    text += ',';
    if (size > 0.0f)
        append(text, size);
}

void appendTree(std::string& text, const TreePlacement& tree, const std::string& species) {
    text += csvCell(species);
    for (int axis = 0; axis < 3; ++axis)
        append(text += ',', rounded(tree.position[axis]));
    append(text += ',', tree.heading);
    appendSize(text, tree.size.height);
    appendSize(text, tree.size.trunkDiameter);
    appendSize(text, tree.size.crownWidth);
    text += ',';
    if (tree.leaves != 1.0f)
        append(text, tree.leaves);
    append(text += ',', tree.seed);
    text.append(tree.openGrown ? ",1," : ",,")
        .append(tree.estimated.height ? "h" : "")
        .append(tree.estimated.trunkDiameter ? "d" : "")
        .append(tree.estimated.crownWidth ? "w" : "");
    text.append(",").append(csvCell(tree.name)).append("\n");
}

void readEstimated(CsvCells& row, EstimatedSizes& estimated) {
    for (const char letter : row.text(Estimated))
        if (letter == 'h')
            estimated.height = true;
        else if (letter == 'd')
            estimated.trunkDiameter = true;
        else if (letter == 'w')
            estimated.crownWidth = true;
        else
            row.failExpected(Estimated, "some of h, d and w");
}

std::size_t indexOf(std::vector<std::string>& names, const std::string& name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name)
            return i;
    names.push_back(name);
    return names.size() - 1;
}

TreePlacement readTree(CsvCells& row, std::vector<std::string>& species) {
    const auto number = [&](TreeColumn column, const Range& range) {
        return static_cast<float>(row.number(column, range));
    };
    const auto size = [&](TreeColumn column) {
        return row.has(column) ? number(column, treeRange(treeColumnNames[column])) : 0.0f;
    };
    TreePlacement tree;
    if (!row.has(SpeciesName))
        row.failExpected(SpeciesName, "a name");
    tree.species = indexOf(species, row.text(SpeciesName));
    tree.position = {row.number(X, worldCoordinates), row.number(Y, worldCoordinates),
                     row.number(Z, worldCoordinates)};
    tree.heading = number(Heading, memberRange(keyAt(keysOf<TreePlacement>(), "heading")));
    tree.size = {size(Height), size(TrunkDiameter), size(CrownWidth)};
    tree.leaves = row.has(Leaves) ? number(Leaves, treeRange("leaves")) : 1.0f;
    tree.seed = static_cast<std::uint32_t>(row.number(Seed, within(0, 4294967295.0)));
    tree.openGrown = row.text(OpenGrown) == "1";
    if (row.has(OpenGrown) && !tree.openGrown)
        row.failExpected(OpenGrown, "1 or nothing");
    readEstimated(row, tree.estimated);
    tree.name = row.text(Id);
    return tree;
}

} // namespace

Result<TileTrees> readTileTrees(std::istream& input, const std::string& file) {
    TileTrees list;
    const Diagnostics problems = readCsvWithColumns(input, file, treeColumnNames, [&](CsvCells& row) {
        list.trees.push_back(readTree(row, list.species));
    });
    if (!problems.empty())
        return problems;
    return list;
}

Diagnostics TileTrees::resolve(const std::vector<Species>& known, std::size_t count,
                               const std::string& file) {
    if (trees.size() != count)
        return {fileProblem(file, "expected " + std::to_string(count) + " trees, found " +
                                      std::to_string(trees.size()))};
    std::vector<std::size_t> indices;
    for (const std::string& name : species) {
        const auto found =
            std::find_if(known.begin(), known.end(), [&](const Species& each) { return each.name == name; });
        if (found == known.end())
            return {fileProblem(file, "the world has no species " + inQuotes(name))};
        indices.push_back(static_cast<std::size_t>(found - known.begin()));
    }
    const std::string tile = stemOf(file);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        trees[i].species = indices[trees[i].species];
        if (trees[i].name.empty())
            trees[i].name.append(tile).append("/").append(std::to_string(i));
    }
    species.clear();
    for (const Species& each : known)
        species.push_back(each.name);
    return {};
}

Result<std::vector<TreePlacement>> readTile(const std::vector<Species>& species, const ForestTiles& tiles,
                                            std::size_t tile) {
    if (tiles.tiles[tile].trees == 0)
        return std::vector<TreePlacement>();
    const std::string file = fileOfTile(tiles, tile);
    Result<std::ifstream> input = openInput(file);
    if (!input)
        return input.problems();
    Result<TileTrees> read = readTileTrees(input.value(), file);
    if (!read)
        return read.problems();
    if (Diagnostics problems = read.value().resolve(species, tiles.tiles[tile].trees, file);
        !problems.empty())
        return problems;
    std::vector<TreePlacement> trees = std::move(read.value().trees);
    trees.erase(std::remove_if(trees.begin(), trees.end(),
                               [&](const TreePlacement& tree) { return tiles.removed.count(tree.name) > 0; }),
                trees.end());
    return trees;
}

std::string tileHeader() {
    return csvLine(treeColumnNames);
}

std::string tileRows(const std::vector<TreePlacement>& all, const std::vector<std::uint32_t>& trees,
                     const std::vector<Species>& species) {
    std::string text;
    for (const std::uint32_t tree : trees)
        appendTree(text, all[tree], species[all[tree].species].name);
    return text;
}

} // namespace osgTreeWind

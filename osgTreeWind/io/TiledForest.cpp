// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TiledForest.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/io/CrownSheet.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>
#include <osgTreeWind/io/TilesFlight.h>
#include <osgTreeWind/motion/CanopyOfTrees.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

constexpr double mostTiles = 10000.0, largestByDefault = 1000.0, treesByDefault = 2000.0, idsInFile = 5000.0;
constexpr std::size_t treesForStands = 20000;

/// Whole tiles that hold all trees, corners at multiples of their size.
ForestTiles gridOver(const ForestDescription& forest, double size) {
    glm::dvec2 low(forest.trees.front().position), high = low;
    for (const TreePlacement& tree : forest.trees) {
        low = glm::min(low, glm::dvec2(tree.position));
        high = glm::max(high, glm::dvec2(tree.position));
    }
    const auto count = [&](int axis, double side) {
        return std::floor(high[axis] / side) - std::floor(low[axis] / side) + 1.0;
    };
    const bool chosen = size > 0.0;
    if (!chosen)
        size = largestByDefault;
    while (count(0, size) * count(1, size) > mostTiles)
        size *= 2.0;
    const auto trees = static_cast<double>(forest.trees.size());
    while (!chosen && trees > treesByDefault * count(0, size) * count(1, size) &&
           count(0, 0.5 * size) * count(1, 0.5 * size) <= mostTiles)
        size *= 0.5;
    ForestTiles tiles;
    tiles.size = size;
    tiles.corner = size * glm::floor(low / size);
    tiles.columns = static_cast<std::uint32_t>(count(0, size));
    tiles.tiles.resize(static_cast<std::size_t>(count(0, size) * count(1, size)));
    return tiles;
}

std::size_t tileAt(const ForestTiles& tiles, const glm::dvec3& place) {
    const glm::dvec2 cell =
        glm::floor(glm::dvec2(place) / tiles.size) - glm::round(tiles.corner / tiles.size);
    return static_cast<std::size_t>(cell.y) * tiles.columns + static_cast<std::size_t>(cell.x);
}

/// Trees by tile, in the order of the forest.
std::vector<std::vector<std::uint32_t>> treesOfTiles(const ForestDescription& forest, ForestTiles& tiles) {
    std::vector<std::vector<std::uint32_t>> trees(tiles.tiles.size());
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        const auto z = static_cast<float>(forest.trees[i].position.z);
        const std::size_t index = tileAt(tiles, forest.trees[i].position);
        ForestTiles::Tile& tile = tiles.tiles[index];
        tile.low = trees[index].empty() ? z : std::min(tile.low, z);
        tile.high = trees[index].empty() ? z : std::max(tile.high, z);
        trees[index].push_back(static_cast<std::uint32_t>(i));
        ++tile.trees;
    }
    return trees;
}

void nameCompanies(const ForestDescription& forest, ForestTiles& tiles) {
    std::set<std::size_t> inForest, inOpen;
    for (const TreePlacement& tree : forest.trees)
        (tree.openGrown ? inOpen : inForest).insert(tree.species);
    for (const std::size_t species : inForest)
        tiles.inForest.push_back(forest.species[species].name);
    for (const std::size_t species : inOpen)
        tiles.inOpen.push_back(forest.species[species].name);
}

/// By the files that they are in.
std::map<std::string, std::string> idsOf(const ForestDescription& forest, ForestTiles& tiles,
                                         const std::vector<std::vector<std::uint32_t>>& trees) {
    const auto named = std::count_if(forest.trees.begin(), forest.trees.end(),
                                     [](const TreePlacement& tree) { return !tree.name.empty(); });
    tiles.idFiles =
        static_cast<std::uint32_t>(std::min(std::ceil(static_cast<double>(named) / idsInFile), mostTiles));
    std::map<std::string, std::string> files;
    for (std::size_t tile = 0; tile < trees.size(); ++tile)
        for (std::size_t i = 0; i < trees[tile].size(); ++i) {
            const std::string& name = forest.trees[trees[tile][i]].name;
            if (name.empty())
                continue;
            std::string& text = files[*tiles.fileOfId(name)];
            text += (text.empty() ? tileIdsHead() : "") +
                    tileIdsRow(name, tiles.nameOf(tile) + '/' + std::to_string(i));
        }
    return files;
}

/// Of all trees, or of those of tiles all over the world.
WindCanopy canopyOf(const ForestDescription& forest, const PlacedForest& shapes,
                    const std::vector<std::vector<std::uint32_t>>& trees, const Executor& executor) {
    const std::size_t every = (forest.trees.size() + treesForStands - 1) / treesForStands;
    std::vector<const std::vector<std::uint32_t>*> tiles;
    for (std::size_t tile = 0, met = 0; tile < trees.size(); ++tile)
        if (!trees[tile].empty() && met++ % every == 0)
            tiles.push_back(&trees[tile]);
    std::vector<std::vector<StandTree>> stands(tiles.size());
    executor(tiles.size(), [&](std::size_t i) {
        for (const std::uint32_t index : *tiles[i])
            if (const auto tree = shapes.fitted(forest.trees[index]))
                stands[i].emplace_back(shapes.modelOf(*tree), tree->scale, shapes.speciesOf(*tree),
                                       tree->leaves, glm::vec2(tree->position));
    });
    for (std::size_t i = 1; every == 1 && i < stands.size(); ++i) // no borders between tiles
        std::move(stands[i].begin(), stands[i].end(), std::back_inserter(stands[0]));
    if (every == 1)
        stands.resize(1);
    return withUsualStands(forest.windCanopy, stands);
}

/// Beside its place first: a file is whole or not there.
bool writeWhole(const std::string& path, const std::string& text) {
    const std::string unfinished = path + ".part";
    std::error_code error;
    if ((std::ofstream(unfinished, std::ios::binary) << text).flush())
        fs::rename(unfinished, path, error);
    else
        error = std::make_error_code(std::errc::io_error);
    if (!error)
        return true;
    fs::remove(unfinished, error);
    return false;
}

/// An empty folder for tiles, and no world beside it. @return what keeps it from that; empty when it is done.
std::string clear(const std::string& folder, const std::string& tiles) {
    std::error_code error;
    fs::remove(folder + "/world.treewind", error);
    fs::create_directories(tiles, error);
    if (error)
        return error.message();
    for (const fs::directory_entry& file : fs::directory_iterator(tiles, error)) {
        const std::string extension = file.path().extension().string();
        if (extension != ".trees" && extension != ".crowns" && extension != ".ids" && extension != ".part")
            return "expected nothing but tiles in it, found " + file.path().filename().string();
    }
    for (const fs::directory_entry& file : fs::directory_iterator(tiles, error))
        fs::remove(file.path(), error);
    return error ? error.message() : "";
}

} // namespace

Result<ForestTiles> writeTiledForest(const ForestDescription& forest, const std::string& folder,
                                     const TilingOptions& options) {
    if (forest.trees.empty())
        return keyProblem({}, "there are no trees to cut into tiles");
    ForestTiles tiles = gridOver(forest, options.size);
    tiles.folder = folder + "/tiles";
    const std::vector<std::vector<std::uint32_t>> trees = treesOfTiles(forest, tiles);
    nameCompanies(forest, tiles);
    tiles.range = options.range > 0.0 ? options.range : rangeOfTiles(tiles);

    const std::map<std::string, std::string> ids = idsOf(forest, tiles, trees);
    ForestDescription world = forest;
    world.trees.clear();
    world.tiles = tiles;
    world.tiles->folder = "tiles";
    if (const std::string problem = clear(folder, tiles.folder); !problem.empty())
        return fileProblem(tiles.folder, problem);
    const PlacedForest shapes(world);
    const Executor executor = options.executor ? options.executor : Executor(runInTurn);
    world.windCanopy = canopyOf(forest, shapes, trees, executor);
    std::vector<std::string> crowns(trees.size());
    std::atomic<bool> failed = false;
    const auto write = [&](std::size_t tile) {
        if (!failed && !trees[tile].empty() && !writeWhole(tiles.fileOf(tile), tileText(forest, trees[tile])))
            failed = true;
        crowns[tile] = crownSheetText(forest, shapes, trees[tile], tiles);
    };
    executor(trees.size(), write);
    for (const auto& [file, text] : ids)
        failed = failed || !writeWhole(file, text);
    if (failed || !writeWhole(folder + "/fly.path", flightOver(tiles, forest.origin)) ||
        !writeWhole(tiles.fileOfCrowns(), std::accumulate(crowns.begin(), crowns.end(), crownSheetHead())))
        return fileProblem(tiles.folder, "cannot be written");
    const std::string file = folder + "/world.treewind";
    Diagnostics problems = writeForestFile(world, file + ".part");
    std::error_code error;
    if (problems.empty())
        fs::rename(file + ".part", file, error);
    if (error)
        problems.push_back(fileProblem(file, error.message()));
    if (!problems.empty())
        return problems;
    return tiles;
}

namespace {

/// Of the map, in which tiles lie; those at the edge of a world go on beyond it.
struct Rectangle {
    glm::dvec2 low, high;

    Rectangle(const ForestTiles& tiles, const TileBox& box) {
        constexpr double farther = std::numeric_limits<double>::infinity();
        low = tiles.corner + tiles.size * glm::dvec2(box.firstColumn, box.firstRow);
        high = tiles.corner + tiles.size * (glm::dvec2(box.lastColumn, box.lastRow) + 1.0);
        low = {box.firstColumn == 0 ? -farther : low.x, box.firstRow == 0 ? -farther : low.y};
        high = {box.lastColumn >= tiles.columns - 1 ? farther : high.x,
                box.lastRow >= tiles.rows() - 1 ? farther : high.y};
    }
    bool holds(const glm::dvec2& place) const {
        return glm::all(glm::greaterThanEqual(place, low)) && glm::all(glm::lessThan(place, high));
    }
    double distanceTo(const glm::dvec2& place) const {
        return glm::distance(place, glm::clamp(place, low, high));
    }
};

TileBox widened(const TileBox& box, std::uint32_t by, const ForestTiles& tiles) {
    const auto less = [by](std::uint32_t first) { return first - std::min(first, by); };
    const auto more = [by](std::uint32_t last, std::uint32_t count) {
        return std::min(last, count - 1) + std::min(by, count - 1 - std::min(last, count - 1));
    };
    return {less(box.firstColumn), less(box.firstRow), more(box.lastColumn, tiles.columns),
            more(box.lastRow, tiles.rows())};
}

Result<std::vector<TreePlacement>> treesOf(const ForestDescription& forest, const ForestTiles& tiles,
                                           std::size_t tile) {
    if (tiles.tiles[tile].trees == 0)
        return std::vector<TreePlacement>();
    const std::string file = tiles.fileOf(tile);
    std::ifstream input(file, std::ios::binary);
    if (!input)
        return fileProblem(file, "cannot be opened for reading");
    Result<TileTrees> read = readTileTrees(input, file);
    if (!read)
        return read.problems();
    if (Diagnostics problems = read.value().fit(forest.species, tiles.tiles[tile].trees, file);
        !problems.empty())
        return problems;
    std::vector<TreePlacement> trees = std::move(read.value().trees);
    trees.erase(std::remove_if(trees.begin(), trees.end(),
                               [&](const TreePlacement& tree) { return tiles.removed.count(tree.name) > 0; }),
                trees.end());
    return trees;
}

} // namespace

Result<std::size_t> loadTiles(ForestDescription& forest, const TileBox& box, double margin) {
    if (!forest.tiles)
        return forest.trees.size();
    const ForestTiles tiles = std::move(*forest.tiles);
    forest.tiles.reset();
    if (box.firstColumn >= tiles.columns || box.firstRow >= tiles.rows())
        return keyProblem("tiles", "there are " + std::to_string(tiles.columns) + " columns and " +
                                       std::to_string(tiles.rows()) + " rows of them, found " +
                                       std::to_string(box.firstColumn) + ',' + std::to_string(box.firstRow));
    const Rectangle wanted(tiles, box);
    std::vector<TreePlacement> around;
    const auto take = [&](TreePlacement& tree, bool isWanted) {
        if (isWanted || wanted.distanceTo(glm::dvec2(tree.position)) <= margin)
            (isWanted ? forest.trees : around).push_back(std::move(tree));
    };
    for (TreePlacement& tree : std::exchange(forest.trees, {}))
        take(tree, wanted.holds(glm::dvec2(tree.position)));
    Diagnostics problems;
    const TileBox wider = widened(box, static_cast<std::uint32_t>(std::ceil(margin / tiles.size)), tiles);
    for (std::uint32_t row = wider.firstRow; row <= wider.lastRow; ++row)
        for (std::uint32_t column = wider.firstColumn; column <= wider.lastColumn; ++column) {
            auto trees = treesOf(forest, tiles, static_cast<std::size_t>(row) * tiles.columns + column);
            problems.insert(problems.end(), trees.problems().begin(), trees.problems().end());
            const bool isWanted = row >= box.firstRow && row <= box.lastRow && column >= box.firstColumn &&
                                  column <= box.lastColumn;
            for (std::size_t i = 0; trees && i < trees.value().size(); ++i)
                take(trees.value()[i], isWanted);
        }
    if (!problems.empty())
        return problems;
    const std::size_t count = forest.trees.size();
    std::move(around.begin(), around.end(), std::back_inserter(forest.trees));
    return count;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/io/TileTrees.h>
#include <osgTreeWind/io/TiledForest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace osgTreeWind {

namespace {

/// The area of a box of tiles. It is unbounded on the sides where the box touches the edge of the world.
struct Rectangle {
    glm::dvec2 low, high;

    Rectangle(const ForestTiles& tiles, const TileBox& box) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        low = tiles.corner + tiles.size * glm::dvec2(box.firstColumn, box.firstRow);
        high = tiles.corner + tiles.size * (glm::dvec2(box.lastColumn, box.lastRow) + 1.0);
        low = {box.firstColumn == 0 ? -infinity : low.x, box.firstRow == 0 ? -infinity : low.y};
        high = {box.lastColumn >= tiles.columns - 1 ? infinity : high.x,
                box.lastRow >= tiles.rows() - 1 ? infinity : high.y};
    }
    bool contains(const glm::dvec2& place) const {
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

} // namespace

Result<std::size_t> loadTiles(ForestDescription& forest, const TileBox& box, double margin) {
    if (!forest.tiles)
        return forest.trees.size();
    const ForestTiles tiles = std::move(*forest.tiles);
    forest.tiles.reset();
    if (box.firstColumn >= tiles.columns || box.firstRow >= tiles.rows())
        return keyProblem("tiles", "there are " + std::to_string(tiles.columns) + " columns and " +
                                       std::to_string(tiles.rows()) + " rows of tiles, found " +
                                       std::to_string(box.firstColumn) + ',' + std::to_string(box.firstRow));
    const Rectangle wanted(tiles, box);
    std::vector<TreePlacement> around;
    const auto add = [&](TreePlacement& tree, bool isWanted) {
        if (isWanted || wanted.distanceTo(glm::dvec2(tree.position)) <= margin)
            (isWanted ? forest.trees : around).push_back(std::move(tree));
    };
    for (TreePlacement& tree : std::exchange(forest.trees, {}))
        add(tree, wanted.contains(glm::dvec2(tree.position)));
    Diagnostics problems;
    const TileBox wider = widened(box, static_cast<std::uint32_t>(std::ceil(margin / tiles.size)), tiles);
    for (std::uint32_t row = wider.firstRow; row <= wider.lastRow; ++row)
        for (std::uint32_t column = wider.firstColumn; column <= wider.lastColumn; ++column) {
            auto trees =
                readTile(forest.species, tiles, static_cast<std::size_t>(row) * tiles.columns + column);
            problems.insert(problems.end(), trees.problems().begin(), trees.problems().end());
            const bool isWanted = row >= box.firstRow && row <= box.lastRow && column >= box.firstColumn &&
                                  column <= box.lastColumn;
            for (std::size_t i = 0; trees && i < trees.value().size(); ++i)
                add(trees.value()[i], isWanted);
        }
    if (!problems.empty())
        return problems;
    const std::size_t count = forest.trees.size();
    std::move(around.begin(), around.end(), std::back_inserter(forest.trees));
    return count;
}

} // namespace osgTreeWind

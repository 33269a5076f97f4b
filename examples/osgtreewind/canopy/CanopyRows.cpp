// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyRows.h>

#include <examples/osgtreewind/canopy/TreeAreas.h>

#include <algorithm>
#include <deque>

namespace osgTreeWind {

namespace {

/// Areas in the cells of some consecutive rows. The window moves north.
class RowWindow {
public:
    explicit RowWindow(const CanopyGrid& grid)
        : _grid(grid),
          _cells(static_cast<std::size_t>(grid.cells.x) * static_cast<std::size_t>(grid.cells.z)) {}

    /// Extends the window up to a row.
    void extendTo(int row) {
        while (_first + static_cast<int>(_rows.size()) <= row)
            _rows.emplace_back(_cells);
    }
    AreaSums& at(int column, int row, int level) {
        const std::size_t cell = static_cast<std::size_t>(level) * static_cast<std::size_t>(_grid.cells.x) +
                                 static_cast<std::size_t>(column);
        return _rows[static_cast<std::size_t>(row - _first)][cell];
    }
    /// Passes the first row to `use` and moves on to the next one.
    bool handOver(const std::function<bool(const CanopyRow&)>& use) {
        extendTo(_first);
        const auto perVolume = 1.0 / _grid.volume();
        _leaf.clear();
        _drag.clear();
        for (AreaSums& area : _rows.front()) {
            _leaf.push_back(static_cast<float>(perVolume * area.leaf));
            _drag.push_back(static_cast<float>(perVolume * area.drag));
            area = {};
        }
        const bool proceed = use({_first, _leaf, _drag});
        _rows.push_back(std::move(_rows.front())); // cleared above
        _rows.pop_front();
        ++_first;
        return proceed;
    }

private:
    const CanopyGrid& _grid;
    std::size_t _cells;
    int _first = 0;
    std::deque<std::vector<AreaSums>> _rows;
    std::vector<float> _leaf, _drag;
};

/// Height of a tree's foot above the lowest level, in cells, for each column of its footprint.
class FootLevels {
public:
    FootLevels(const CanopyGrid& grid, const CanopyFootprint& footprint, const Ground* ground)
        : _width(footprint.last.x - footprint.first.x + 1) {
        const auto add = [&](double height) {
            _levels.push_back(static_cast<float>((height - grid.low.z) / grid.cell.z));
        };
        if (!grid.aboveGround || !ground) {
            add(grid.aboveGround ? 0.0 : footprint.foot);
            return;
        }
        for (int row = footprint.first.y; row <= footprint.last.y; ++row)
            for (int column = footprint.first.x; column <= footprint.last.x; ++column)
                add(footprint.foot - grid.groundHeight(column, row, ground, footprint.foot));
    }
    /// @param column, row counted from the first of the footprint.
    float at(int column, int row) const {
        return _levels.size() == 1 ? _levels.front()
                                   : _levels[static_cast<std::size_t>(row * _width + column)];
    }

private:
    int _width;
    std::vector<float> _levels;
};

/// A tree that reaches the grid.
struct TreeOnGrid {
    const PlacedTree* tree;
    CanopyFootprint footprint;
};

/// Adds the areas of a tree to the rows of the window.
void addTree(const TreeOnGrid& onGrid, const PlacedForest& forest, const CanopyGrid& grid, TreeAreas& areas,
             RowWindow& window, CanopyTally& tally) {
    const CanopyFootprint& footprint = onGrid.footprint;
    const FootLevels foot(grid, footprint, forest.description().ground.get());
    const glm::dvec3 from = glm::dvec3(onGrid.tree->position) + forest.description().origin - grid.low;
    const glm::vec3 perCell(1.0 / grid.cell);
    const glm::vec2 start(glm::dvec2(from) / glm::dvec2(grid.cell) - glm::dvec2(footprint.first)),
        end(footprint.last - footprint.first + 1);
    window.extendTo(footprint.last.y);
    bool isWithin = false;
    for (const TreeAreas::Point& point : areas.pointsOf(*onGrid.tree)) {
        const glm::vec3 at = glm::vec3(start, 0.0f) + perCell * point.place;
        if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < end.x && at.y < end.y)) {
            tally.beyond += point.area;
            continue;
        }
        const int column = static_cast<int>(at.x), row = static_cast<int>(at.y);
        const int level = std::clamp(static_cast<int>(at.z + foot.at(column, row)), 0, grid.cells.z - 1);
        window.at(footprint.first.x + column, footprint.first.y + row, level) += point.area;
        tally.within += point.area;
        isWithin = true;
    }
    tally.trees += isWithin;
}

} // namespace

std::uint64_t canopyBytes(const PlacedForest& forest, const CanopyGrid& grid) {
    int rows = 1;
    for (const PlacedTree& tree : forest.trees)
        if (tree.alive) {
            const CanopyFootprint footprint(grid, treeBox(forest, tree));
            rows = std::max(rows, footprint.last.y - footprint.first.y + 1);
        }
    const std::uint64_t cells =
        static_cast<std::uint64_t>(grid.cells.x) * static_cast<std::uint64_t>(grid.cells.z);
    return cells * (static_cast<std::uint64_t>(rows) * sizeof(AreaSums) + 2 * sizeof(float));
}

CanopyTally spreadCanopy(const PlacedForest& forest, const CanopyGrid& grid,
                         const std::function<bool(const CanopyRow&)>& use) {
    CanopyTally tally;
    TreeAreas areas(forest, 0.5 * std::min({grid.cell.x, grid.cell.y, grid.cell.z}));
    std::vector<TreeOnGrid> standing;
    for (const PlacedTree& tree : forest.trees) {
        if (!tree.alive)
            continue;
        const CanopyFootprint footprint(grid, treeBox(forest, tree));
        if (footprint.isEmpty())
            tally.beyond += areas.sumOf(tree);
        else
            standing.push_back({&tree, footprint});
    }
    std::stable_sort(standing.begin(), standing.end(), [](const TreeOnGrid& a, const TreeOnGrid& b) {
        return a.footprint.first.y < b.footprint.first.y;
    });
    RowWindow window(grid);
    auto next = standing.begin();
    for (int row = 0; row < grid.cells.y && tally.finished; ++row) {
        for (; next != standing.end() && next->footprint.first.y <= row; ++next)
            addTree(*next, forest, grid, areas, window, tally);
        tally.finished = window.handOver(use);
    }
    return tally;
}

} // namespace osgTreeWind

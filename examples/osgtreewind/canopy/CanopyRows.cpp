// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyRows.h>

#include <examples/osgtreewind/canopy/TreeAreas.h>

#include <algorithm>
#include <deque>

namespace osgTreeWind {

namespace {

/// Areas of the cells of some rows, the first of which moves north.
class Window {
public:
    explicit Window(const CanopyGrid& grid)
        : _grid(grid),
          _cells(static_cast<std::size_t>(grid.cells.x) * static_cast<std::size_t>(grid.cells.z)) {}

    /// Makes room for rows up to that one.
    void reach(int row) {
        while (_first + static_cast<int>(_rows.size()) <= row)
            _rows.emplace_back(_cells);
    }
    AreaSums& at(int column, int row, int level) {
        const std::size_t cell = static_cast<std::size_t>(level) * static_cast<std::size_t>(_grid.cells.x) +
                                 static_cast<std::size_t>(column);
        return _rows[static_cast<std::size_t>(row - _first)][cell];
    }
    /// Hands over the first row, and has the next one as the first.
    bool handOver(const std::function<bool(const CanopyRow&)>& use) {
        reach(_first);
        const auto perVolume = 1.0 / _grid.volume();
        _leaf.clear();
        _drag.clear();
        for (AreaSums& area : _rows.front()) {
            _leaf.push_back(static_cast<float>(perVolume * area.leaf));
            _drag.push_back(static_cast<float>(perVolume * area.drag));
            area = {};
        }
        const bool goesOn = use({_first, _leaf, _drag});
        _rows.push_back(std::move(_rows.front())); // empty again
        _rows.pop_front();
        ++_first;
        return goesOn;
    }

private:
    const CanopyGrid& _grid;
    std::size_t _cells;
    int _first = 0;
    std::deque<std::vector<AreaSums>> _rows;
    std::vector<float> _leaf, _drag;
};

/// How far the foot of a tree is above the lowest level, in cells, over each column of its footprint.
class FootLevels {
public:
    FootLevels(const CanopyGrid& grid, const CanopyFootprint& print, const Ground* ground)
        : _width(print.last.x - print.first.x + 1) {
        const auto add = [&](double height) {
            _levels.push_back(static_cast<float>((height - grid.low.z) / grid.cell.z));
        };
        if (!grid.aboveGround || !ground) {
            add(grid.aboveGround ? 0.0 : print.foot);
            return;
        }
        for (int row = print.first.y; row <= print.last.y; ++row)
            for (int column = print.first.x; column <= print.last.x; ++column)
                add(print.foot - grid.groundOf(column, row, ground, print.foot));
    }
    /// @param column, row from the first of the footprint.
    float at(int column, int row) const {
        return _levels.size() == 1 ? _levels.front()
                                   : _levels[static_cast<std::size_t>(row * _width + column)];
    }

private:
    int _width;
    std::vector<float> _levels;
};

/// A tree that reaches the grid.
struct Standing {
    const PlacedTree* tree;
    CanopyFootprint print;
};

/// Puts a tree into the rows of the window.
void put(const Standing& standing, const PlacedForest& forest, const CanopyGrid& grid, TreeAreas& areas,
         Window& window, CanopyTally& tally) {
    const CanopyFootprint& print = standing.print;
    const FootLevels foot(grid, print, forest.description().ground.get());
    const glm::dvec3 from = glm::dvec3(standing.tree->position) + forest.description().origin - grid.low;
    const glm::vec3 perCell(1.0 / grid.cell);
    const glm::vec2 start(glm::dvec2(from) / glm::dvec2(grid.cell) - glm::dvec2(print.first)),
        end(print.last - print.first + 1);
    window.reach(print.last.y);
    bool isWithin = false;
    for (const TreeAreas::Point& point : areas.of(*standing.tree)) {
        const glm::vec3 at = glm::vec3(start, 0.0f) + perCell * point.place;
        if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < end.x && at.y < end.y)) {
            tally.beyond += point.area;
            continue;
        }
        const int column = static_cast<int>(at.x), row = static_cast<int>(at.y);
        const int level = std::clamp(static_cast<int>(at.z + foot.at(column, row)), 0, grid.cells.z - 1);
        window.at(print.first.x + column, print.first.y + row, level) += point.area;
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
            const CanopyFootprint print(grid, treeBox(forest, tree));
            rows = std::max(rows, print.last.y - print.first.y + 1);
        }
    const std::uint64_t cells =
        static_cast<std::uint64_t>(grid.cells.x) * static_cast<std::uint64_t>(grid.cells.z);
    return cells * (static_cast<std::uint64_t>(rows) * sizeof(AreaSums) + 2 * sizeof(float));
}

CanopyTally spreadCanopy(const PlacedForest& forest, const CanopyGrid& grid,
                         const std::function<bool(const CanopyRow&)>& use) {
    CanopyTally tally;
    TreeAreas areas(forest, 0.5 * std::min({grid.cell.x, grid.cell.y, grid.cell.z}));
    std::vector<Standing> standing;
    for (const PlacedTree& tree : forest.trees) {
        if (!tree.alive)
            continue;
        const CanopyFootprint print(grid, treeBox(forest, tree));
        if (print.isEmpty())
            tally.beyond += areas.sumOf(tree);
        else
            standing.push_back({&tree, print});
    }
    std::stable_sort(standing.begin(), standing.end(),
                     [](const Standing& a, const Standing& b) { return a.print.first.y < b.print.first.y; });
    Window window(grid);
    auto next = standing.begin();
    for (int row = 0; row < grid.cells.y && tally.finished; ++row) {
        for (; next != standing.end() && next->print.first.y <= row; ++next)
            put(*next, forest, grid, areas, window, tally);
        tally.finished = window.handOver(use);
    }
    return tally;
}

} // namespace osgTreeWind

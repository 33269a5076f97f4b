// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ClosedWood.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/forest/GrowingSpaces.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace osgTreeWind {

namespace {

constexpr std::size_t mostTrees = 500, pointsPerTree = 128;
constexpr double reachInHeights = 2.0, cellSize = 8.0; // metres

/// Points on the ground around trees, in square cells.
class GroundPoints {
public:
    /// Adds evenly spread points within the reach of a tree.
    void add(const Crown& tree) {
        constexpr double count = pointsPerTree;
        for (std::size_t i = 0; i < pointsPerTree; ++i) { // Vogel 1979
            const double turn = static_cast<double>(i) * (3.0 - std::sqrt(5.0)) * glm::pi<double>();
            const double distance =
                reachInHeights * tree.height * std::sqrt((static_cast<double>(i) + 0.5) / count);
            const glm::dvec2 point = tree.position + distance * glm::dvec2(math::cos(turn), math::sin(turn));
            _cells[keyOf(glm::floor(point / cellSize))].push_back(_points.size());
            _points.push_back({point, false});
        }
    }
    void cover(const Crown& crown) {
        const glm::dvec2 low = glm::floor((crown.position - crown.radius) / cellSize),
                         high = glm::floor((crown.position + crown.radius) / cellSize);
        for (double y = low.y; y <= high.y; ++y)
            for (double x = low.x; x <= high.x; ++x)
                if (const auto cell = _cells.find(keyOf({x, y})); cell != _cells.end())
                    for (const std::size_t i : cell->second)
                        if (glm::distance(_points[i].place, crown.position) <= crown.radius)
                            _points[i].isCovered = true;
    }
    /// Share of the trees with enough covered points.
    double closedShare() const {
        double closed = 0.0;
        for (auto first = _points.begin(); first != _points.end(); first += pointsPerTree)
            closed += static_cast<double>(std::count_if(first, first + pointsPerTree, [](const Point& point) {
                          return point.isCovered;
                      })) >= closedCover * pointsPerTree;
        return _points.empty() ? 0.0 : closed * pointsPerTree / static_cast<double>(_points.size());
    }

private:
    struct Point {
        glm::dvec2 place;
        bool isCovered;
    };
    static std::uint64_t keyOf(const glm::dvec2& cell) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.x)) << 32u ^
               static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.y));
    }

    std::vector<Point> _points;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> _cells;
};

} // namespace

double shareInClosedWood(const std::vector<Species>& species, std::size_t count,
                         const std::function<void(const TreeVisitor&)>& visit) {
    GroundPoints ground;
    const std::size_t step = (count + mostTrees - 1) / mostTrees;
    std::size_t number = 0;
    visit([&](const std::vector<TreePlacement>& trees) {
        for (const TreePlacement& tree : trees)
            if (number++ % step == 0)
                ground.add(crownOf(tree, species[tree.species]));
    });
    visit([&](const std::vector<TreePlacement>& trees) {
        for (const TreePlacement& tree : trees)
            ground.cover(crownOf(tree, species[tree.species]));
    });
    return ground.closedShare();
}

} // namespace osgTreeWind

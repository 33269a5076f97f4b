// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/CompanyOfTrees.h>

#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr std::size_t sides = 16;
using Sides = std::bitset<sides>;

constexpr double asHigh = 0.6;      // as a tree, at least, are neighbours
constexpr double gap = 0.5;         // between two crowns, of the neighbour's height
constexpr double closedFrom = 0.75; // of all sides
constexpr double openTo = 0.25;     // of all sides
constexpr double oneSided = 0.2;    // mean of the directions of open sides, over all sides
constexpr double usualCrown = 0.4;  // of the height, where nothing tells a crown's width
constexpr double usualTree = 15.0;  // metres, where nothing tells a height
constexpr double cellSize = 16.0;   // metres

struct Crown {
    glm::dvec2 place{0.0};
    double height = 0.0, radius = 0.0;
};

Crown crownOf(const TreePlacement& tree, const Species& species) {
    Crown crown;
    crown.place = glm::dvec2(tree.position);
    const float usual = usualHeight(species);
    crown.height = tree.size.height > 0.0f ? static_cast<double>(tree.size.height)
                   : usual > 0.0f          ? static_cast<double>(usual)
                                           : usualTree;
    const float width = withCrown(tree.size, species.crown, false).crownWidth;
    crown.radius = width > 0.0f ? 0.5 * static_cast<double>(width) : 0.5 * usualCrown * crown.height;
    return crown;
}

glm::dvec2 directionOf(std::size_t side) {
    const double azimuth = glm::two_pi<double>() * (static_cast<double>(side) + 0.5) / sides;
    return {std::cos(azimuth), std::sin(azimuth)};
}

/// Crowns in square cells.
class Crowns {
public:
    explicit Crowns(std::vector<Crown> crowns) : _crowns(std::move(crowns)) {
        for (std::size_t i = 0; i < _crowns.size(); ++i) {
            _cells[cellOf(_crowns[i].place)].push_back(i);
            _reach = std::max(_reach, _crowns[i].radius + gap * _crowns[i].height);
        }
    }

    /// On which a tree has neighbours.
    Sides shadedSides(std::size_t tree) const {
        Sides shaded;
        eachNeighbour(tree, [&](std::size_t other) { shaded |= sidesOf(_crowns[tree], _crowns[other]); });
        return shaded;
    }

    template <typename Use>
    void eachNeighbour(std::size_t tree, const Use& use) const {
        const Crown& own = _crowns[tree];
        const double reach = own.radius + _reach;
        const Cell low = cellOf(own.place - reach), high = cellOf(own.place + reach);
        for (std::int64_t x = low.first; x <= high.first; ++x)
            for (auto cell = _cells.lower_bound({x, low.second});
                 cell != _cells.end() && cell->first <= Cell(x, high.second); ++cell)
                for (const std::size_t other : cell->second)
                    if (other != tree && isNeighbour(own, _crowns[other]))
                        use(other);
    }
    double distance(std::size_t a, std::size_t b) const {
        return glm::distance(_crowns[a].place, _crowns[b].place);
    }

private:
    using Cell = std::pair<std::int64_t, std::int64_t>;

    static Cell cellOf(const glm::dvec2& place) {
        const glm::dvec2 cell = glm::floor(place / cellSize);
        return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y)};
    }
    static bool isNeighbour(const Crown& own, const Crown& other) {
        const double distance = glm::distance(own.place, other.place);
        return other.height >= asHigh * own.height &&
               distance <= own.radius + other.radius + gap * other.height;
    }
    /// That a neighbour's crown takes, as it is seen from the trunk, and those beside its middle.
    static Sides sidesOf(const Crown& own, const Crown& other) {
        const glm::dvec2 way = other.place - own.place;
        const double distance = glm::length(way);
        if (!(distance > 0.0))
            return Sides().set();
        const double seen = std::asin(std::min(other.radius / distance, 1.0));
        const double most = std::cos(std::max(seen, glm::two_pi<double>() / sides));
        Sides taken;
        for (std::size_t side = 0; side < sides; ++side)
            taken[side] = glm::dot(directionOf(side), way / distance) >= most;
        return taken;
    }

    std::vector<Crown> _crowns;
    std::map<Cell, std::vector<std::size_t>> _cells;
    double _reach = 0.0;
};

void settle(TreePlacement& tree, const Sides& shaded, bool mayTurn) {
    const double share = static_cast<double>(shaded.count()) / sides;
    glm::dvec2 open(0.0);
    for (std::size_t side = 0; side < sides; ++side)
        if (!shaded[side])
            open += directionOf(side) / static_cast<double>(sides);
    tree.openGrown = share <= openTo;
    tree.atEdge = false;
    if (share <= openTo || share >= closedFrom)
        return;
    if (glm::length(open) < oneSided) { // of a row
        tree.openGrown = share < 0.5;
    } else if (mayTurn) {
        tree.atEdge = true;
        tree.heading = static_cast<float>(std::atan2(open.y, open.x));
    }
}

/// Else no crown need be looked at.
bool anyGrowsByLight(const ForestDescription& forest) {
    return std::any_of(forest.species.begin(), forest.species.end(), growsByLight);
}

Crowns crownsOf(const ForestDescription& forest) {
    std::vector<Crown> all;
    for (const TreePlacement& tree : forest.trees)
        all.push_back(crownOf(tree, forest.species[tree.species]));
    return Crowns(std::move(all));
}

} // namespace

void findCompany(ForestDescription& forest, const std::vector<UnsaidOfTree>& unsaid) {
    if (!anyGrowsByLight(forest))
        return;
    const Crowns crowns = crownsOf(forest);
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        TreePlacement& tree = forest.trees[i];
        if (unsaid[i].company && growsByLight(forest.species[tree.species]))
            settle(tree, crowns.shadedSides(i), unsaid[i].heading);
    }
}

void tellApart(ForestDescription& forest, const std::vector<UnsaidOfTree>& unsaid) {
    if (!anyGrowsByLight(forest))
        return;
    const Crowns crowns = crownsOf(forest);
    const ShapeFamilies families(forest);
    std::vector<std::size_t> familyOf;
    for (const TreePlacement& tree : forest.trees)
        familyOf.push_back(families.indexOf(tree));
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        TreePlacement& tree = forest.trees[i];
        const std::uint32_t shapes = families.all()[familyOf[i]].shapes;
        if (!unsaid[i].seed || shapes < 2 || !growsByLight(forest.species[tree.species]))
            continue;
        std::vector<double> nearest(shapes, std::numeric_limits<double>::max()); // that has each shape
        crowns.eachNeighbour(i, [&](std::size_t other) {
            if (familyOf[other] == familyOf[i] && (other < i || !unsaid[other].seed)) {
                double& distance = nearest[forest.trees[other].seed % shapes];
                distance = std::min(distance, crowns.distance(i, other));
            }
        });
        tree.seed = std::min(tree.seed, std::numeric_limits<std::uint32_t>::max() - shapes);
        std::uint32_t best = 0;
        for (std::uint32_t more = 1; more < shapes; ++more)
            if (nearest[(tree.seed + more) % shapes] > nearest[(tree.seed + best) % shapes])
                best = more;
        tree.seed += best;
    }
}

} // namespace osgTreeWind

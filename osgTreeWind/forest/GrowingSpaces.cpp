// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/GrowingSpaces.h>

#include <osgTreeWind/base/PortableMath.h>
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
#include <cstdlib>
#include <limits>
#include <unordered_map>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr std::size_t sectorCount = 16;
using Sectors = std::bitset<sectorCount>;

constexpr double minNeighbourHeight = 0.6; // relative to the tree's height
constexpr double maxCrownGap = 0.5;        // between two crowns, relative to the neighbour's height
constexpr double minClosedShare = 0.75;    // share of sectors with neighbours, in a stand
constexpr double maxOpenShare = 0.25;      // share of sectors with neighbours, open-grown
constexpr double minOneSidedness = 0.2;    // length of the sum of open directions, divided by sectorCount
constexpr double defaultCrownWidth = 0.4;  // relative to the height
constexpr double defaultTreeHeight = 15.0; // metres
constexpr double bucketSize = 16.0;        // metres

glm::dvec2 directionOf(std::size_t sector) {
    const double azimuth = glm::two_pi<double>() * (static_cast<double>(sector) + 0.5) / sectorCount;
    return {math::cos(azimuth), math::sin(azimuth)};
}

/// A spatial index of crowns in square cells.
class CrownIndex {
public:
    explicit CrownIndex(std::vector<Crown> crowns) : _crowns(std::move(crowns)) {
        for (std::size_t i = 0; i < _crowns.size(); ++i) {
            _cells[cellOf(_crowns[i].position)].push_back(i);
            _reach = std::max(_reach, _crowns[i].radius + maxCrownGap * _crowns[i].height);
        }
    }

    /// The sectors in which a tree has neighbours.
    Sectors shadedSectors(std::size_t tree) const {
        Sectors shaded;
        eachNeighbour(
            tree, [&](std::size_t other) { shaded |= sectorsBehind(_crowns[tree], _crowns[other]); },
            [&](double) { return shaded.all(); });
        return shaded;
    }

    /// Visits the neighbours of a tree, in rings of cells around it. @param isDone whether the remaining
    /// neighbours, which are at least a distance away, do not matter.
    template <typename Use, typename IsDone>
    void eachNeighbour(std::size_t tree, const Use& use, const IsDone& isDone) const {
        const Crown& own = _crowns[tree];
        const Cell centre = cellOf(own.position);
        const auto rings = static_cast<std::int64_t>(std::ceil((own.radius + _reach) / bucketSize));
        for (std::int64_t ring = 0; ring <= rings; ++ring) {
            if (isDone(bucketSize * static_cast<double>(ring - 1)))
                return;
            for (std::int64_t x = -ring; x <= ring; ++x)
                for (std::int64_t y = -ring; y <= ring; y += std::abs(x) == ring ? 1 : 2 * ring)
                    if (const auto cell = _cells.find({centre.first + x, centre.second + y});
                        cell != _cells.end())
                        for (const std::size_t other : cell->second)
                            if (other != tree && isNeighbour(own, _crowns[other]))
                                use(other);
        }
    }
    double distance(std::size_t a, std::size_t b) const {
        return glm::distance(_crowns[a].position, _crowns[b].position);
    }

private:
    using Cell = std::pair<std::int64_t, std::int64_t>;
    struct CellHash {
        std::size_t operator()(const Cell& cell) const {
            return static_cast<std::uint64_t>(cell.first) * 0x9e3779b97f4a7c15u +
                   static_cast<std::uint64_t>(cell.second);
        }
    };

    static Cell cellOf(const glm::dvec2& position) {
        const glm::dvec2 cell = glm::floor(position / bucketSize);
        return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y)};
    }
    static bool isNeighbour(const Crown& own, const Crown& other) {
        const double distance = glm::distance(own.position, other.position);
        return other.height >= minNeighbourHeight * own.height &&
               distance <= own.radius + other.radius + maxCrownGap * other.height;
    }
    /// The sectors that a neighbour's crown covers as seen from the trunk, at least those next to its centre.
    static Sectors sectorsBehind(const Crown& own, const Crown& other) {
        const glm::dvec2 offset = other.position - own.position;
        const double distance = glm::length(offset);
        if (!(distance > 0.0))
            return Sectors().set();
        const double halfAngle = math::asin(std::min(other.radius / distance, 1.0));
        const double minCosine = math::cos(std::max(halfAngle, glm::two_pi<double>() / sectorCount));
        Sectors covered;
        for (std::size_t sector = 0; sector < sectorCount; ++sector)
            covered[sector] = glm::dot(directionOf(sector), offset / distance) >= minCosine;
        return covered;
    }

    std::vector<Crown> _crowns;
    std::unordered_map<Cell, std::vector<std::size_t>, CellHash> _cells;
    double _reach = 0.0;
};

void assignGrowingSpace(TreePlacement& tree, const Sectors& shaded, bool mayRotate) {
    const double share = static_cast<double>(shaded.count()) / sectorCount;
    glm::dvec2 open(0.0);
    for (std::size_t sector = 0; sector < sectorCount; ++sector)
        if (!shaded[sector])
            open += directionOf(sector) / static_cast<double>(sectorCount);
    tree.openGrown = share <= maxOpenShare;
    tree.atEdge = false;
    if (share <= maxOpenShare || share >= minClosedShare)
        return;
    if (glm::length(open) < minOneSidedness) { // a tree in a row
        tree.openGrown = share < 0.5;
    } else if (mayRotate) {
        tree.atEdge = true;
        tree.heading = static_cast<float>(math::atan2(open.y, open.x));
    }
}

bool anyGrowsByLight(const ForestDescription& forest) {
    return std::any_of(forest.species.begin(), forest.species.end(), growsByLight);
}

CrownIndex indexCrowns(const ForestDescription& forest) {
    std::vector<Crown> all;
    for (const TreePlacement& tree : forest.trees)
        all.push_back(crownOf(tree, forest.species[tree.species]));
    return CrownIndex(std::move(all));
}

} // namespace

Crown crownOf(const TreePlacement& tree, const Species& species) {
    Crown crown;
    crown.position = glm::dvec2(tree.position);
    const float usual = usualHeight(species);
    crown.height = tree.size.height > 0.0f ? static_cast<double>(tree.size.height)
                   : usual > 0.0f          ? static_cast<double>(usual)
                                           : defaultTreeHeight;
    const float width = withCrown(tree.size, species.crown, false).crownWidth;
    crown.radius = width > 0.0f ? 0.5 * static_cast<double>(width) : 0.5 * defaultCrownWidth * crown.height;
    return crown;
}

void findGrowingSpaces(ForestDescription& forest, const std::vector<DerivedTreeValues>& derived) {
    if (!anyGrowsByLight(forest))
        return;
    const CrownIndex crowns = indexCrowns(forest);
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        TreePlacement& tree = forest.trees[i];
        if (derived[i].growingSpace && growsByLight(forest.species[tree.species]))
            assignGrowingSpace(tree, crowns.shadedSectors(i), derived[i].heading);
    }
}

void varyNeighbourSeeds(ForestDescription& forest, const ShapeFamilies& families,
                        const std::vector<DerivedTreeValues>& derived) {
    if (!anyGrowsByLight(forest))
        return;
    const CrownIndex crowns = indexCrowns(forest);
    std::vector<std::size_t> familyOf;
    for (const TreePlacement& tree : forest.trees)
        familyOf.push_back(families.indexOf(tree));
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        TreePlacement& tree = forest.trees[i];
        const std::uint32_t shapes = families.all()[familyOf[i]].shapes;
        if (!derived[i].seed || shapes < 2 || !growsByLight(forest.species[tree.species]))
            continue;
        // Distance of the nearest neighbour with each shape.
        std::vector<double> nearest(shapes, std::numeric_limits<double>::max());
        crowns.eachNeighbour(
            i,
            [&](std::size_t other) {
                if (familyOf[other] == familyOf[i] && (other < i || !derived[other].seed)) {
                    double& distance = nearest[forest.trees[other].seed % shapes];
                    distance = std::min(distance, crowns.distance(i, other));
                }
            },
            [&](double distance) { return *std::max_element(nearest.begin(), nearest.end()) <= distance; });
        tree.seed = std::min(tree.seed, std::numeric_limits<std::uint32_t>::max() - shapes);
        std::uint32_t best = 0;
        for (std::uint32_t increase = 1; increase < shapes; ++increase)
            if (nearest[(tree.seed + increase) % shapes] > nearest[(tree.seed + best) % shapes])
                best = increase;
        tree.seed += best;
    }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/MakeCanopyMap.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/wind/SwingingWind.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace osgTreeWind {

namespace {

/// Reach of a stand, in tree heights: the distance behind an edge over which momentum of the open wind gets
/// down into the stand (Stacey et al. 1994, Gardiner et al. 1997).
constexpr float reachInHeights = 2.0f;
constexpr float cellsPerReach = 4.0f;
constexpr float endless = 1e9f; // metres
constexpr float maxMapCells = 0x1p20f, farthestCell = 0x1p23f;

/// Sums over the trees around a place, per ground area.
struct StandSum {
    float crownArea = 0.0f;
    float frontalArea = 0.0f, height = 0.0f; ///< `height` is weighted by frontalArea.
    std::array<float, CanopyTree::layers> drag{};
    /// The first three are weighted by drag.
    float streamlining = 0.0f, breezeStreamlining = 0.0f, streamlinedTo = 0.0f, allDrag = 0.0f;

    void add(const CanopyTree& tree, float share) {
        crownArea += share * tree.crownArea;
        frontalArea += share * tree.frontalArea;
        height += share * tree.frontalArea * tree.height;
        for (std::size_t i = 0; i < drag.size(); ++i) {
            drag[i] += share * tree.drag[i];
            allDrag += share * tree.drag[i];
            streamlining += share * tree.drag[i] * tree.streamlining;
            breezeStreamlining += share * tree.drag[i] * tree.breezeStreamlining;
            streamlinedTo += share * tree.drag[i] * tree.streamlinedTo;
        }
    }
};

/// Shelter factor s at which s^2 times the streamlined share of drag falls to `share`. Newton's method in
/// logarithms, in which drag is piecewise linear. @param wind m/s, without shelter.
float solveShelter(const StandSum& sum, float wind, float share) {
    const float exponent = sum.streamlining / sum.allDrag, breeze = sum.breezeStreamlining / sum.allDrag,
                upTo = sum.streamlinedTo / sum.allDrag;
    float shelter = 1.0f;
    for (int i = 0; i < 5; ++i) {
        const float felt = shelter * wind, factor = Laws().streamlinedShare(exponent, breeze, upTo, felt);
        const float missing = share / (shelter * shelter * factor);
        if (i == 0 && missing >= 1.0f)
            return 1.0f; // sparse crowns take less than the share
        const float slope = 2.0f - (felt < 1.6f || felt > upTo ? 0.0f : felt < 10.0f ? breeze : exponent);
        shelter = std::min(shelter * math::pow(missing, 1.0f / slope), 1.0f);
    }
    return shelter;
}

/// The cell of a stand with `factor` times the drag of `sum`.
CanopyCell makeCell(const StandSum& sum, float height, float frontalArea, float factor) {
    CanopyCell cell;
    cell.closure = closureOf(frontalArea);
    cell.crownCover = std::min(factor * sum.crownArea, 1.0f);
    cell.profile = CanopyProfile::ofStand(height, frontalArea);
    cell.shelter.fill(1.0f);
    float taken = 0.0f; // momentum over the squared mean at the top, for crowns in free air
    for (std::size_t i = 0; i < CanopyTree::layers; ++i) {
        const float z = (static_cast<float>(i) + 0.5f) / static_cast<float>(CanopyTree::layers) * height;
        const SwingingWind wind(cell.profile.mean(z), cell.profile.spread(z), cell.profile.skewness(z));
        taken += factor * sum.drag[i] * wind.meanPressure();
    }
    const float drag = factor * sum.allDrag;
    if (!(taken > 0.0f))
        return cell;
    const float flows = cell.profile.friction * cell.profile.friction, felt = std::sqrt(taken / drag);
    for (std::size_t s = 0; s < CanopyCell::speedCount; ++s)
        cell.shelter[s] =
            solveShelter(sum, felt * static_cast<float>(s) * CanopyCell::speedStep, flows / taken);
    return cell;
}

/// Mean tree height, weighted by frontal area.
struct MeanHeight {
    float areas = 0.0f, heights = 0.0f;

    void add(const std::vector<CanopyTree>& trees) {
        for (const CanopyTree& tree : trees) {
            areas += tree.frontalArea;
            heights += tree.frontalArea * tree.height;
        }
    }
    /// Radius over which trees count toward a stand, metres.
    float reach() const { return areas > 0.0f ? reachInHeights * heights / areas : 0.0f; }
};

/// A map of empty cells under the trees; cells are enlarged until their number is within the limit.
CanopyMap makeEmptyMap(const std::vector<CanopyTree>& trees, float reach) {
    glm::vec2 low = trees.front().place, high = low, first, count;
    for (const CanopyTree& tree : trees) {
        low = glm::min(low, tree.place);
        high = glm::max(high, tree.place);
    }
    CanopyMap map;
    map.fetch = std::max(reach, 2.0f);
    const auto fitsLimits = [&] {
        map.cell = map.fetch / cellsPerReach;
        first = glm::floor((low - map.fetch) / map.cell);
        count = glm::ceil((high + map.fetch) / map.cell) - first + 1.0f;
        const glm::vec2 farthest = glm::max(glm::abs(first), glm::abs(first + count));
        return count.x * count.y <= maxMapCells && std::max(farthest.x, farthest.y) <= farthestCell;
    };
    while (!fitsLimits())
        map.fetch *= 1.5f;
    map.first = first;
    map.width = static_cast<int>(count.x);
    map.length = static_cast<int>(count.y);
    return map;
}

/// Adds a tree to the cells around it, with a weight that falls with distance.
void addToCells(const CanopyTree& tree, const CanopyMap& map, std::vector<StandSum>& sums) {
    const glm::vec2 at = tree.place / map.cell;
    const auto cells = static_cast<int>(cellsPerReach);
    const glm::ivec2 place = glm::ivec2(glm::floor(at)) - map.first;
    for (int j = std::max(place.y - cells, 0); j <= std::min(place.y + cells + 1, map.length - 1); ++j)
        for (int i = std::max(place.x - cells, 0); i <= std::min(place.x + cells + 1, map.width - 1); ++i) {
            const glm::vec2 off = (glm::vec2(map.first + glm::ivec2(i, j)) - at) / cellsPerReach;
            const float rest = 1.0f - off.x * off.x - off.y * off.y;
            if (rest > 0.0f)
                sums[static_cast<std::size_t>(j) * static_cast<std::size_t>(map.width) +
                     static_cast<std::size_t>(i)]
                    .add(tree, 3.0f * rest * rest / (glm::pi<float>() * map.fetch * map.fetch));
        }
}

/// Sorts trees by position, so that sums do not depend on the order of the trees.
std::vector<const CanopyTree*> sortedByPosition(const std::vector<CanopyTree>& trees) {
    std::vector<const CanopyTree*> order(trees.size());
    std::transform(trees.begin(), trees.end(), order.begin(), [](const CanopyTree& tree) { return &tree; });
    std::sort(order.begin(), order.end(), [](const CanopyTree* a, const CanopyTree* b) {
        return std::tie(a->place.y, a->place.x, a->height, a->frontalArea) <
               std::tie(b->place.y, b->place.x, b->height, b->frontalArea);
    });
    return order;
}

/// Mean over stands, weighted by closure.
struct MeanStand {
    float weights = 0.0f, areas = 0.0f, heights = 0.0f;

    float height() const { return heights / weights; }
    float area() const { return areas / weights; }
    void add(const MeanStand& other) {
        weights += other.weights;
        areas += other.areas;
        heights += other.heights;
    }
};

/// Side of a square that these trees fill at the density of their stands, metres.
float extentOf(const MeanHeight& trees, const MeanStand& usual) {
    return usual.weights > 0.0f ? std::sqrt(trees.areas / usual.area()) : 0.0f;
}

/// The trees around each cell.
std::vector<StandSum> sumAround(const CanopyMap& map, const std::vector<CanopyTree>& trees) {
    std::vector<StandSum> sums(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.length));
    for (const CanopyTree* tree : sortedByPosition(trees))
        addToCells(*tree, map, sums);
    return sums;
}

/// Fills the cells from the trees. @return the mean of the stands.
MeanStand fillCells(CanopyMap& map, const std::vector<CanopyTree>& trees) {
    const std::vector<StandSum> sums = sumAround(map, trees);
    MeanStand usual;
    map.cells.reserve(sums.size());
    for (const StandSum& sum : sums) {
        map.cells.emplace_back();
        if (!(sum.frontalArea > 0.0f))
            continue;
        const float height = sum.height / sum.frontalArea;
        map.cells.back() = makeCell(sum, height, sum.frontalArea, 1.0f);
        const float weight = map.cells.back().closure;
        usual.add({weight, weight * sum.frontalArea, weight * height});
    }
    return usual;
}

} // namespace

CanopyTree::CanopyTree(const PlacedForest& forest, const PlacedTree& tree) : place(tree.position) {
    const TreeModel& model = forest.modelOf(tree);
    const TreeScale& scale = tree.scale;
    const Species& species = forest.speciesOf(tree);
    height = scale.axes.z * model.skeleton.height();
    streamlinedTo = species.wood.streamlinedTo;
    const float width = measureTree(model, scale).crownWidth;
    crownArea = 0.25f * glm::pi<float>() * width * width;
    const std::vector<UnitLoad> loads = makeAirLoads(model, scale, species, tree.leaves);
    float leafDrag = 0.0f, allDrag = 0.0f;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const ScaledUnit unit(model.skeleton.units[i], scale);
        const float half = 0.5f * (loads[i].woodDrag + loads[i].leafDrag);
        const float layer = static_cast<float>(layers) * unit.middle().z / std::max(height, 1e-3f);
        drag[static_cast<std::size_t>(std::clamp(layer, 0.0f, static_cast<float>(layers - 1)))] += half;
        allDrag += half;
        leafDrag += 0.5f * loads[i].leafDrag;
        frontalArea += 0.5f * loads[i].leafArea + 0.5f * (unit.baseDiameter + unit.tipDiameter) * unit.length;
    }
    const float foliage = allDrag > 0.0f ? leafDrag / allDrag : 0.0f;
    streamlining = foliage * species.wood.streamlining;
    breezeStreamlining = foliage * species.wood.breezeStreamlining;
}

std::shared_ptr<CanopyMap> makeCanopyMap(const std::vector<CanopyTree>& trees, const CanopySettings& canopy) {
    if (canopy.source == CanopySource::Given) {
        auto map = makeUniformCanopyMap(trees, static_cast<float>(canopy.height),
                                        static_cast<float>(canopy.frontalArea));
        map->extent = canopy.extent > 0.0 ? static_cast<float>(canopy.extent) : endless;
        return map;
    }
    if (trees.empty())
        return std::make_shared<CanopyMap>();
    MeanHeight mean;
    mean.add(trees);
    CanopyMap map = makeEmptyMap(trees, canopy.reach > 0.0 ? static_cast<float>(canopy.reach) : mean.reach());
    const MeanStand usual = fillCells(map, trees);
    if (usual.weights > 0.0f) {
        map.usual.profile = CanopyProfile::ofStand(
            canopy.usualHeight > 0.0 ? static_cast<float>(canopy.usualHeight) : usual.height(),
            canopy.usualFrontalArea > 0.0 ? static_cast<float>(canopy.usualFrontalArea) : usual.area());
    }
    map.usual.closure = std::min(usual.weights, 1.0f);
    map.extent = canopy.extent > 0.0 ? static_cast<float>(canopy.extent) : extentOf(mean, usual);
    return std::make_shared<CanopyMap>(std::move(map));
}

CanopySettings withCanopyStatistics(CanopySettings canopy, const std::vector<std::vector<CanopyTree>>& parts,
                                    std::size_t trees) {
    MeanHeight mean;
    double sampled = 0.0; // trees
    for (const std::vector<CanopyTree>& part : parts) {
        mean.add(part);
        sampled += static_cast<double>(part.size());
    }
    MeanStand usual;
    for (const std::vector<CanopyTree>& part : parts) {
        if (part.empty())
            continue;
        CanopyMap map = makeEmptyMap(part, mean.reach());
        usual.add(fillCells(map, part));
        for (const CanopyCell& cell : map.cells)
            canopy.reference = std::max(canopy.reference, static_cast<double>(cell.profile.height));
    }
    canopy.reach = static_cast<double>(mean.reach());
    if (usual.weights > 0.0f) {
        canopy.usualHeight = static_cast<double>(usual.height());
        canopy.usualFrontalArea = static_cast<double>(usual.area());
        if (!(canopy.extent > 0.0))
            canopy.extent =
                static_cast<double>(extentOf(mean, usual)) * std::sqrt(static_cast<double>(trees) / sampled);
    }
    return canopy;
}

std::shared_ptr<CanopyMap> makeUniformCanopyMap(const std::vector<CanopyTree>& trees, float height,
                                                float frontalArea) {
    StandSum sum;
    for (const CanopyTree& tree : trees)
        sum.add(tree, 1.0f);
    auto map = std::make_shared<CanopyMap>();
    map->usual =
        makeCell(sum, height, frontalArea, sum.frontalArea > 0.0f ? frontalArea / sum.frontalArea : 0.0f);
    map->isUniform = true;
    return map;
}

StandLeaves meanStandOf(const std::vector<CanopyTree>& trees) {
    StandLeaves leaves;
    MeanHeight mean;
    mean.add(trees);
    if (trees.empty() || !(mean.areas > 0.0f))
        return leaves;
    MeanStand stand;
    leaves.drag.resize(CanopyTree::layers);
    for (const StandSum& sum : sumAround(makeEmptyMap(trees, mean.reach()), trees)) {
        if (!(sum.frontalArea > 0.0f))
            continue;
        const float weight = closureOf(sum.frontalArea), area = weight * sum.frontalArea;
        stand.add({weight, area, weight * (sum.height / sum.frontalArea)});
        for (std::size_t i = 0; i < leaves.drag.size(); ++i)
            leaves.drag[i] += sum.drag[i] * area;
    }
    leaves.height = stand.height();
    for (float& layer : leaves.drag)
        layer /= stand.areas;
    return leaves;
}

double shelterReach(const CanopySettings& canopy) {
    constexpr double crown = 20.0; // a patch samples the wind beside the foot of its tree, between four cells
    return (2.0 + 2.0 / static_cast<double>(cellsPerReach)) * canopy.reach + crown;
}

} // namespace osgTreeWind

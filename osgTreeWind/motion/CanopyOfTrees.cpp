// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/CanopyOfTrees.h>

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/wind/SwingingWind.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr float pi = 3.14159265f;
/// A stand counts as far as the momentum of the open takes to get down behind an edge, some heights (Stacey
/// et al. 1994, Gardiner et al. 1997): within two of a place that is two upwind.
constexpr float reachInHeights = 2.0f;
constexpr float cellsPerReach = 4.0f;
constexpr int mostCells = 1 << 20;

/// What trees around a place add up to, over the ground.
struct StandSum {
    float crownArea = 0.0f;
    float frontalArea = 0.0f, height = 0.0f; ///< The latter times the former.
    std::array<float, StandTree::layers> drag{};
    /// The former three times the latter.
    float streamlining = 0.0f, breezeStreamlining = 0.0f, streamlinedTo = 0.0f, allDrag = 0.0f;

    void add(const StandTree& tree, float share) {
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

/// With `factor` times its drag.
CanopyCell cellOf(const StandSum& sum, float height, float frontalArea, float factor) {
    CanopyCell cell;
    cell.closure = closureOf(frontalArea);
    cell.crowns = std::min(factor * sum.crownArea, 1.0f);
    cell.profile = CanopyProfile::over(height, frontalArea);
    cell.shelter.fill(1.0f);
    float taken = 0.0f; // over the mean's square at the top, if crowns stood in free air
    for (std::size_t i = 0; i < StandTree::layers; ++i) {
        const float z = (static_cast<float>(i) + 0.5f) / static_cast<float>(StandTree::layers) * height;
        const SwingingWind wind(cell.profile.mean(z), cell.profile.spread(z), cell.profile.skewness(z));
        taken += factor * sum.drag[i] * wind.push();
    }
    const float drag = factor * sum.allDrag;
    if (!(taken > 0.0f))
        return cell;
    const float flows = cell.profile.friction * cell.profile.friction, felt = std::sqrt(taken / drag);
    for (std::size_t s = 0; s < CanopyCell::speeds; ++s) {
        const float top = static_cast<float>(s) * CanopyCell::speedStep;
        float low = 0.0f, high = 1.0f;
        for (int i = 0; i < 20; ++i) {
            const float shelter = 0.5f * (low + high);
            const float share =
                Laws().streamlinedShare(sum.streamlining / sum.allDrag, sum.breezeStreamlining / sum.allDrag,
                                        sum.streamlinedTo / sum.allDrag, shelter * felt * top);
            (shelter * shelter * taken * share < flows ? low : high) = shelter;
        }
        cell.shelter[s] = high;
    }
    return cell;
}

/// Ground under the trees, in cells.
struct StandGround {
    float reach = 10.0f;
    CanopyMap map;

    explicit StandGround(const std::vector<StandTree>& trees) {
        float area = 0.0f, heights = 0.0f;
        glm::vec2 low = trees.front().place, high = low;
        for (const StandTree& tree : trees) {
            area += tree.frontalArea;
            heights += tree.frontalArea * tree.height;
            low = glm::min(low, tree.place);
            high = glm::max(high, tree.place);
        }
        reach = std::max(area > 0.0f ? reachInHeights * heights / area : 0.0f, 2.0f);
        const auto cellsAt = [&](float cell) {
            const glm::vec2 count = glm::ceil((high - low + 2.0f * reach) / cell) + 1.0f;
            map.cell = cell;
            map.width = static_cast<int>(count.x);
            map.length = static_cast<int>(count.y);
            return count.x * count.y;
        };
        while (cellsAt(reach / cellsPerReach) > static_cast<float>(mostCells))
            reach *= 1.5f;
        map.corner = low - reach;
        map.fetch = reach;
    }

    /// Adds a tree to the ground around it, most to what is next to it.
    void spread(const StandTree& tree, std::vector<StandSum>& sums) const {
        const glm::vec2 at = (tree.place - map.corner) / map.cell;
        const auto cells = static_cast<int>(std::ceil(reach / map.cell));
        const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
        for (int j = std::max(y - cells, 0); j <= std::min(y + cells + 1, map.length - 1); ++j)
            for (int i = std::max(x - cells, 0); i <= std::min(x + cells + 1, map.width - 1); ++i) {
                const glm::vec2 off = (glm::vec2(i, j) - at) * (map.cell / reach);
                const float rest = 1.0f - off.x * off.x - off.y * off.y;
                if (rest > 0.0f)
                    sums[static_cast<std::size_t>(j) * static_cast<std::size_t>(map.width) +
                         static_cast<std::size_t>(i)]
                        .add(tree, 3.0f * rest * rest / (pi * reach * reach));
            }
    }
};

} // namespace

StandTree::StandTree(const TreeModel& model, const TreeScale& scale, const Species& species, float leaves,
                     const glm::vec2& at)
    : place(at), height(scale.axes.z * model.skeleton.height()), streamlinedTo(species.wood.streamlinedTo) {
    const float width = measureTree(model, scale).crownWidth;
    crownArea = 0.25f * pi * width * width;
    const std::vector<UnitLoad> loads = makeUnitLoads(model, scale, species, leaves);
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

std::shared_ptr<const CanopyMap> canopyOf(const std::vector<StandTree>& trees) {
    if (trees.empty())
        return std::make_shared<const CanopyMap>();
    StandGround ground(trees);
    CanopyMap& map = ground.map;
    std::vector<StandSum> sums(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.length));
    for (const StandTree& tree : trees)
        ground.spread(tree, sums);
    float weights = 0.0f, area = 0.0f, heights = 0.0f;
    map.cells.reserve(sums.size());
    for (const StandSum& sum : sums) {
        map.cells.emplace_back();
        if (!(sum.frontalArea > 0.0f))
            continue;
        const float height = sum.height / sum.frontalArea;
        map.cells.back() = cellOf(sum, height, sum.frontalArea, 1.0f);
        const float weight = map.cells.back().closure;
        weights += weight;
        area += weight * sum.frontalArea;
        heights += weight * height;
    }
    if (weights > 0.0f)
        map.usual.profile = CanopyProfile::over(heights / weights, area / weights);
    map.usual.closure = std::min(weights, 1.0f);
    return std::make_shared<const CanopyMap>(std::move(map));
}

std::shared_ptr<const CanopyMap> canopyOf(const std::vector<StandTree>& trees, float height,
                                          float frontalArea) {
    StandSum sum;
    for (const StandTree& tree : trees)
        sum.add(tree, 1.0f);
    auto map = std::make_shared<CanopyMap>();
    map->usual =
        cellOf(sum, height, frontalArea, sum.frontalArea > 0.0f ? frontalArea / sum.frontalArea : 0.0f);
    map->everywhere = true;
    return map;
}

} // namespace osgTreeWind

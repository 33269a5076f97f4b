// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {
namespace {

constexpr float cellSide = 12.0f;   // metres
constexpr int reach = 2;            // cells in each direction in which crowns count
constexpr float middleShare = 0.7f; // height of the widest part of the crown over the tree's height
constexpr float topShare = 0.9f;    // height of Light::atTop over the tree's height
constexpr float crownDepth = 0.45f; // optical depth of a crown of density 1

} // namespace

glm::ivec2 NeighbourShade::cellAt(const glm::vec3& place) {
    constexpr float farthest = 1e9f;
    return glm::ivec2(glm::floor(glm::clamp(glm::vec2(place) / cellSide, -farthest, farthest)));
}

std::uint64_t NeighbourShade::keyOf(const glm::ivec2& cell) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x)) << 32 |
           static_cast<std::uint32_t>(cell.y);
}

template <typename Use>
void NeighbourShade::forEachNear(const glm::vec3& place, const Use& use) const {
    const glm::ivec2 middle = cellAt(place);
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const auto found = _cells.find(keyOf(middle + glm::ivec2(x, y)));
            if (found != _cells.end())
                for (const std::uint32_t slot : found->second)
                    use(slot);
        }
}

void NeighbourShade::markNeighboursStale(const glm::vec3& place) {
    forEachNear(place, [this](std::uint32_t slot) {
        if (!_trees[slot].isStale)
            _stale.push_back(slot);
        _trees[slot].isStale = true;
    });
}

void NeighbourShade::insert(std::uint32_t slot, const Crown& crown) {
    remove(slot);
    if (slot >= _trees.size())
        _trees.resize(slot + 1);
    _trees[slot].crown = crown;
    _trees[slot].isPresent = true;
    _cells[keyOf(cellAt(crown.foot))].push_back(slot);
    markNeighboursStale(crown.foot);
}

void NeighbourShade::remove(std::uint32_t slot) {
    if (slot >= _trees.size() || !_trees[slot].isPresent)
        return;
    Tree& tree = _trees[slot];
    Cell& cell = _cells[keyOf(cellAt(tree.crown.foot))];
    cell.erase(std::find(cell.begin(), cell.end(), slot));
    tree.isPresent = false;
    markNeighboursStale(tree.crown.foot);
}

/// Sums the view factors of the crowns, taken as small horizontal discs, to an optical depth.
float NeighbourShade::lightAt(std::uint32_t slot, float height) const {
    const Crown& own = _trees[slot].crown;
    const glm::vec3 place = own.foot + glm::vec3(0.0f, 0.0f, height);
    float depth = 0.0f;
    forEachNear(own.foot, [&](std::uint32_t other) {
        const Crown& crown = _trees[other].crown;
        const float above = crown.foot.z + middleShare * crown.height - place.z;
        if (other == slot || !(above > 0.0f))
            return;
        const glm::vec2 aside = glm::vec2(crown.foot) - glm::vec2(place);
        const float distance2 = glm::dot(aside, aside) + above * above, radius = crown.radius * crown.radius;
        depth += crown.density * std::min(radius * above * above / (distance2 * distance2), 1.0f);
    });
    return math::exp(-crownDepth * depth);
}

void NeighbourShade::update() {
    for (const std::uint32_t slot : _stale) {
        Tree& tree = _trees[slot];
        tree.isStale = false;
        if (tree.isPresent)
            tree.light = {lightAt(slot, 0.0f), lightAt(slot, topShare * tree.crown.height)};
    }
    _stale.clear();
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr float cellSide = 12.0f;   // metres
constexpr int reach = 2;            // cells each way beyond which no crown counts
constexpr float middleShare = 0.7f; // of the height of a tree, where its crown is widest
constexpr float topShare = 0.9f;    // of the height at which its top is lit
constexpr float crownDepth = 0.8f;  // optical, of a crown that keeps all

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
void NeighbourShade::around(const glm::vec3& place, const Use& use) const {
    const glm::ivec2 middle = cellAt(place);
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const auto found = _cells.find(keyOf(middle + glm::ivec2(x, y)));
            if (found != _cells.end())
                for (const std::uint32_t number : found->second)
                    use(number);
        }
}

void NeighbourShade::markAround(const glm::vec3& place) {
    around(place, [this](std::uint32_t number) {
        if (!_trees[number].stale)
            _stale.push_back(number);
        _trees[number].stale = true;
    });
}

void NeighbourShade::put(std::uint32_t number, const Crown& crown) {
    take(number);
    if (number >= _trees.size())
        _trees.resize(number + 1);
    _trees[number].crown = crown;
    _trees[number].here = true;
    _cells[keyOf(cellAt(crown.foot))].push_back(number);
    markAround(crown.foot);
}

void NeighbourShade::take(std::uint32_t number) {
    if (number >= _trees.size() || !_trees[number].here)
        return;
    Tree& tree = _trees[number];
    Cell& cell = _cells[keyOf(cellAt(tree.crown.foot))];
    cell.erase(std::find(cell.begin(), cell.end(), number));
    tree.here = false;
    markAround(tree.crown.foot);
}

/// Crowns hide as much of the sky as level discs do (the view factor of a small one), which add up as an
/// optical depth.
float NeighbourShade::leftAt(std::uint32_t number, float height) const {
    const Crown& own = _trees[number].crown;
    const glm::vec3 place = own.foot + glm::vec3(0.0f, 0.0f, height);
    float depth = 0.0f;
    around(own.foot, [&](std::uint32_t other) {
        const Crown& crown = _trees[other].crown;
        const float above = crown.foot.z + middleShare * crown.height - place.z;
        if (other == number || !(above > 0.0f))
            return;
        const glm::vec2 aside = glm::vec2(crown.foot) - glm::vec2(place);
        const float far = glm::dot(aside, aside) + above * above, radius = crown.radius * crown.radius;
        depth += crown.density * std::min(radius * above * above / (far * far), 1.0f);
    });
    return std::exp(-crownDepth * depth);
}

void NeighbourShade::update() {
    for (const std::uint32_t number : _stale) {
        Tree& tree = _trees[number];
        tree.stale = false;
        if (tree.here)
            tree.left = {leftAt(number, 0.0f), leftAt(number, topShare * tree.crown.height)};
    }
    _stale.clear();
}

} // namespace osgTreeWind

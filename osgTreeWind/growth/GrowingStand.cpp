// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowingStand.h>

#include <algorithm>

namespace osgTreeWind {
namespace {

/// Height of neighbours that do not grow here / height of the tree among them.
constexpr float neighbourHeight = 0.94f;
/// Distance between seedlings / between the grown trees.
constexpr float seedlingDistance = 0.4f;

} // namespace

float lightCellSize(const TreeHabit& habit) {
    return std::clamp(1.8f * habit.internode[0], 0.3f, 1.0f);
}

void GrowingStand::growYear(const GrowthSite& site) {
    if (_trees.empty())
        return;
    glm::vec3 lowest = _trees.front().foot(), highest = lowest;
    for (GrowingTree& tree : _trees)
        tree.unfoldLeaves(lowest, highest);
    _grid.reset(lowest, highest);
    for (const GrowingTree& tree : _trees)
        tree.addLeaves(_grid);
    const GrowingTree& first = _trees.front();
    GrowthSite now = site;
    now.distance *= glm::mix(seedlingDistance, 1.0f, first.state().relativeHeight());
    _grid.addNeighbours(now, glm::vec2(first.foot()) + first.state().crownCentre,
                        std::max(neighbourHeight * first.height(), 1.0f));
    _grid.computeLight();
    for (GrowingTree& tree : _trees)
        tree.growYear(_grid);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/SideBuds.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// Variation of vigour among the side shoots of the straightest species; crooked species have more.
constexpr float minVigourVariation = 0.2f;

/// Side buds of a node, and their weight among the other buds.
struct NodeBuds {
    int count;
    float weight;
};

NodeBuds nodeBuds(TreeState& tree, int order, float along, bool last) {
    const TreeHabit& habit = tree.habit;
    const int usual = habit.budsPerNode;
    if (habit.whorl <= 0.0f)
        return {usual, glm::mix(1.0f, along * along, habit.acrotony)};
    if (order > 0)
        return {usual, last ? 1.0f : habit.betweenWhorls};
    if (last)
        return {static_cast<int>(std::lround(habit.whorl + 0.8f * tree.random.symmetric())), 1.0f};
    return {std::max(usual, static_cast<int>(std::lround(0.5f * habit.whorl))), habit.betweenWhorls};
}

} // namespace

float triangular(Random& random) {
    const float one = random.symmetric();
    return 0.5f * (one + random.symmetric());
}

Bud& addSideBud(TreeState& tree, const BudPlace& place, int order) {
    const glm::vec3 left = directionOr(glm::cross(up, place.heading), perpendicular(place.heading));
    const glm::vec3 above = glm::cross(place.heading, left);
    const float round = 1.0f - tree.habit.flat[TreeState::rank(place.order)];
    const glm::vec3 aside =
        directionOr(cosine(place.azimuth) * left + round * sine(place.azimuth) * above, left);
    ShootAxis axis;
    axis.vigourFactor = 1.0f + (minVigourVariation + tree.habit.wander[1]) * triangular(tree.random);
    axis.order = order;
    axis.born = tree.year;
    Bud bud;
    bud.node = place.node;
    bud.heading = directionOr(cosine(place.angle) * place.heading + sine(place.angle) * aside, place.heading);
    bud.axis = static_cast<int>(tree.axes.size());
    tree.axes.push_back(axis);
    tree.buds.push_back(bud);
    return tree.buds.back();
}

void addSideBuds(TreeState& tree, const Bud& end, float along, bool last) {
    const TreeHabit& habit = tree.habit;
    const int order = tree.axisOf(end).order;
    if (order >= habit.deepest)
        return;
    const NodeBuds buds = nodeBuds(tree, order, along, last);
    if (buds.weight <= 0.0f)
        return;
    const bool whorl = habit.whorl > 0.0f && order == 0;
    float& phase = tree.axisOf(end).phase;
    phase += whorl ? whorlAngle : habit.divergence;
    BudPlace place{end.node, end.heading, order};
    const float first = phase;
    for (int i = 0; i < buds.count; ++i) {
        place.azimuth = first + (whorl ? 0.35f : 0.12f) * triangular(tree.random) +
                        glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(buds.count);
        place.angle = habit.branchAngle[TreeState::rank(order)] * (1.0f + 0.15f * triangular(tree.random));
        addSideBud(tree, place, order + 1).weight = buds.weight;
    }
}

} // namespace osgTreeWind

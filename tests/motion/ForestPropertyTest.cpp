// SPDX-License-Identifier: MIT
// The motion of a tree does not depend on the order, number or position of other trees.
#include <tests/motion/OneTree.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace osgTreeWind {

namespace {

/// A forest in a wind that varies in space and time.
ForestDescription anyForest(const glm::dvec3& origin) {
    ForestDescription forest;
    forest.species = {*findSpecies("birch"), *findSpecies("Norway spruce")};
    const int count = *rc::gen::inRange(1, 7);
    for (int i = 0; i < count; ++i) {
        TreePlacement tree;
        tree.species = *rc::gen::inRange<std::size_t>(0, 2);
        tree.position = origin + glm::dvec3(*rc::gen::inRange(0, 64), *rc::gen::inRange(0, 64), 0.0);
        tree.size.height = static_cast<float>(*rc::gen::inRange(3, 25));
        tree.seed = *rc::gen::inRange<std::uint32_t>(1, 100);
        forest.trees.push_back(tree);
    }
    const glm::vec3 corner(origin);
    const auto speed = static_cast<float>(*rc::gen::inRange(0, 20));
    forest.wind = std::make_shared<TestWind>([=](const glm::vec3& place, double time) {
        const glm::vec3 at = place - corner;
        return glm::vec3(speed * (1.0f + 0.5f * std::sin(0.1f * at.x + static_cast<float>(time))),
                         0.2f * speed * std::cos(0.07f * at.y), 0.0f);
    });
    return forest;
}

/// Leans after two seconds.
std::vector<glm::vec2> leansOf(const ForestDescription& forest) {
    ForestSimulation simulation(forest);
    run(simulation, 40, 0.0, 0.05);
    std::vector<glm::vec2> leans;
    for (std::size_t slot = 0; slot < movingForest(simulation).trees().size(); ++slot)
        leans.push_back(movingForest(simulation).modal()->lean(slot));
    return leans;
}

} // namespace

RC_GTEST_PROP(ForestProperty, TheOrderOfTreesDoesNotMatter, ()) {
    ForestDescription forest = anyForest(glm::dvec3(0.0));
    std::vector<std::size_t> order(forest.trees.size());
    std::iota(order.begin(), order.end(), 0u);
    const std::vector<glm::vec2> leans = leansOf(forest);
    std::reverse(order.begin(), order.end());
    const std::vector<TreePlacement> trees = forest.trees;
    for (std::size_t i = 0; i < order.size(); ++i)
        forest.trees[i] = trees[order[i]];
    const std::vector<glm::vec2> reversed = leansOf(forest);
    for (std::size_t i = 0; i < order.size(); ++i)
        RC_ASSERT(glm::distance(reversed[i], leans[order[i]]) <=
                  1e-6f + 1e-4f * glm::length(leans[order[i]]));
}

RC_GTEST_PROP(ForestProperty, ASingleTreeMovesAsInAForest, ()) {
    ForestDescription forest = anyForest(glm::dvec3(0.0));
    const std::vector<glm::vec2> leans = leansOf(forest);
    const auto kept = *rc::gen::inRange<std::size_t>(0, forest.trees.size());
    for (std::size_t i = 0; i < forest.trees.size(); ++i)
        if (i != kept)
            forest.trees[i].position.x += 5e4;
    RC_ASSERT(glm::distance(leansOf(forest)[kept], leans[kept]) <= 1e-6f + 1e-4f * glm::length(leans[kept]));
}

RC_GTEST_PROP(ForestProperty, AForestThatIsMovedWithItsWindMovesAlike, ()) {
    const glm::dvec3 moved(*rc::gen::inRange(-4096, 4096), *rc::gen::inRange(-4096, 4096), 0.0);
    ForestDescription there = anyForest(moved), here = there;
    const glm::vec3 shift(moved);
    const WindFieldPtr wind = there.wind.field;
    here.wind = std::make_shared<TestWind>([=](const glm::vec3& place, double time) {
        return wind->velocity(WindPlace(place + shift, 0.0f), time);
    });
    for (TreePlacement& tree : here.trees)
        tree.position -= moved;
    const std::vector<glm::vec2> a = leansOf(here), b = leansOf(there);
    for (std::size_t i = 0; i < a.size(); ++i)
        RC_ASSERT(glm::distance(a[i], b[i]) <= 1e-5f + 1e-3f * glm::length(a[i]));
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/growth/GrowthParameters.h>

#include <gtest/gtest.h>

#include <vector>

using namespace osgTreeWind;

namespace {

ForestDescription saplings() {
    ForestDescription forest;
    for (const char* name : {"one", "another"}) {
        Species species;
        species.name = name;
        species.shapes = 4;
        species.tree.growth = GrowthParameters();
        species.tree.growth->size = {3.0f, 0.05f, 2.0f};
        species.tree.growth->seed = static_cast<std::uint32_t>(100 * forest.species.size());
        forest.species.push_back(species);
        TreePlacement tree;
        tree.species = forest.trees.size();
        forest.trees.push_back(tree);
    }
    return forest;
}

/// What tells the shapes of a forest, which is gone afterwards: models are shared while one holds them.
std::vector<std::vector<glm::vec3>> shapesGrownBy(const Executor& executor) {
    const PlacedForest forest(saplings(), {}, executor);
    std::vector<std::vector<glm::vec3>> shapes;
    for (const auto& model : forest.models())
        shapes.push_back(model->skeleton.points);
    return shapes;
}

} // namespace

TEST(PlacedForest, HasTheSameShapesOnAnyNumberOfThreads) {
    const auto inTurn = shapesGrownBy(runInTurn);
    ASSERT_EQ(inTurn.size(), 8u);
    EXPECT_NE(inTurn[0], inTurn[1]);
    EXPECT_EQ(shapesGrownBy(ThreadPool::executor(2)), inTurn);
    EXPECT_EQ(shapesGrownBy(ThreadPool::executor(5)), inTurn);
    EXPECT_EQ(shapesGrownBy({}), inTurn);
}

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

/// Points of all shapes. The forest is destroyed afterwards, because models are shared while one exists.
std::vector<std::vector<glm::vec3>> shapesGrownBy(const Executor& executor) {
    const PlacedForest forest(saplings(), {}, executor);
    std::vector<std::vector<glm::vec3>> shapes;
    for (const auto& model : forest.models())
        shapes.push_back(model->skeleton.points);
    return shapes;
}

} // namespace

TEST(PlacedForest, ShapesDoNotDependOnTheNumberOfThreads) {
    const auto sequential = shapesGrownBy(runInTurn);
    ASSERT_EQ(sequential.size(), 8u);
    EXPECT_NE(sequential[0], sequential[1]);
    EXPECT_EQ(shapesGrownBy(ThreadPool::executor(2)), sequential);
    EXPECT_EQ(shapesGrownBy(ThreadPool::executor(5)), sequential);
    EXPECT_EQ(shapesGrownBy({}), sequential);
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/sway/FreeSwayTree.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/ShapeCount.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

TEST(SingleTreeForest, GrowsOnlyTheShapeOfItsSeed) {
    Species grownByLight;
    grownByLight.tree.growth = GrowthParameters();
    grownByLight.tree.growth->size = {4.0f, 0.08f, 2.0f};
    TreePlacement tree;
    tree.seed = 13;
    for (const Species& species : {Species(), grownByLight}) {
        const PlacedForest forest = makeSingleTreeForest(species, tree);
        ASSERT_EQ(forest.models().size(), 1u);
        const TreeModel shape = makeTreeModel(growthOf(species, false), 13 % shapeCount(species));
        EXPECT_EQ(forest.models().front()->skeleton.points, shape.skeleton.points);
        ASSERT_EQ(forest.models().front()->leaves.size(), shape.leaves.size());
        EXPECT_EQ(forest.models().front()->leaves[5].anchor, shape.leaves[5].anchor);
    }
}

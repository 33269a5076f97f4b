// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TextureCapacity.h>
#include <tests/MessageCollector.h>
#include <tests/drawing/branchwise/BranchwiseFixtures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

using namespace osgTreeWind;

namespace {

/// Trees of the reference species, with 122 units and 1,920 leaf clusters each.
ForestDescription referenceTrees(std::size_t trees) {
    ForestDescription description;
    description.species = {Species()};
    description.trees.resize(trees);
    description.law = MotionLaw::ThesisSmooth;
    return description;
}

} // namespace

TEST(BranchwiseForestTest, ReportsForestsThatExceedTheTextureCapacity) {
    EXPECT_EQ(textureCapacityProblem(referenceTrees(17476)), "");
    const std::string problem = textureCapacityProblem(referenceTrees(17477));
    EXPECT_EQ(problem,
              "17477 trees under a branchwise law need 33555840 texels of leaf angles; a texture holds "
              "33554432. The law modal has no such limit");
    ForestDescription bare = referenceTrees(100000);
    bare.species[0].tree.leaves.clustersPerBranch = 0;
    EXPECT_NE(textureCapacityProblem(bare).find("branch parameters"), std::string::npos);
    bare.law = MotionLaw::Modal;
    EXPECT_EQ(textureCapacityProblem(bare), "");
}

TEST(BranchwiseForestTest, RefusedDescriptionLeavesAnEmptyForestWithOneWarning) {
    const ScopedMessages messages;
    osg::ref_ptr<Forest> forest = new Forest(referenceTrees(20000));
    const std::string said = messages.take();
    EXPECT_EQ(said.rfind("osgTreeWind: the forest is left empty: 20000 trees", 0), 0u) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_EQ(forest->getNumTrees(), 0u);
}

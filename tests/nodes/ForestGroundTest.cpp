// SPDX-License-Identifier: MIT
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/places/FunctionGround.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(ForestGround, IsTheHostsToAdd) {
    ForestDescription description = smallForest(4);
    EXPECT_FALSE(osg::ref_ptr<Forest>(new Forest(description))->getGround());
    description.ground = std::make_shared<FunctionGround>([](double x, double) { return 0.1 * x; });
    const osg::ref_ptr<Forest> forest = new Forest(description);
    ASSERT_TRUE(forest->getGround());
    EXPECT_EQ(forest->getGround()->getNumParents(), 0u) << "not in the scene by itself";
    EXPECT_EQ(forest->getNumChildren(), 1u);
    const osg::ref_ptr<osg::Node> ground = forest->getGround();
    const osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    EXPECT_TRUE(copy->getGround());
    EXPECT_TRUE(forest->setDescription(smallForest(1)).empty());
    EXPECT_FALSE(forest->getGround());
}

} // namespace osgTreeWind

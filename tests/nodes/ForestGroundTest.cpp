// SPDX-License-Identifier: MIT
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/places/FunctionGround.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(ForestGround, IsNotAddedToTheScene) {
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

TEST(ForestGround, IsNullWithInvalidCellsOrHeights) {
    const auto groundOf = [](double cell, double height) {
        ForestDescription description = smallForest(1);
        GroundArea area;
        area.cell = cell;
        description.ground = std::make_shared<FunctionGround>([=](double, double) { return height; }, area);
        return osg::ref_ptr<osg::Node>(osg::ref_ptr<Forest>(new Forest(description))->getGround());
    };
    EXPECT_TRUE(groundOf(10.0, 3.0));
    for (const double cell : {0.0, -1.0, double(INFINITY), double(NAN), 1e-300})
        EXPECT_FALSE(groundOf(cell, 3.0)) << cell;
    EXPECT_FALSE(groundOf(10.0, 1e30));
}

} // namespace osgTreeWind

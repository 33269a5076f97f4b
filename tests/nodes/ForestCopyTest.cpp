// SPDX-License-Identifier: MIT
#include "ForestFixtures.h"

#include <gtest/gtest.h>

using namespace osgTreeWind;

class ForestCopyTest : public ::testing::TestWithParam<unsigned> {
protected:
    osg::ref_ptr<Forest> copyOf(const Forest& forest) { return osg::clone(&forest, osg::CopyOp(GetParam())); }
};

TEST_P(ForestCopyTest, hasTreesOfItsOwnAndTheUsersChildren) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    osg::ref_ptr<osg::Group> house = new osg::Group;
    house->setName("house");
    forest->addChild(house);
    forest->setName("wood");
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_EQ(copy->getName(), "wood");
    EXPECT_EQ(copy->getNumTrees(), 3u);
    ASSERT_EQ(copy->getNumChildren(), 2u);
    EXPECT_EQ(copy->getChild(1)->getName(), "house");
    for (unsigned i = 0; i < 3; ++i) {
        EXPECT_NE(copy->getBranchwise()->getTree(i), forest->getBranchwise()->getTree(i));
        EXPECT_EQ(copy->getBranchwise()->getTree(i)->getNumParents(), 1u);
        EXPECT_EQ(forest->getBranchwise()->getTree(i)->getNumParents(), 1u);
    }
}

TEST_P(ForestCopyTest, movesOnItsOwn) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    updateFrames(*forest, 1, 20);
    const std::vector<glm::vec4> held = statesOf(*forest);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    copy->setWind(nullptr);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(copy);
    updateFrames(*scene, 21, 40);
    EXPECT_EQ(statesOf(*forest), held);
    EXPECT_NE(forest->getWind(), nullptr);
    for (const glm::vec4& state : statesOf(*copy))
        EXPECT_EQ(state, glm::vec4(0.0f)) << "at rest, and calm";
}

TEST_P(ForestCopyTest, takesTheWindOfNowAndTheDrawing) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    const WindFieldPtr gale = std::make_shared<UniformWind>(glm::vec3(30.0f, 0.0f, 0.0f));
    forest->setWind(gale);
    forest->getBranchwise()->setBranchDrawing(BranchwiseForest::BRANCH_DRAWING);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_EQ(copy->getWind(), gale);
    EXPECT_EQ(copy->getBranchwise()->getBranchDrawing(), BranchwiseForest::BRANCH_DRAWING);
    EXPECT_TRUE(copy->getBranchwise()->getTree(1)->getBranchwise());
}

TEST_P(ForestCopyTest, outlivesTheOriginal) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    forest = nullptr;
    updateFrames(*copy, 1, 10);
    EXPECT_TRUE(copy->getBound().valid());
}

TEST_P(ForestCopyTest, keepsTheStateTheUserSet) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    forest->getOrCreateStateSet()->setMode(GL_FOG, osg::StateAttribute::ON);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    ASSERT_NE(copy->getStateSet(), nullptr);
    EXPECT_EQ(copy->getStateSet()->getMode(GL_FOG), GLuint(osg::StateAttribute::ON));
}

TEST_P(ForestCopyTest, needsItsOwnUpdateOnly) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    osg::ref_ptr<osg::Group> clock = new osg::Group;
    clock->setUpdateCallback(new osg::NodeCallback);
    forest->addChild(clock);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_EQ(copy->getNumChildrenRequiringUpdateTraversal(),
              forest->getNumChildrenRequiringUpdateTraversal());
}

TEST_P(ForestCopyTest, drawablesOfATreeCanBeCopied) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    TreeNode& tree = *forest->getBranchwise()->getTree(0);
    const osg::Group& drawn = *tree.getLod()->level(TreeLod::STAND_IN);
    for (unsigned i = 0; i < drawn.getNumChildren(); ++i) {
        const osg::Drawable* const drawable = drawn.getChild(i)->asDrawable();
        ASSERT_NE(drawable, nullptr);
        osg::ref_ptr<osg::Drawable> copy = osg::clone(drawable, osg::CopyOp(GetParam()));
        EXPECT_STREQ(copy->className(), drawable->className());
        EXPECT_EQ(copy->getBoundingBox()._max, drawable->getBoundingBox()._max);
        EXPECT_FALSE(copy->getSupportsDisplayList());
    }
}

INSTANTIATE_TEST_SUITE_P(ShallowAndDeep, ForestCopyTest,
                         ::testing::Values(osg::CopyOp::SHALLOW_COPY, osg::CopyOp::DEEP_COPY_ALL));

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <tests/NamesInOrder.h>
#include <tests/nodes/ForestFixtures.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

class ForestCopyTest : public ::testing::TestWithParam<unsigned> {
protected:
    osg::ref_ptr<Forest> copyOf(const Forest& forest) { return osg::clone(&forest, osg::CopyOp(GetParam())); }
};

TEST_P(ForestCopyTest, HasItsOwnTreesAndTheHostsChildren) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    osg::ref_ptr<osg::Group> house = new osg::Group;
    house->setName("house");
    forest->addChild(house);
    forest->setName("wood");
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_EQ(copy->getName(), "wood");
    EXPECT_EQ(copy->getNumTrees(), 3u);
    ASSERT_EQ(copy->getNumChildren(), forest->getNumChildren());
    EXPECT_EQ(copy->getChild(copy->getNumChildren() - 1)->getName(), "house");
    EXPECT_NE(copy->getInstanced(), forest->getInstanced());
    EXPECT_EQ(copy->getInstanced()->getNumParents(), 1u);
    EXPECT_EQ(forest->getInstanced()->getNumParents(), 1u);
    EXPECT_TRUE(copy->isOwnChild(copy->getInstanced()));
    EXPECT_FALSE(copy->isOwnChild(forest->getInstanced()));
}

TEST_P(ForestCopyTest, MovesIndependently) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    updateFrames(*forest, 1, 20);
    const std::vector<glm::vec4> held = statesOf(*forest);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_TRUE(copy->setWind(nullptr).empty());
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(copy);
    updateFrames(*scene, 21, 40);
    EXPECT_EQ(statesOf(*forest), held);
    EXPECT_FALSE(forest->getWind().isCalm());
    for (const glm::vec4& state : statesOf(*copy))
        EXPECT_EQ(state, glm::vec4(0.0f)) << "at rest, and calm";
}

TEST_P(ForestCopyTest, CopiesTheCurrentWind) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    const WindFieldPtr gale = std::make_shared<UniformWind>(glm::vec3(30.0f, 0.0f, 0.0f));
    EXPECT_TRUE(forest->setWind(gale).empty());
    EXPECT_EQ(copyOf(*forest)->getWind().field, gale);
}

TEST_P(ForestCopyTest, SharesImmutableData) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    osg::ref_ptr<osg::StateSet> own = new osg::StateSet;
    forest->getInstanced()->setLeafState(0, own);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_EQ(movingForest(copy->getSimulation()).models(), movingForest(forest->getSimulation()).models());
    EXPECT_EQ(&movingForest(copy->getSimulation()).modal()->archetype(0),
              &movingForest(forest->getSimulation()).modal()->archetype(0));
    const InstancedResources &one = instancedTrees(*forest->getInstanced()).resources(),
                             &other = instancedTrees(*copy->getInstanced()).resources();
    EXPECT_EQ(one.models, other.models);
    EXPECT_EQ(one.looks[0].bark, other.looks[0].bark) << "and with it programs and textures";
    EXPECT_EQ(other.looks[0].hostLeaves, own);
    copy->getInstanced()->setLeafState(0, nullptr);
    EXPECT_EQ(one.looks[0].hostLeaves, own) << "yet each is changed alone";
}

TEST_P(ForestCopyTest, CopiesTheCurrentTrees) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    EXPECT_TRUE(forest->removeTree(TreeId(1)).empty());
    TreePlacement late;
    late.position = {50.0, 0.0, 0.0};
    const TreeId added = forest->addTree(late).value();
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_EQ(copy->getNumTrees(), 3u);
    EXPECT_TRUE(copy->getSimulation().holds(added));
    EXPECT_TRUE(copy->removeTree(added).empty());
    EXPECT_TRUE(forest->getSimulation().holds(added));
    EXPECT_LT(copy->getBound().radius(), forest->getBound().radius());
}

TEST_P(ForestCopyTest, OutlivesTheOriginal) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    forest = nullptr;
    updateFrames(*copy, 1, 10);
    EXPECT_TRUE(copy->getBound().valid());
}

TEST_P(ForestCopyTest, CopiesTheStateSet) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    forest->getOrCreateStateSet()->setMode(GL_BLEND, osg::StateAttribute::ON);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    ASSERT_NE(copy->getStateSet(), nullptr);
    EXPECT_EQ(copy->getStateSet()->getMode(GL_BLEND), GLuint(osg::StateAttribute::ON));
}

TEST_P(ForestCopyTest, RequiresOneUpdateTraversal) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    osg::ref_ptr<osg::Group> clock = new osg::Group;
    clock->setUpdateCallback(new osg::NodeCallback);
    forest->addChild(clock);
    osg::ref_ptr<Forest> copy = copyOf(*forest);
    EXPECT_EQ(copy->getNumChildrenRequiringUpdateTraversal(),
              forest->getNumChildrenRequiringUpdateTraversal());
}

INSTANTIATE_TEST_SUITE_P(ShallowAndDeep, ForestCopyTest,
                         ::testing::Values(osg::CopyOp::SHALLOW_COPY, osg::CopyOp::DEEP_COPY_ALL),
                         NamesInOrder({"Shallow", "Deep"}));

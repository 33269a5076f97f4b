// SPDX-License-Identifier: MIT
#include <tests/NamesInOrder.h>
#include <tests/drawing/branchwise/BranchwiseFixtures.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osgUtil/IntersectionVisitor>

#include <gtest/gtest.h>

using namespace osgTreeWind;

TEST(TreeNodeTest, HasOneBranchPerUnit) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(oneTree(Species())));
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    EXPECT_EQ(tree.getNumBranches(), 122u);
    EXPECT_NE(tree.getBranch(121), nullptr);
    EXPECT_EQ(tree.getBranch(122), nullptr);
    EXPECT_EQ(tree.getBranch(~0u), nullptr);
}

TEST(TreeNodeTest, ReturnsTheSameBranchEveryTime) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(oneTree(smallSpecies())));
    BranchTransform* const branch = branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getBranch(9);
    EXPECT_EQ(branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getBranch(9), branch);
    EXPECT_EQ(branch->getUnit(), 9u);
}

TEST(TreeNodeTest, AttachedNodeFollowsTheSimulatedTip) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(smallForest(5)));
    const unsigned unit = 13, treeIndex = 4;
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[treeIndex];
    const glm::vec3 tip =
        tree.getPosedTree()->scale().axes * tree.getPosedTree()->model().skeleton.units[unit].tip;
    osg::ref_ptr<osg::MatrixTransform> sensor = new osg::MatrixTransform(osg::Matrix::translate(toOsg(tip)));
    tree.getBranch(unit)->addChild(sensor);
    const osg::Vec3d before = worldMatrix(*sensor).getTrans();
    updateFrames(*forest, 1, 40);

    const ForestSimulation& simulation = forest->getSimulation();
    const PlacedTree& place = movingForest(simulation).trees()[treeIndex];
    const osg::Vec3d inTree = toOsg(movingForest(simulation).motion(treeIndex).poses[unit].apply(tip));
    const osg::Vec3d expected =
        osg::Quat(place.heading, osg::Z_AXIS) * inTree + osg::Vec3d(toOsg(place.position));
    EXPECT_LT((worldMatrix(*sensor).getTrans() - expected).length(), 1e-4);
    EXPECT_GT((expected - before).length(), 1e-3) << "the wind did not move it";
}

TEST(TreeNodeTest, NewBranchTransformHasTheCurrentPose) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(smallForest(1)));
    updateFrames(*forest, 1, 40);
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    const osg::Matrix late = worldMatrix(*tree.getBranch(13));
    tree.updatePose();
    EXPECT_EQ(worldMatrix(*tree.getBranch(13)), late);
    EXPECT_FALSE(tree.getBranch(13)->getRotation().zeroRotation());
}

TEST(TreeNodeTest, ReleasedBranchLosesItsNodesAndStopsFollowing) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(oneTree(smallSpecies(), 20.0f)));
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    BranchTransform* const branch = forest->branch(TreeId(0), 9).value();
    const unsigned own = branch->getNumChildren();
    branch->addChild(new osg::Group);
    ASSERT_EQ(forest->branch(TreeId(0), 2).value(), tree.getBranch(2))
        << "a parent branch, which must keep following";
    EXPECT_TRUE(forest->releaseBranch(TreeId(0), 9));
    EXPECT_EQ(branch->getNumChildren(), own);
    EXPECT_FALSE(forest->releaseBranch(TreeId(0), 9));
    EXPECT_FALSE(forest->releaseBranch(TreeId(0), 1000));
    const osg::Quat held = branch->getRotation(), before = tree.getBranch(2)->getRotation();
    updateFrames(*forest, 1, 20);
    EXPECT_EQ(branch->getRotation(), held) << "no camera sees it";
    EXPECT_NE(tree.getBranch(2)->getRotation(), before);
}

TEST(TreeNodeTest, EmptyNodeAcceptsAllCalls) {
    osg::ref_ptr<TreeNode> tree = new TreeNode;
    tree->updatePose();
    EXPECT_EQ(tree->getNumBranches(), 0u);
    EXPECT_EQ(tree->getBranch(0), nullptr);
    EXPECT_EQ(tree->getPosedTree(), nullptr);
    EXPECT_FALSE(tree->getBound().valid());
    osg::ref_ptr<TreeNode> copy = osg::clone(tree.get(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_EQ(copy->getNumChildren(), 0u);
}

TEST(TreeNodeTest, SeasonChangeKeepsAttachedNodes) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(oneTree(smallSpecies())));
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    osg::ref_ptr<osg::Group> nest = new osg::Group;
    tree.getBranch(5)->addChild(nest);
    osgUtil::IntersectionVisitor picking; // makes the tree create its transforms
    tree.traverse(picking);
    const unsigned children = tree.getBranch(5)->getNumChildren();
    EXPECT_GT(children, 1u);
    tree.setLeafShare(0.0f);
    EXPECT_TRUE(tree.getBranch(5)->containsNode(nest));
    EXPECT_EQ(tree.getBranch(5)->getNumChildren(), children);
}

class TreeNodeCopyTest : public ::testing::TestWithParam<unsigned> {};

TEST_P(TreeNodeCopyTest, HasItsOwnPartsAndKeepsUserNodes) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(smallForest(2)));
    updateFrames(*forest, 1, 40);
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[1];
    tree.setName("by the gate");
    tree.addChild(new osg::Group);
    tree.getOrCreateStateSet()->setMode(GL_BLEND, osg::StateAttribute::ON);
    tree.getBranch(3);
    osg::ref_ptr<TreeNode> copy = osg::clone(&tree, osg::CopyOp(GetParam()));
    EXPECT_EQ(copy->getName(), "by the gate");
    EXPECT_EQ(copy->getPosition(), tree.getPosition());
    EXPECT_EQ(copy->getAttitude(), tree.getAttitude());
    EXPECT_EQ(copy->getNumBranches(), tree.getNumBranches());
    EXPECT_EQ(copy->getNumChildren(), 2u) << "the levels of detail and the user's group";
    EXPECT_NE(copy->getPosedTree(), tree.getPosedTree());
    EXPECT_NE(copy->getBranch(3), tree.getBranch(3));
    EXPECT_TRUE(copy->getBranch(3)->getRotation().zeroRotation()) << "at rest";
    EXPECT_EQ(copy->getStateSet()->getMode(GL_BLEND), GLuint(osg::StateAttribute::ON));
}

TEST_P(TreeNodeCopyTest, DoesNotChangeTheOriginal) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(smallForest(2)));
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[1];
    int before = -2, after = -2;
    tree.getStateSet()->getUniform("treeFirstUnit")->get(before);
    osg::ref_ptr<TreeNode> copy = osg::clone(&tree, osg::CopyOp(GetParam()));
    tree.getStateSet()->getUniform("treeFirstUnit")->get(after);
    EXPECT_EQ(after, before);
    int resting = 0;
    copy->getStateSet()->getUniform("treeFirstUnit")->get(resting);
    EXPECT_EQ(resting, -1);
}

INSTANTIATE_TEST_SUITE_P(ShallowAndDeep, TreeNodeCopyTest,
                         ::testing::Values(osg::CopyOp::SHALLOW_COPY, osg::CopyOp::DEEP_COPY_ALL),
                         NamesInOrder({"Shallow", "Deep"}));

// SPDX-License-Identifier: MIT
#include <tests/NamesInOrder.h>
#include <tests/nodes/ForestFixtures.h>

#include <osg/ShapeDrawable>
#include <osgUtil/Optimizer>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// Number of trees in the scene graph below a node.
std::size_t treesBelow(osg::Node& node) {
    struct Counter : osg::NodeVisitor {
        Counter() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
        void apply(osg::Group& node) override {
            const auto* forest = dynamic_cast<Forest*>(&node);
            if (forest && forest->containsNode(forest->getInstanced()))
                trees += forest->getNumTrees();
            traverse(node);
        }
        std::size_t trees = 0;
    } counter;
    node.accept(counter);
    return counter.trees;
}

} // namespace

/// By the options of the Optimizer: those of osgviewer, and all.
class ForestOptimizerTest : public ::testing::TestWithParam<unsigned> {};

TEST_P(ForestOptimizerTest, KeepsTheTrees) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<Forest> forest = new Forest(smallForest(20));
    scene->addChild(forest);
    osgUtil::Optimizer().optimize(scene, GetParam());
    EXPECT_EQ(treesBelow(*scene), 20u);
    EXPECT_TRUE(scene->containsNode(forest));
}

TEST_P(ForestOptimizerTest, KeepsBranchTransformsAndTheirChildren) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    scene->addChild(forest);
    osg::ref_ptr<osg::MatrixTransform> sensor = new osg::MatrixTransform(osg::Matrix::translate(0, 0, 4));
    sensor->setDataVariance(osg::Object::DYNAMIC);
    sensor->addChild(new osg::ShapeDrawable(new osg::Sphere));
    forest->branch(TreeId(0), 13).value()->addChild(sensor);
    const osg::Vec3d before = worldMatrix(*sensor).getTrans();
    osgUtil::Optimizer().optimize(scene, GetParam());
    ASSERT_EQ(sensor->getNumParents(), 1u);
    EXPECT_EQ(worldMatrix(*sensor).getTrans(), before);
    updateFrames(*scene, 1, 20);
    EXPECT_NE(worldMatrix(*sensor).getTrans(), before);
}

TEST_P(ForestOptimizerTest, KeepsEmptyBranchTransforms) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    scene->addChild(forest);
    osg::ref_ptr<BranchTransform> branch = forest->branch(TreeId(0), 13).value();
    osgUtil::Optimizer().optimize(scene, GetParam());
    EXPECT_EQ(branch->getNumParents(), 1u);
}

TEST_P(ForestOptimizerTest, KeepsAStaticTransformAboveTheForest) {
    for (const MotionLaw law : {MotionLaw::Modal, MotionLaw::ThesisSmooth}) {
        osg::ref_ptr<osg::Group> scene = new osg::Group;
        osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(osg::Matrix::translate(70, 0, 0));
        place->setDataVariance(osg::Object::STATIC);
        scene->addChild(place);
        ForestDescription description = smallForest(3);
        description.law = law;
        osg::ref_ptr<Forest> forest = new Forest(description);
        place->addChild(forest);
        osgUtil::Optimizer().optimize(scene, GetParam());
        EXPECT_EQ(worldMatrix(*forest).getTrans(), osg::Vec3d(70, 0, 0));
    }
}

TEST_P(ForestOptimizerTest, AnEmptyForestAcceptsADescriptionAfterwards) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<Forest> forest = new Forest;
    scene->addChild(forest);
    osgUtil::Optimizer().optimize(scene, GetParam());
    EXPECT_TRUE(forest->setDescription(smallForest(3)).empty());
    EXPECT_EQ(treesBelow(*forest), 3u);
}

TEST_P(ForestOptimizerTest, AForestOfOneTreeAcceptsADescriptionAfterwards) {
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    scene->addChild(forest);
    osgUtil::Optimizer().optimize(scene, GetParam());
    EXPECT_TRUE(forest->setDescription(smallForest(3)).empty());
    EXPECT_EQ(treesBelow(*scene), 3u);
}

INSTANTIATE_TEST_SUITE_P(DefaultAndAll, ForestOptimizerTest,
                         ::testing::Values(osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS,
                                           osgUtil::Optimizer::ALL_OPTIMIZATIONS),
                         NamesInOrder({"Default", "All"}));

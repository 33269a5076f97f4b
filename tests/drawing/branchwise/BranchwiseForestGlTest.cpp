// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/gl/ThreadingModels.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>
#include <tests/plugins/PluginPath.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>
#include <osgTreeWind/gpu/branchwise/ForestAnglePasses.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>

#include <osg/BufferObject>
#include <osg/ContextData>
#include <osg/Texture>
#include <osgDB/ReadFile>

#include <limits>

using namespace osgTreeWind;

namespace {

class BranchwiseForestGlTest : public GlTest {
protected:
    /// Shows a forest below `scene` to a camera in the south.
    void start(const ForestDescription& description) {
        forest = new Forest(description);
        scene = new osg::Group;
        scene->addChild(forest);
        open(96, 72);
        viewer().setSceneData(scene);
        viewer().getCamera()->setProjectionMatrixAsPerspective(40, 96.0 / 72.0, 1, 100);
        look(true);
    }
    void look(bool there) {
        viewer().getCamera()->setViewMatrixAsLookAt({3, -14, 4}, {3, there ? 0.0 : -28.0, 3}, osg::Z_AXIS);
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i)
            frame(++now / 25.0);
    }
    const std::vector<glm::vec4>& states() const {
        return movingForest(forest->getSimulation()).branches()->states();
    }

    osg::ref_ptr<Forest> forest;
    osg::ref_ptr<osg::Group> scene;
    int now = 0;
};

ForestDescription branchwiseForest(int trees) {
    ForestDescription description = smallForest(trees);
    description.law = MotionLaw::ThesisSmooth;
    return description;
}

} // namespace

TEST_F(BranchwiseForestGlTest, ThesisExampleUsesAnglePassesAndBranchTransforms) {
    usePluginsOfThisBuild();
    osg::ref_ptr<osg::Node> read = osgDB::readRefNodeFile(exampleFile("thesis.treewind"));
    forest = dynamic_cast<Forest*>(read.get());
    ASSERT_TRUE(forest);
    open(96, 72);
    viewer().setSceneData(forest);
    const osg::BoundingSphere bound = forest->getBound();
    viewer().getCamera()->setViewMatrixAsLookAt(bound.center() - osg::Vec3(0, 3 * bound.radius(), 0),
                                                bound.center(), osg::Z_AXIS);
    frames(4);
    const BranchwiseForest& branchwise = *forest->getBranchwise();
    ASSERT_NE(anglePasses(branchwise), nullptr) << "the angle passes do not run";
    const osg::Group& full = *branchwiseTrees(branchwise).nodes()[0]->getLod()->level(TreeLod::FULL);
    ASSERT_EQ(full.getNumChildren(), 1u);
    const auto* trunk = dynamic_cast<const BranchTransform*>(full.getChild(0));
    ASSERT_NE(trunk, nullptr) << "a branch is not a transform";
    const std::vector<glm::vec4> before = states();
    const osg::Matrix stood = trunk->getMatrix();
    frames(2);
    EXPECT_NE(states(), before) << "states are not read back";
    EXPECT_NE(trunk->getMatrix(), stood) << "states do not move the transforms";
}

TEST_F(BranchwiseForestGlTest, DoesNotDisableCullingOfItsParents) {
    start(branchwiseForest(2));
    frames(1);
    EXPECT_EQ(scene->getNumChildrenWithCullingDisabled(), 0u) << "by the probe";
    frames(3);
    ASSERT_NE(anglePasses(*forest->getBranchwise()), nullptr);
    EXPECT_EQ(forest->getNumChildrenWithCullingDisabled(), 0u);
    EXPECT_EQ(scene->getNumChildrenWithCullingDisabled(), 0u) << "by the passes";
    const std::vector<glm::vec4> before = states();
    frames(3);
    EXPECT_NE(states(), before) << "the passes do not run";
}

TEST_F(BranchwiseForestGlTest, KeepsStatesWhileCulledAndContinuesFromThem) {
    start(branchwiseForest(2));
    frames(20);
    look(false);
    frames(2); // reads the last states back
    const std::vector<glm::vec4> held = states();
    frames(7); // an odd number of steps that are not drawn
    EXPECT_EQ(states(), held);
    look(true);
    frames(2);
    float moved = 0.0f, largest = 0.0f;
    for (std::size_t i = 0; i < held.size(); ++i) {
        moved = std::max(moved, std::abs(states()[i].x - held[i].x));
        largest = std::max(largest, std::abs(held[i].x));
    }
    EXPECT_GT(moved, 0.0f);
    EXPECT_LT(moved, 0.5f * largest) << "one step from the former states, not from rest";
}

TEST_F(BranchwiseForestGlTest, ReadsBackTheLeafAnglesThatAreDrawn) {
    const ForestDescription description = branchwiseForest(1);
    start(description);
    frames(30);
    ForestSimulation oracle(description);
    for (int i = 2; i <= now - 1; ++i) // passes start in the second frame; read-back states are one frame old
        oracle.advance(i / 25.0);
    const auto& leaves = movingForest(forest->getSimulation()).branches()->leafStates();
    float fluttering = 0.0f;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        ASSERT_NEAR(leaves[i].x, movingForest(oracle).branches()->leafStates()[i].x, 5e-4f) << "leaf " << i;
        fluttering = std::max(fluttering, std::abs(leaves[i].x));
    }
    EXPECT_GT(fluttering, 0.01f);
}

TEST_F(BranchwiseForestGlTest, ReleasingATreeKeepsObjectsOfOtherTrees) {
    start(branchwiseForest(2));
    frames(4);
    const unsigned context = this->context().getState()->getContextID();
    const auto* buffers = osg::get<osg::GLBufferObjectManager>(context);
    const auto* textures = osg::get<osg::TextureObjectManager>(context);
    const unsigned buffersBefore = buffers->getNumberActiveGLBufferObjects();
    const unsigned texturesBefore = textures->getNumberActiveTextureObjects();
    branchwiseTrees(*forest->getBranchwise()).nodes()[0]->releaseGLObjects();
    EXPECT_EQ(buffers->getNumberActiveGLBufferObjects(), buffersBefore);
    EXPECT_EQ(textures->getNumberActiveTextureObjects(), texturesBefore);
    frames(1);
}

TEST_F(BranchwiseForestGlTest, BillboardsLookLikeTheTrees) {
    ForestDescription calm = branchwiseForest(3);
    calm.wind = nullptr;
    double seen[2] = {};
    for (const bool pictures : {false, true}) {
        start(calm);
        const float always = std::numeric_limits<float>::infinity();
        EXPECT_TRUE(forest->getBranchwise()
                        ->setLodRanges(pictures ? TreeLodRanges{0.0f, 0.0f} : TreeLodRanges{always, always})
                        .empty());
        frames(3);
        seen[pictures] = covered(image());
    }
    EXPECT_GT(seen[0], 0.02);
    EXPECT_NEAR(seen[1], seen[0], 0.25 * seen[0]);
}

TEST_F(BranchwiseForestGlTest, LeavesKeepTheirShadeWhenATreeIsAdded) {
    ForestDescription calm = branchwiseForest(3);
    calm.wind = nullptr;
    ForestDescription more = calm;
    TreePlacement behind = calm.trees[0];
    behind.position = {0.0, -500.0, 0.0};
    more.trees.insert(more.trees.begin(), behind);
    start(calm);
    frame(0.0);
    const osg::ref_ptr<osg::Image> before = new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_GT(covered(*before), 0.02);
    start(more);
    frame(0.0);
    EXPECT_EQ(difference(*before, image()).mean, 0.0);
}

class BranchwiseThreadingGlTest
    : public BranchwiseForestGlTest,
      public ::testing::WithParamInterface<osgViewer::ViewerBase::ThreadingModel> {};

TEST_P(BranchwiseThreadingGlTest, ForestMayBeRemovedWhileItsFrameIsDrawn) {
    start(branchwiseForest(1));
    viewer().setThreadingModel(GetParam());
    for (int i = 0; i < 40; ++i) {
        frames(4);
        scene->removeChild(forest);
        forest = new Forest(branchwiseForest(1 + i % 2)); // deletes the former forest
        scene->addChild(forest);
    }
    frames(4);
    EXPECT_NE(anglePasses(*forest->getBranchwise()), nullptr);
    viewer().setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
}

INSTANTIATE_TEST_SUITE_P(Models, BranchwiseThreadingGlTest, threadingModels, nameOfModel);

// SPDX-License-Identifier: MIT
#include <tests/drawing/branchwise/FakeCullVisitor.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

using namespace osgTreeWind;

namespace {

/// A tree under a branchwise law in a wind.
class TreeLodTest : public ::testing::Test {
protected:
    TreeLodTest() {
        ForestDescription description = smallForest(1);
        description.law = MotionLaw::ThesisSmooth;
        forest = new Forest(description);
        forest->getBranchwise()->setAngleSource(BranchwiseForest::CPU_ANGLES);
        tree = branchwiseTrees(*forest->getBranchwise()).nodes()[0].get();
        height = tree->getLod()->getCenter().z() * 2.0f;
    }
    /// Classes of the drawables that a camera draws from a distance in heights of the tree.
    std::vector<std::string> seenFrom(float heights) {
        FakeCullVisitor cull(heights * height);
        forest->accept(cull);
        std::vector<std::string> names;
        for (const osg::Drawable* drawable : cull.drawn)
            names.push_back(drawable->className());
        return names;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i, ++frame)
            update(*forest, frame, frame / 25.0);
    }
    /// The transform of the first branch; null if it does not exist.
    const osg::Node* firstBranch() const {
        const osg::Group& full = *tree->getLod()->level(TreeLod::FULL);
        return full.getNumChildren() ? full.getChild(0) : nullptr;
    }

    osg::ref_ptr<Forest> forest;
    TreeNode* tree;
    float height = 0.0f;
    unsigned frame = 1;
};

std::size_t count(const std::vector<std::string>& names, const char* name) {
    return static_cast<std::size_t>(std::count(names.begin(), names.end(), name));
}

} // namespace

TEST_F(TreeLodTest, NearTreeIsDrawnAsPublished) {
    seenFrom(2.0f);
    frames(1);
    const std::vector<std::string> names = seenFrom(2.0f);
    EXPECT_EQ(count(names, "SkinDrawable"), tree->getNumBranches());
    EXPECT_EQ(count(names, "LeafClusterDrawable"), tree->getPosedTree()->model().leaves.size());
    EXPECT_EQ(count(names, "LeafDrawable"), 0u);
}

TEST_F(TreeLodTest, MiddleLevelIsLeavesAndBarkWithoutLeaves) {
    const std::vector<std::string> names = seenFrom(10.0f);
    EXPECT_EQ(names, (std::vector<std::string>{"SkinDrawable", "LeafDrawable"}));
    FakeCullVisitor cull(10.0f * height);
    forest->accept(cull);
    const auto* bark = dynamic_cast<const TreeDrawable*>(cull.drawn[0]);
    ASSERT_NE(bark, nullptr);
    const TreeModel& model = tree->getPosedTree()->model();
    EXPECT_EQ(bark->geometry()->getPrimitiveSet(0)->getNumIndices(), model.skin().firstIndices[2])
        << "the two units of the trunk";
}

TEST_F(TreeLodTest, TreeWithoutNearCameraHasNoTransforms) {
    frames(5);
    seenFrom(10.0f);
    frames(5);
    EXPECT_EQ(firstBranch(), nullptr);
}

TEST_F(TreeLodTest, TransformsAreNotUpdatedWithoutNearCamera) {
    seenFrom(2.0f);
    frames(2);
    const auto* branch = dynamic_cast<const BranchTransform*>(firstBranch());
    ASSERT_NE(branch, nullptr);
    frames(1); // the last update after a camera saw it
    const osg::Quat held = branch->getRotation();
    for (int i = 0; i < 10; ++i) {
        seenFrom(10.0f);
        frames(1);
    }
    EXPECT_EQ(branch->getRotation(), held);
    seenFrom(2.0f);
    frames(1);
    EXPECT_NE(branch->getRotation(), held) << "a near camera resumes the updates";
}

TEST_F(TreeLodTest, StandInIsDrawnUntilTransformsAreUpToDate) {
    frames(10);
    EXPECT_EQ(seenFrom(2.0f), (std::vector<std::string>{"SkinDrawable", "LeafDrawable"}));
    frames(1);
    EXPECT_GT(seenFrom(2.0f).size(), 2u);
}

TEST_F(TreeLodTest, TransformsAreUpdatedDuringAPause) {
    frames(10);
    seenFrom(2.0f);
    update(*forest, frame, (frame - 1) / 25.0);
    EXPECT_GT(seenFrom(2.0f).size(), 2u);
}

TEST_F(TreeLodTest, RequestedBranchFollowsUnseen) {
    BranchTransform* branch = tree->getBranch(9);
    const osg::Quat rest = branch->getRotation();
    frames(10);
    EXPECT_NE(branch->getRotation(), rest);
    const glm::quat expected = tree->getPosedTree()->rotation(9);
    EXPECT_EQ(branch->getRotation(), toOsg(expected));
}

TEST_F(TreeLodTest, RangesAreInHeightsOfTheTree) {
    EXPECT_TRUE(forest->getBranchwise()->setLodRanges({3.0f, 20.0f}).empty());
    seenFrom(2.9f);
    frames(1);
    EXPECT_GT(seenFrom(2.9f).size(), 2u);
    EXPECT_EQ(seenFrom(3.1f).size(), 2u);
    const float always = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(forest->getBranchwise()->setLodRanges({always, always}).empty());
    EXPECT_GT(seenFrom(1e6f).size(), 2u);
}

TEST_F(TreeLodTest, CopyOfTheForestKeepsTheRanges) {
    EXPECT_TRUE(forest->getBranchwise()->setLodRanges({3.0f, 20.0f}).empty());
    osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    EXPECT_EQ(branchwiseTrees(*copy->getBranchwise()).nodes()[0]->getLod()->getRanges().full, 3.0f);
}

TEST_F(TreeLodTest, DistantTreeIsABillboard) {
    EXPECT_EQ(seenFrom(21.0f), (std::vector<std::string>{"BillboardDrawable"}));
    frames(3);
    EXPECT_EQ(firstBranch(), nullptr);
}

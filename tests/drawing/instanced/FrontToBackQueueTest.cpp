// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/FrontToBackQueue.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// Visits trees with a coverage of one half each and records their visible share.
class FrontToBackQueueTest : public ::testing::Test {
protected:
    FrontToBackQueueTest() { grid.fill(0.5f); }
    OcclusionBuffer::Billboard visit(const FrontToBackQueue::Tree& tree) {
        const OcclusionBuffer::Billboard billboard{{0.0f, -0.5f}, {0.0f, 0.5f}, 0.5f, &grid};
        slots.push_back(tree.slot);
        visibleShare.push_back(trees.occlusion().visibleShare(billboard));
        return billboard;
    }
    void visitNearerThan(float distance) {
        trees.visitNearerThan(distance, [this](const FrontToBackQueue::Tree& tree) { return visit(tree); });
    }
    void visitAll() {
        trees.visitAll([this](const FrontToBackQueue::Tree& tree) { return visit(tree); });
    }
    ImpostorCoverage::Grid grid;
    FrontToBackQueue trees;
    std::vector<std::uint32_t> slots;
    std::vector<float> visibleShare;
};

} // namespace

TEST_F(FrontToBackQueueTest, NearTreesComeFirstAndHideFarOnes) {
    trees.insert({3, 0, 1.0f}, 40.0f);
    trees.insert({1, 0, 1.0f}, 2.0f);
    trees.insert({2, 0, 1.0f}, 9.0f);
    trees.insert({4, 0, 1.0f}, 1.0e30f);
    visitAll();
    EXPECT_EQ(slots, (std::vector<std::uint32_t>{1, 2, 3, 4}));
    ASSERT_EQ(visibleShare.size(), 4u);
    EXPECT_FLOAT_EQ(visibleShare[1], 1.0f) << "a tree does not hide trees of the next bin";
    EXPECT_NEAR(visibleShare[2], 0.25f, 0.01f);
    EXPECT_NEAR(visibleShare[3], 0.125f, 0.01f);
}

TEST_F(FrontToBackQueueTest, VisitsTreesUpToADistance) {
    trees.insert({1, 0, 1.0f}, 2.0f);
    visitNearerThan(1.0f);
    EXPECT_TRUE(slots.empty()) << "more trees may follow at this distance";
    visitNearerThan(20.0f);
    EXPECT_EQ(slots.size(), 1u);
    trees.insert({2, 0, 1.0f}, 30.0f);
    trees.insert({3, 0, 1.0f}, 3.0f); // its bin was visited, so it goes to the next one
    visitAll();
    EXPECT_EQ(slots, (std::vector<std::uint32_t>{1, 3, 2}));
    visitAll();
    EXPECT_EQ(slots.size(), 3u) << "each tree is visited once";
}

TEST_F(FrontToBackQueueTest, ClearRemovesTreesAndOcclusion) {
    trees.insert({1, 0, 1.0f}, 2.0f);
    trees.insert({2, 0, 1.0f}, 50.0f);
    visitNearerThan(30.0f);
    trees.clear();
    trees.insert({5, 0, 1.0f}, 2.0f);
    visitAll();
    EXPECT_EQ(slots, (std::vector<std::uint32_t>{1, 5}));
    EXPECT_FLOAT_EQ(visibleShare.back(), 1.0f);
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/FrontToBackQueue.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

using namespace osgTreeWind;

namespace {

/// Parts cover half of the middle of the screen. Records what is visited, and the transmittance in front of
/// it.
class FrontToBackQueueTest : public ::testing::Test {
public:
    void operator()(const FrontToBackQueue::Tree& tree) {
        visited.push_back(tree.slot);
        if (tree.band == hasPart)
            insertPart(100 + tree.slot, tree.pixels);
    }
    bool operator()(const FrontToBackQueue::Part& part) {
        visited.push_back(part.tree);
        transmittance.push_back(queue.occlusion().minTransmittance(part.place.low, part.place.high));
        return part.isTestable;
    }

protected:
    void insertPart(std::uint32_t id, float distance, bool hides = true) {
        const osg::Vec2 low(-0.5f, -0.5f), high(0.5f, 0.5f);
        queue.insert(
            FrontToBackQueue::Part{nullptr, id, distance, true, hides, {low, high, low, high, 0.5f}});
    }
    /// @param part distance of the part that its visit adds, metres; none if negative.
    void insertTree(std::uint32_t slot, float distance, float part = -1.0f) {
        queue.insert(FrontToBackQueue::Tree{slot, part < 0.0f ? 0 : hasPart, part}, distance);
    }
    void visitNearerThan(float distance) {
        queue.visitNearerThan(distance, std::ref<FrontToBackQueueTest>(*this));
    }
    void visitAll() { queue.visitAll(std::ref<FrontToBackQueueTest>(*this)); }

    static constexpr std::size_t hasPart = 1;
    FrontToBackQueue queue;
    using Ids = std::vector<std::uint32_t>;
    Ids visited;
    std::vector<float> transmittance;
};

} // namespace

TEST_F(FrontToBackQueueTest, NearPartsComeFirstAndHideFarOnes) {
    insertPart(4, 40.0f);
    insertPart(1, 2.0f);
    insertPart(5, 1.0e30f);
    insertPart(2, 2.4f);
    insertPart(3, 9.0f);
    visitAll();
    EXPECT_EQ(visited, (Ids{1, 2, 3, 4, 5}));
    ASSERT_EQ(transmittance.size(), 5u);
    EXPECT_FLOAT_EQ(transmittance[1], 1.0f) << "a part does not hide parts of the next bin";
    EXPECT_NEAR(transmittance[2], 0.25f, 0.01f);
    EXPECT_NEAR(transmittance[3], 0.125f, 0.01f);
    EXPECT_NEAR(transmittance[4], 0.0625f, 0.01f);
}

TEST_F(FrontToBackQueueTest, PartsThatTheVisitRejectsHideNothing) {
    insertPart(1, 2.0f, false);
    insertPart(2, 2.0f);
    insertPart(3, 40.0f);
    visitAll();
    EXPECT_NEAR(transmittance.back(), 0.5f, 0.01f);
}

TEST_F(FrontToBackQueueTest, PartsThatATreeAddsAreInItsBinOrLaterOnes) {
    insertTree(1, 20.0f, 25.0f);
    insertTree(2, 30.0f, 3.0f); // nearer than the visited bins
    insertTree(3, 40.0f, 40.0f);
    insertPart(4, 33.0f);
    visitAll();
    EXPECT_EQ(visited, (Ids{1, 101, 2, 102, 4, 3, 103}));
}

TEST_F(FrontToBackQueueTest, VisitsUpToADistance) {
    insertTree(1, 2.0f);
    insertPart(2, 2.0f);
    visitNearerThan(1.0f);
    EXPECT_TRUE(visited.empty()) << "more trees may follow at this distance";
    visitNearerThan(20.0f);
    EXPECT_EQ(visited, (Ids{1, 2}));
    insertTree(3, 30.0f);
    insertTree(4, 3.0f); // its bin was visited, so it goes to the next one
    insertPart(5, 3.0f);
    visitAll();
    EXPECT_EQ(visited, (Ids{1, 2, 4, 5, 3}));
    visitAll();
    EXPECT_EQ(visited.size(), 5u) << "each is visited once";
}

TEST_F(FrontToBackQueueTest, ClearRemovesTreesPartsAndOcclusion) {
    insertPart(1, 2.0f);
    insertTree(2, 50.0f);
    insertPart(3, 50.0f);
    visitNearerThan(30.0f);
    queue.clear();
    insertPart(4, 2.0f);
    visitAll();
    EXPECT_EQ(visited, (Ids{1, 4}));
    EXPECT_FLOAT_EQ(transmittance.back(), 1.0f);
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/FrontToBack.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// Takes trees, each with a picture that lets half through, and notes how clearly it is seen.
class FrontToBackTest : public ::testing::Test {
protected:
    FrontToBackTest() { grid.fill(0.5f); }
    ScreenCover::Picture see(const FrontToBack::Tree& tree) {
        const ScreenCover::Picture picture{{0.0f, -0.5f}, {0.0f, 0.5f}, 0.5f, &grid};
        numbers.push_back(tree.number);
        clearness.push_back(trees.cover().clearness(picture));
        return picture;
    }
    void takeBefore(float distance) {
        trees.takeBefore(distance, [this](const FrontToBack::Tree& tree) { return see(tree); });
    }
    void takeAll() {
        trees.takeAll([this](const FrontToBack::Tree& tree) { return see(tree); });
    }
    PictureCover::Grid grid;
    FrontToBack trees;
    std::vector<std::uint32_t> numbers;
    std::vector<float> clearness;
};

} // namespace

TEST_F(FrontToBackTest, nearOnesComeFirstAndHideThoseWellBehindThem) {
    trees.put({3, 0, 1.0f}, 40.0f);
    trees.put({1, 0, 1.0f}, 2.0f);
    trees.put({2, 0, 1.0f}, 9.0f);
    trees.put({4, 0, 1.0f}, 1.0e30f);
    takeAll();
    EXPECT_EQ(numbers, (std::vector<std::uint32_t>{1, 2, 3, 4}));
    ASSERT_EQ(clearness.size(), 4u);
    EXPECT_FLOAT_EQ(clearness[1], 1.0f) << "crowns of the next step reach into each other";
    EXPECT_NEAR(clearness[2], 0.25f, 0.01f);
    EXPECT_NEAR(clearness[3], 0.125f, 0.01f);
}

TEST_F(FrontToBackTest, areTakenAsFarAsAskedFor) {
    trees.put({1, 0, 1.0f}, 2.0f);
    takeBefore(1.0f);
    EXPECT_TRUE(numbers.empty()) << "others may stand as near";
    takeBefore(20.0f);
    EXPECT_EQ(numbers.size(), 1u);
    trees.put({2, 0, 1.0f}, 30.0f);
    trees.put({3, 0, 1.0f}, 3.0f); // too late for its place, and not lost
    takeAll();
    EXPECT_EQ(numbers, (std::vector<std::uint32_t>{1, 3, 2}));
    takeAll();
    EXPECT_EQ(numbers.size(), 3u) << "each once";
}

TEST_F(FrontToBackTest, beginsAnew) {
    trees.put({1, 0, 1.0f}, 2.0f);
    trees.put({2, 0, 1.0f}, 50.0f);
    takeBefore(30.0f);
    trees.clear();
    trees.put({5, 0, 1.0f}, 2.0f);
    takeAll();
    EXPECT_EQ(numbers, (std::vector<std::uint32_t>{1, 5}));
    EXPECT_FLOAT_EQ(clearness.back(), 1.0f);
}

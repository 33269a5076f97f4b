// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/ScreenCover.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

PictureCover::Grid evenly(float cover) {
    PictureCover::Grid grid;
    grid.fill(cover);
    return grid;
}

ScreenCover::Picture picture(const PictureCover::Grid& grid, const osg::Vec2& low, const osg::Vec2& high,
                             float halfWidth) {
    return {low, high, halfWidth, &grid};
}

} // namespace

TEST(ScreenCoverTest, eachCrownLetsThroughAShareOfWhatIsLeft) {
    const PictureCover::Grid half = evenly(0.5f), most = evenly(0.9f);
    const auto crown = [](const PictureCover::Grid& grid) {
        return picture(grid, {0.0f, -0.5f}, {0.0f, 0.5f}, 0.3f);
    };
    ScreenCover cover;
    EXPECT_FLOAT_EQ(cover.clearness(crown(half)), 1.0f);
    cover.add(crown(half));
    EXPECT_NEAR(cover.clearness(crown(most)), 0.5f, 0.03f) << "cells at the rim are covered in part";
    cover.add(crown(most));
    EXPECT_NEAR(cover.clearness(picture(half, {0.0f, -0.3f}, {0.0f, 0.3f}, 0.1f)), 0.05f, 1e-5f);
    cover.clear();
    EXPECT_FLOAT_EQ(cover.clearness(crown(most)), 1.0f);
}

TEST(ScreenCoverTest, whatShowsBesideOthersIsSeenClearly) {
    const PictureCover::Grid solid = evenly(0.999f), crown = evenly(0.8f);
    ScreenCover cover;
    cover.add(picture(solid, {-0.5f, -1.0f}, {-0.5f, 1.0f}, 0.5f)); // the left half of the screen
    EXPECT_LT(cover.clearness(picture(crown, {-0.5f, -0.2f}, {-0.5f, 0.2f}, 0.2f)), 0.002f);
    EXPECT_GT(cover.clearness(picture(crown, {0.0f, -0.2f}, {0.0f, 0.2f}, 0.2f)), 0.99f);
    EXPECT_FLOAT_EQ(cover.clearness(picture(crown, {0.5f, -0.2f}, {0.5f, 0.2f}, 0.2f)), 1.0f);
}

TEST(ScreenCoverTest, aTrunkThatShowsBelowACrownIsSeenClearly) {
    const PictureCover::Grid solid = evenly(0.999f);
    PictureCover::Grid tree = evenly(0.8f);
    for (int i = 0; i < PictureCover::side * PictureCover::side / 4; ++i)
        tree[static_cast<std::size_t>(i)] = 0.05f; // a trunk alone, in the lowest quarter
    ScreenCover cover;
    cover.add(picture(solid, {0.0f, -0.2f}, {0.0f, 1.0f}, 1.0f));
    EXPECT_GT(cover.clearness(picture(tree, {0.0f, -0.5f}, {0.0f, 0.9f}, 0.2f)), 0.99f);
    EXPECT_LT(cover.clearness(picture(tree, {0.0f, -0.15f}, {0.0f, 0.9f}, 0.2f)), 0.002f);
}

TEST(ScreenCoverTest, aLeaningTreeHidesWhatIsBehindItsTop) {
    const PictureCover::Grid solid = evenly(0.999f), crown = evenly(0.8f);
    ScreenCover cover;
    cover.add(picture(solid, {-0.6f, -1.0f}, {0.6f, 1.0f}, 0.2f));
    EXPECT_LT(cover.clearness(picture(crown, {0.5f, 0.8f}, {0.5f, 0.9f}, 0.05f)), 0.01f);
    EXPECT_FLOAT_EQ(cover.clearness(picture(crown, {-0.5f, 0.8f}, {-0.5f, 0.9f}, 0.05f)), 1.0f);
}

TEST(ScreenCoverTest, nothingIsHiddenOffTheScreenOrWithoutAPicture) {
    const PictureCover::Grid solid = evenly(0.999f);
    ScreenCover cover;
    cover.add(picture(solid, {0.0f, -1e30f}, {0.0f, 1e30f}, 1e30f));
    EXPECT_FLOAT_EQ(cover.clearness({}), 1.0f);
    for (const osg::Vec2& way : {osg::Vec2(1, 0), osg::Vec2(-1, 0), osg::Vec2(0, 1), osg::Vec2(0, -1)})
        for (const float away : {2.0f, 1e9f, 1e30f}) {
            const osg::Vec2 low = way * away;
            EXPECT_FLOAT_EQ(cover.clearness(picture(solid, low, low + osg::Vec2(0.0f, 0.1f * away), 0.1f)),
                            1.0f)
                << low.x() << ' ' << low.y();
        }
}

TEST(ScreenCoverTest, hidesWhatShowsOnLessThanAPixel) {
    const PictureCover::Grid crown = evenly(0.9f);
    const auto low = osg::Vec2(0.0f, -0.1f), high = osg::Vec2(0.0f, 0.1f);
    const ScreenCover::Picture tree = picture(crown, low, high, 0.1f);
    const float share = 0.9f * 0.1f * 0.1f; // of the screen, by itself
    ScreenCover cover;
    EXPECT_FALSE(cover.hides(tree, 1.0f)) << "nothing is before it";
    const PictureCover::Grid before = evenly(0.99f);
    cover.add(picture(before, {0.0f, -1.0f}, {0.0f, 1.0f}, 0.5f));
    EXPECT_TRUE(cover.hides(tree, 0.0101f * share));
    EXPECT_FALSE(cover.hides(tree, 0.0099f * share));
    EXPECT_FALSE(cover.hides(picture(crown, {0.5f, -0.1f}, {0.5f, 0.1f}, 0.1f), 1.0f)) << "shows beside it";
    EXPECT_FALSE(cover.hides({}, 1.0f));
    EXPECT_FALSE(cover.hides(picture(crown, {3.0f, -0.1f}, {3.0f, 0.1f}, 0.1f), 1.0f)) << "off the screen";
}

TEST(ScreenCoverTest, tellsWhatShowsLeastOnAPartOfTheScreen) {
    const PictureCover::Grid half = evenly(0.5f);
    ScreenCover cover;
    cover.add(picture(half, {-0.5f, -1.0f}, {-0.5f, 1.0f}, 0.5f)); // the left half
    EXPECT_FLOAT_EQ(cover.leastShown({-0.9f, -0.5f}, {-0.1f, 0.5f}), 0.5f);
    EXPECT_FLOAT_EQ(cover.leastShown({-0.2f, -0.5f}, {0.2f, 0.5f}), 0.5f);
    EXPECT_FLOAT_EQ(cover.leastShown({0.1f, -9.0f}, {9.0f, 9.0f}), 1.0f);
    EXPECT_FLOAT_EQ(cover.leastShown({-9.0f, 2.0f}, {9.0f, 3.0f}), 1.0f);
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/OcclusionBuffer.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

ImpostorCoverage::Grid uniformGrid(float coverage) {
    ImpostorCoverage::Grid grid;
    grid.fill(coverage);
    return grid;
}

OcclusionBuffer::Billboard billboard(const ImpostorCoverage::Grid& grid, const osg::Vec2& low,
                                     const osg::Vec2& high, float halfWidth) {
    return {low, high, halfWidth, &grid};
}

} // namespace

TEST(OcclusionBufferTest, EachCrownMultipliesTheTransmittance) {
    const ImpostorCoverage::Grid half = uniformGrid(0.5f), most = uniformGrid(0.9f);
    const auto crown = [](const ImpostorCoverage::Grid& grid) {
        return billboard(grid, {0.0f, -0.5f}, {0.0f, 0.5f}, 0.3f);
    };
    OcclusionBuffer buffer;
    EXPECT_FLOAT_EQ(buffer.visibleShare(crown(half)), 1.0f);
    buffer.add(crown(half));
    EXPECT_NEAR(buffer.visibleShare(crown(most)), 0.5f, 0.03f) << "cells at the edge are partly covered";
    buffer.add(crown(most));
    EXPECT_NEAR(buffer.visibleShare(billboard(half, {0.0f, -0.3f}, {0.0f, 0.3f}, 0.1f)), 0.05f, 1e-5f);
    buffer.clear();
    EXPECT_FLOAT_EQ(buffer.visibleShare(crown(most)), 1.0f);
}

TEST(OcclusionBufferTest, TreeBesideOthersIsVisible) {
    const ImpostorCoverage::Grid solid = uniformGrid(0.999f), crown = uniformGrid(0.8f);
    OcclusionBuffer buffer;
    buffer.add(billboard(solid, {-0.5f, -1.0f}, {-0.5f, 1.0f}, 0.5f)); // the left half of the screen
    EXPECT_LT(buffer.visibleShare(billboard(crown, {-0.5f, -0.2f}, {-0.5f, 0.2f}, 0.2f)), 0.002f);
    EXPECT_GT(buffer.visibleShare(billboard(crown, {0.0f, -0.2f}, {0.0f, 0.2f}, 0.2f)), 0.99f);
    EXPECT_FLOAT_EQ(buffer.visibleShare(billboard(crown, {0.5f, -0.2f}, {0.5f, 0.2f}, 0.2f)), 1.0f);
}

TEST(OcclusionBufferTest, TrunkBelowACrownIsVisible) {
    const ImpostorCoverage::Grid solid = uniformGrid(0.999f);
    ImpostorCoverage::Grid tree = uniformGrid(0.8f);
    for (int i = 0; i < ImpostorCoverage::side * ImpostorCoverage::side / 4; ++i)
        tree[static_cast<std::size_t>(i)] = 0.05f; // a bare trunk in the lowest quarter
    OcclusionBuffer buffer;
    buffer.add(billboard(solid, {0.0f, -0.2f}, {0.0f, 1.0f}, 1.0f));
    EXPECT_GT(buffer.visibleShare(billboard(tree, {0.0f, -0.5f}, {0.0f, 0.9f}, 0.2f)), 0.99f);
    EXPECT_LT(buffer.visibleShare(billboard(tree, {0.0f, -0.15f}, {0.0f, 0.9f}, 0.2f)), 0.002f);
}

TEST(OcclusionBufferTest, LeaningTreeHidesTreesBehindItsTop) {
    const ImpostorCoverage::Grid solid = uniformGrid(0.999f), crown = uniformGrid(0.8f);
    OcclusionBuffer buffer;
    buffer.add(billboard(solid, {-0.6f, -1.0f}, {0.6f, 1.0f}, 0.2f));
    EXPECT_LT(buffer.visibleShare(billboard(crown, {0.5f, 0.8f}, {0.5f, 0.9f}, 0.05f)), 0.01f);
    EXPECT_FLOAT_EQ(buffer.visibleShare(billboard(crown, {-0.5f, 0.8f}, {-0.5f, 0.9f}, 0.05f)), 1.0f);
}

TEST(OcclusionBufferTest, NothingIsHiddenOffTheScreenOrWithoutCoverage) {
    const ImpostorCoverage::Grid solid = uniformGrid(0.999f);
    OcclusionBuffer buffer;
    buffer.add(billboard(solid, {0.0f, -1e30f}, {0.0f, 1e30f}, 1e30f));
    EXPECT_FLOAT_EQ(buffer.visibleShare({}), 1.0f);
    for (const osg::Vec2& way : {osg::Vec2(1, 0), osg::Vec2(-1, 0), osg::Vec2(0, 1), osg::Vec2(0, -1)})
        for (const float away : {2.0f, 1e9f, 1e30f}) {
            const osg::Vec2 low = way * away;
            EXPECT_FLOAT_EQ(
                buffer.visibleShare(billboard(solid, low, low + osg::Vec2(0.0f, 0.1f * away), 0.1f)), 1.0f)
                << low.x() << ' ' << low.y();
        }
}

TEST(OcclusionBufferTest, TreeIsHiddenIfLessThanAPixelShows) {
    const ImpostorCoverage::Grid crown = uniformGrid(0.9f);
    const auto low = osg::Vec2(0.0f, -0.1f), high = osg::Vec2(0.0f, 0.1f);
    const OcclusionBuffer::Billboard tree = billboard(crown, low, high, 0.1f);
    const float share = 0.9f * 0.1f * 0.1f; // of the screen, if nothing hides the tree
    OcclusionBuffer buffer;
    EXPECT_FALSE(buffer.isHidden(tree, 1.0f)) << "nothing is in front of it";
    const ImpostorCoverage::Grid before = uniformGrid(0.99f);
    buffer.add(billboard(before, {0.0f, -1.0f}, {0.0f, 1.0f}, 0.5f));
    EXPECT_TRUE(buffer.isHidden(tree, 0.0101f * share));
    EXPECT_FALSE(buffer.isHidden(tree, 0.0099f * share));
    EXPECT_FALSE(buffer.isHidden(billboard(crown, {0.5f, -0.1f}, {0.5f, 0.1f}, 0.1f), 1.0f))
        << "beside the occluder";
    EXPECT_FALSE(buffer.isHidden({}, 1.0f));
    EXPECT_FALSE(buffer.isHidden(billboard(crown, {3.0f, -0.1f}, {3.0f, 0.1f}, 0.1f), 1.0f))
        << "off the screen";
}

TEST(OcclusionBufferTest, FindsTheMinimumInARectangle) {
    const ImpostorCoverage::Grid half = uniformGrid(0.5f);
    OcclusionBuffer buffer;
    buffer.add(billboard(half, {-0.5f, -1.0f}, {-0.5f, 1.0f}, 0.5f)); // the left half
    EXPECT_FLOAT_EQ(buffer.minTransmittance({-0.9f, -0.5f}, {-0.1f, 0.5f}), 0.5f);
    EXPECT_FLOAT_EQ(buffer.minTransmittance({-0.2f, -0.5f}, {0.2f, 0.5f}), 0.5f);
    EXPECT_FLOAT_EQ(buffer.minTransmittance({0.1f, -9.0f}, {9.0f, 9.0f}), 1.0f);
    EXPECT_FLOAT_EQ(buffer.minTransmittance({-9.0f, 2.0f}, {9.0f, 3.0f}), 1.0f);
}

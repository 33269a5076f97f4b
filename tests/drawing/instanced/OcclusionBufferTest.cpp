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

TEST(OcclusionBufferTest, TreeIsHiddenWhereHardlyAnyLightPasses) {
    const ImpostorCoverage::Grid crown = uniformGrid(0.9f);
    const OcclusionBuffer::Billboard tree = billboard(crown, {0.0f, -0.1f}, {0.0f, 0.1f}, 0.1f);
    const auto isHiddenBehind = [&](float coverage) {
        OcclusionBuffer buffer;
        const ImpostorCoverage::Grid before = uniformGrid(coverage);
        buffer.add(billboard(before, {0.0f, -1.0f}, {0.0f, 1.0f}, 0.5f));
        EXPECT_FALSE(buffer.isHidden(billboard(crown, {0.52f, -0.1f}, {0.52f, 0.1f}, 0.1f)))
            << "partly beside the occluder";
        EXPECT_FALSE(buffer.isHidden(OcclusionBuffer::Billboard{}));
        EXPECT_FALSE(buffer.isHidden(billboard(crown, {3.0f, -0.1f}, {3.0f, 0.1f}, 0.1f)))
            << "off the screen";
        return buffer.isHidden(tree);
    };
    EXPECT_FALSE(isHiddenBehind(0.0f));
    EXPECT_FALSE(isHiddenBehind(0.97f));
    EXPECT_TRUE(isHiddenBehind(0.99f));
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

TEST(OcclusionBufferTest, PartsHideWhatIsBehindTheirCores) {
    const OcclusionBuffer::Rectangle leaves{{-0.8f, -0.8f}, {0.8f, 0.8f}, {-0.5f, -0.5f}, {0.5f, 0.5f}, 0.9f},
        behind{{-0.3f, -0.3f}, {0.3f, 0.3f}, {}, {}, 0.0f},
        beside{{0.55f, -0.3f}, {0.75f, 0.3f}, {}, {}, 0.0f};
    OcclusionBuffer buffer;
    EXPECT_FALSE(buffer.isHidden(behind));
    buffer.add(leaves);
    EXPECT_NEAR(buffer.minTransmittance(behind.low, behind.high), 0.1f, 1e-6f);
    EXPECT_FALSE(buffer.isHidden(behind)) << "a tenth of it shows";
    buffer.add(leaves);
    EXPECT_TRUE(buffer.isHidden(behind));
    EXPECT_FALSE(buffer.isHidden(beside)) << "within the bounds of the leaves, but not behind their core";
}

TEST(OcclusionBufferTest, PartWithAGapInFrontOfItIsVisible) {
    const auto rectangle = [](float left, float right, float coverage) {
        const osg::Vec2 low(left, -1.0f), high(right, 1.0f);
        return OcclusionBuffer::Rectangle{low, high, low, high, coverage};
    };
    const float cell = 2.0f / OcclusionBuffer::columns; // at 0, a cell begins
    OcclusionBuffer buffer;
    buffer.add(rectangle(-1.0f, 0.0f, 0.999f));
    buffer.add(rectangle(cell, 1.0f, 0.999f));
    const OcclusionBuffer::Rectangle wide = rectangle(-0.9f, 0.9f, 0.0f);
    EXPECT_FALSE(buffer.isHidden(wide)) << "one of 173 columns is empty";
    buffer.add(rectangle(0.0f, cell, 0.85f));
    EXPECT_FALSE(buffer.isHidden(wide)) << "15 % of a column show";
    buffer.add(rectangle(0.0f, cell, 0.5f));
    EXPECT_TRUE(buffer.isHidden(wide));
    EXPECT_FALSE(buffer.isHidden(rectangle(-cell, 2.0f * cell, 0.0f))) << "2.6 % of it show";
}

TEST(OcclusionBufferTest, PartsMayExtendBeyondTheScreen) {
    const auto square = [](float x, float half) {
        const osg::Vec2 low(x - half, -half), high(x + half, half);
        return OcclusionBuffer::Rectangle{low, high, low, high, 0.99f};
    };
    OcclusionBuffer buffer;
    EXPECT_FALSE(buffer.isHidden(square(1.5f, 1.0f)));
    buffer.add(square(1.0e30f, 1.0e30f)); // the right half
    EXPECT_TRUE(buffer.isHidden(square(1.5f, 1.0f)));
    EXPECT_FALSE(buffer.isHidden(square(-1.5f, 1.0f)));
    EXPECT_FALSE(buffer.isHidden(square(2.5f, 1.0f))) << "it may sway into the view";
}

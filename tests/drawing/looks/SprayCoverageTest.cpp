// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SprayCoverage.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

const LeafOutline square{{0.5f, 0.0f}, {0.5f, 1.0f}};

LeafBlade leafAt(const glm::vec2& foot) {
    LeafBlade leaf;
    leaf.foot = foot;
    leaf.length = 0.2f;
    return leaf;
}

} // namespace

TEST(SprayCoverage, LeavesCoverTheirArea) {
    SprayCoverage cover;
    cover.addLeaf(square, leafAt({0.3f, 0.3f}));
    EXPECT_NEAR(cover.leafShare(), 0.04f, 5e-4f);
    EXPECT_NEAR(cover.freeShare(square, leafAt({0.4f, 0.3f})), 0.5f, 0.02f);
    EXPECT_FLOAT_EQ(cover.freeShare(square, leafAt({0.7f, 0.3f})), 1.0f);
    cover.addLeaf(square, leafAt({0.4f, 0.3f}));
    EXPECT_NEAR(cover.leafShare(), 0.06f, 1e-3f);
}

TEST(SprayCoverage, FitsTwigsToACoverage) {
    SprayCoverage cover;
    const std::vector<TwigPiece> twigs =
        cover.fitTwigs({{{0.5f, 0.1f}, {0.5f, 0.9f}, 2.4f, 2.4f}}, 0.08f); // fits a width of 0.1
    EXPECT_NEAR(twigs.front().footWidth, 0.1f, 2e-3f);
    cover.addLeaf(square, leafAt({0.5f, 0.3f})); // half on the twig
    EXPECT_NEAR(cover.leafShare(), 0.02f, 1e-3f);
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/TreeRaster.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

TreeRaster::Stencil solidStencil() {
    TreeRaster::Stencil stencil;
    stencil.fill(1);
    return stencil;
}

int seen(const TreeRaster& raster, std::uint32_t item) {
    int count = 0;
    for (int y = 0; y < raster.size(); ++y)
        for (int x = 0; x < raster.size(); ++x)
            count += raster.sample(x, y).item == item;
    return count;
}

} // namespace

TEST(TreeRaster, PieceCoversItsArea) {
    TreeRaster raster(100);
    raster.draw({{20.3f, 10.1f, 0.0f}, {40.0f, 20.0f, 0.0f}, {-10.0f, 50.0f, 0.0f}}, solidStencil(), 7);
    EXPECT_NEAR(seen(raster, 7), 40 * 50 + 20 * 10, 40);
    EXPECT_EQ(raster.sample(99, 0).item, TreeRaster::nothing);
}

TEST(TreeRaster, ThinPiecesCoverTheirAreaOnAverage) {
    int sum = 0;
    for (int i = 0; i < 200; ++i) {
        TreeRaster raster(100);
        raster.draw(
            {{10.0f + 0.37f * static_cast<float>(i), 10.0f, 0.0f}, {0.2f, 0.0f, 0.0f}, {0.0f, 80.0f, 0.0f}},
            solidStencil(), 1);
        sum += seen(raster, 1);
    }
    EXPECT_NEAR(sum / 200.0, 16.0, 1.0);
}

TEST(TreeRaster, NearestPieceIsVisibleInAnyOrder) {
    for (const bool nearFirst : {false, true}) {
        TreeRaster raster(10);
        for (const std::uint32_t item : {nearFirst ? 1u : 0u, nearFirst ? 0u : 1u})
            raster.draw({{0, 0, static_cast<float>(item)}, {10, 0, 0}, {0, 10, 0}}, solidStencil(), item);
        EXPECT_EQ(seen(raster, 1), 100);
    }
}

TEST(TreeRaster, DepthIsInterpolated) {
    TreeRaster raster(10);
    raster.draw({{0, 0, -1}, {10, 0, 2}, {0, 10, 0}}, solidStencil(), 0); // nearer to the right
    raster.draw({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, solidStencil(), 1);
    EXPECT_EQ(raster.sample(0, 5).item, 1u);
    EXPECT_EQ(raster.sample(9, 5).item, 0u);
}

TEST(TreeRaster, StencilsHaveHoles) {
    TreeRaster::Stencil left{};
    for (std::size_t i = 0; i < left.size(); ++i)
        left[i] = i % TreeRaster::cells < TreeRaster::cells / 2;
    TreeRaster raster(10);
    raster.draw({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, left, 3);
    EXPECT_EQ(seen(raster, 3), 50);
    EXPECT_EQ(raster.sample(2, 7).item, 3u);
    EXPECT_EQ(raster.sample(2, 7).cell % TreeRaster::cells, 8);
    EXPECT_EQ(raster.sample(2, 7).cell / TreeRaster::cells, 24);
}

TEST(TreeRaster, ClipsPiecesAndSkipsDegenerateOnes) {
    TreeRaster raster(10);
    raster.draw({{-50, -50, 0}, {20, 0, 0}, {0, 20, 0}}, solidStencil(), 1);
    raster.draw({{1, 1, 0}, {5, 5, 0}, {2, 2, 0}}, solidStencil(), 1);
    EXPECT_EQ(seen(raster, 1), 0);
    raster.draw({{-50, -50, 0}, {100, 0, 0}, {0, 100, 0}}, solidStencil(), 2);
    EXPECT_EQ(seen(raster, 2), 100);
}

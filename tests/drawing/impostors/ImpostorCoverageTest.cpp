// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/ImpostorCoverage.h>

#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace osgTreeWind;

namespace {

/// Pictures of two azimuths and two elevations with alpha(elevation, x, y) inside their margins.
template <typename Alpha>
ImpostorPictures pictures(int pixels, Alpha alpha) {
    ImpostorPictures pictures;
    pictures.azimuths = pictures.elevations = 2;
    pictures.pixels = pixels;
    pictures.colors = new osg::Image;
    pictures.colors->allocateImage(2 * pixels, 2 * pixels, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::fill_n(pictures.colors->data(), pictures.colors->getTotalSizeInBytes(), 0);
    const int margin = pixels / 16;
    for (int y = margin; y < 2 * pixels; ++y)
        for (int x = margin; x < 2 * pixels; ++x)
            if (x % pixels >= margin && x % pixels < pixels - margin && y % pixels >= margin &&
                y % pixels < pixels - margin)
                pictures.colors->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[3] =
                    alpha(y / pixels, x % pixels - margin, y % pixels - margin);
    return pictures;
}

} // namespace

TEST(ImpostorCoverageTest, IsTheMeanOfEachGridCell) {
    for (const int pixels : {32, 64, 128}) {
        const int inner = pixels - pixels / 8;
        const ImpostorCoverage cover(pictures(pixels, [&](int elevation, int x, int y) -> unsigned char {
            return elevation == 0 ? (y < inner / 2 ? 255 : 51) : (x < inner / 2 ? 0 : 255);
        }));
        for (int i = 0; i < ImpostorCoverage::side * ImpostorCoverage::side; ++i) {
            const auto place = static_cast<std::size_t>(i);
            const bool lower = i / ImpostorCoverage::side < ImpostorCoverage::side / 2,
                       left = i % ImpostorCoverage::side < ImpostorCoverage::side / 2;
            EXPECT_NEAR(cover.grid(0)[place], lower ? 1.0f : 0.2f, 1e-4f) << pixels << ' ' << i;
            EXPECT_NEAR(cover.grid(1)[place], left ? 0.0f : 1.0f, 1e-4f) << pixels << ' ' << i;
        }
    }
}

TEST(ImpostorCoverageTest, CrownsCoverMoreThanTrunksAndBareTrees) {
    const TreeModel model = makeTreeModel({});
    ImpostorSettings settings;
    const ImpostorCoverage leafy(paintImpostor(model, {}, settings));
    settings.leaves = 0.0f;
    const ImpostorCoverage bare(paintImpostor(model, {}, settings));
    const auto sum = [](const ImpostorCoverage::Grid& grid, std::size_t from, std::size_t to) {
        return std::accumulate(grid.begin() + static_cast<std::ptrdiff_t>(from),
                               grid.begin() + static_cast<std::ptrdiff_t>(to), 0.0f);
    };
    EXPECT_GT(sum(leafy.grid(0), 32, 48), 2.0f * sum(leafy.grid(0), 0, 16));
    EXPECT_LT(sum(bare.grid(0), 0, 64), 0.9f * sum(leafy.grid(0), 0, 64));
    for (const float hides : leafy.grid(0))
        EXPECT_TRUE(hides >= 0.0f && hides <= 1.0f) << hides;
}

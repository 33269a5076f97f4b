// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SprayRaster.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// Rasterized area, as a share of the card.
double areaOf(const std::vector<glm::vec2>& polygon) {
    SprayRaster raster;
    double samples = 0.0;
    for (const SprayRaster::Span& span : raster.spans(polygon))
        samples += span.end - span.first;
    return samples / (SprayRaster::size * SprayRaster::size);
}

/// Shoelace formula.
double exactArea(const std::vector<glm::vec2>& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return 0.5 * std::abs(twice);
}

} // namespace

TEST(SprayRaster, SampleCountMatchesTheArea) {
    const std::vector<glm::vec2> triangle{{0.1f, 0.05f}, {0.93f, 0.2f}, {0.4f, 0.88f}},
        dented{{0.1f, 0.1f}, {0.5f, 0.45f}, {0.9f, 0.1f}, {0.9f, 0.9f}, {0.5f, 0.55f}, {0.1f, 0.9f}};
    EXPECT_NEAR(areaOf(triangle), exactArea(triangle), 1e-3);
    EXPECT_NEAR(areaOf(dented), exactArea(dented), 1e-3);
}

TEST(SprayRaster, UsesTheEvenOddRule) {
    // A square inside a square, as one polygon.
    const std::vector<glm::vec2> framed{{0.1f, 0.1f}, {0.9f, 0.1f}, {0.9f, 0.9f}, {0.1f, 0.9f}, {0.1f, 0.1f},
                                        {0.3f, 0.3f}, {0.7f, 0.3f}, {0.7f, 0.7f}, {0.3f, 0.7f}, {0.3f, 0.3f}};
    EXPECT_NEAR(areaOf(framed), 0.64 - 0.16, 5e-3);
}

TEST(SprayRaster, ClipsToTheCard) {
    EXPECT_DOUBLE_EQ(areaOf({{-1.0f, -1.0f}, {3.0f, -1.0f}, {3.0f, 3.0f}, {-1.0f, 3.0f}}), 1.0);
    EXPECT_DOUBLE_EQ(areaOf({{1.1f, 0.2f}, {1.5f, 0.2f}, {1.3f, 0.8f}}), 0.0);
    SprayRaster raster;
    EXPECT_TRUE(raster.spans({{0.2f, 1.1f}, {0.8f, 1.1f}, {0.5f, 1.5f}}).empty());
    for (const SprayRaster::Span& span : raster.spans({{-0.5f, 0.5f}, {0.5f, -0.5f}, {1.5f, 1.5f}})) {
        EXPECT_GE(span.first, 0);
        EXPECT_LE(span.end, SprayRaster::size);
        EXPECT_GE(span.row, 0);
        EXPECT_LT(span.row, SprayRaster::size);
    }
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/ShadeGrid.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgTreeWind {
namespace {

const glm::vec3 lowest(-4.0f, -4.0f, 0.0f), highest(4.0f, 4.0f, 10.0f);

ShadeGrid canopy(float from, float to, float leafArea) {
    ShadeGrid grid(0.5f);
    grid.reset(lowest, highest);
    for (float x = -3.75f; x < 4.0f; x += 0.5f)
        for (float y = -3.75f; y < 4.0f; y += 0.5f)
            for (float z = from; z < to; z += 0.5f)
                grid.addLeaves({x, y, z}, leafArea);
    grid.computeLight();
    return grid;
}

TEST(ShadeGrid, LightIsFullWithoutLeaves) {
    ShadeGrid grid(0.5f);
    grid.reset(lowest, highest);
    grid.computeLight();
    for (float z = 0.0f; z < 10.0f; z += 0.7f)
        EXPECT_NEAR(grid.light({0.3f, -0.4f, z}), 1.0f, 1e-5f);
    EXPECT_LT(glm::length(grid.lightGradient({0.0f, 0.0f, 5.0f})), 1e-3f);
}

TEST(ShadeGrid, IsDarkBelowLeavesAndBrighterAtTheSide) {
    const ShadeGrid grid = canopy(5.0f, 8.0f, 0.15f);
    const float above = grid.light({0.0f, 0.0f, 9.5f}), within = grid.light({0.0f, 0.0f, 6.5f});
    const float below = grid.light({0.0f, 0.0f, 3.0f}), atSide = grid.light({4.0f, 0.0f, 3.0f});
    EXPECT_NEAR(above, 1.0f, 0.02f);
    EXPECT_LT(within, 0.5f);
    EXPECT_LT(below, 0.5f);
    EXPECT_GT(atSide, 1.5f * below);
    EXPECT_GT(grid.lightGradient({3.0f, 0.0f, 3.0f}).x, 0.0f);
    EXPECT_GT(grid.lightGradient({0.0f, 0.0f, 7.0f}).z, 0.1f);
}

TEST(ShadeGrid, DenserLeavesCastMoreShade) {
    float before = 1.0f;
    for (const float area : {0.02f, 0.05f, 0.1f, 0.3f, 1.0f}) {
        const float light = canopy(5.0f, 8.0f, area).light({0.0f, 0.0f, 2.0f});
        EXPECT_LT(light, before);
        EXPECT_GT(light, 0.0f);
        before = light;
    }
}

TEST(ShadeGrid, LightIsSymmetricAroundASymmetricCrown) {
    const ShadeGrid grid = canopy(5.0f, 8.0f, 0.1f);
    EXPECT_NEAR(grid.light({2.0f, 0.5f, 4.0f}), grid.light({-2.0f, 0.5f, 4.0f}), 1e-4f);
    EXPECT_NEAR(grid.light({2.0f, 0.5f, 4.0f}), grid.light({0.5f, 2.0f, 4.0f}), 1e-4f);
}

TEST(ShadeGrid, NeighboursLeaveTheOpenSideBright) {
    GrowthSite site;
    site.shade = 1.0f;
    site.distance = 3.0f;
    const auto lightAt = [&](const glm::vec3& place) {
        ShadeGrid grid(0.5f);
        grid.reset(lowest, highest);
        grid.addNeighbours(site, {0.0f, 0.0f}, 9.0f);
        grid.computeLight();
        return grid.light(place);
    };
    const float wood = lightAt({0.0f, 0.0f, 2.0f}), top = lightAt({0.0f, 0.0f, 9.5f});
    EXPECT_LT(wood, 0.35f);
    EXPECT_GT(top, 0.9f);
    site.openSide = 0.0f;
    EXPECT_GT(lightAt({0.0f, 0.0f, 2.0f}), 1.2f * wood);
    EXPECT_GT(lightAt({3.0f, 0.0f, 2.0f}), 2.0f * lightAt({-3.0f, 0.0f, 2.0f}));
}

} // namespace
} // namespace osgTreeWind

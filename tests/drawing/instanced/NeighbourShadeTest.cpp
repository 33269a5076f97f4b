// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

constexpr std::uint32_t side = 9, middle = side * side / 2;

NeighbourShade::Crown crownAt(float x, float y, float height = 20.0f, float density = 0.9f) {
    return {{x, y, 0.0f}, height, 3.0f, density};
}

/// A grid of equal trees, 5 m apart.
NeighbourShade stand(float density = 0.9f) {
    NeighbourShade shade;
    for (std::uint32_t i = 0; i < side * side; ++i)
        shade.insert(i, crownAt(5.0f * static_cast<float>(i % side), 5.0f * static_cast<float>(i / side),
                                20.0f, density));
    shade.update();
    return shade;
}

} // namespace

TEST(NeighbourShade, SolitaryTreeGetsAllLight) {
    NeighbourShade shade;
    shade.insert(3, crownAt(1e6f, -1e6f));
    shade.insert(4, crownAt(0.0f, 0.0f));
    shade.update();
    EXPECT_EQ(shade.light(3).atFoot, 1.0f);
    EXPECT_EQ(shade.light(3).atTop, 1.0f);
}

TEST(NeighbourShade, StandIsDarkAtTheGroundAndLitAtTopsAndEdges) {
    const NeighbourShade shade = stand();
    EXPECT_LT(shade.light(middle).atFoot, 0.75f);
    EXPECT_GT(shade.light(middle).atFoot, 0.1f);
    EXPECT_EQ(shade.light(middle).atTop, 1.0f) << "no crown is above it";
    EXPECT_GT(shade.light(0).atFoot, shade.light(middle).atFoot + 0.1f) << "a corner";
}

TEST(NeighbourShade, BareCrownsShadeLess) {
    EXPECT_GT(stand(0.35f).light(middle).atFoot, stand().light(middle).atFoot + 0.08f);
}

TEST(NeighbourShade, SaplingUnderTallTreesIsShadedFromFootToTop) {
    NeighbourShade shade = stand();
    shade.insert(1000, crownAt(22.5f, 22.5f, 3.0f));
    shade.update();
    EXPECT_LT(shade.light(1000).atTop, 0.75f);
    EXPECT_NEAR(shade.light(1000).atTop, shade.light(1000).atFoot, 0.1f);
}

TEST(NeighbourShade, ChangesAreReversible) {
    NeighbourShade shade = stand();
    const float before = shade.light(middle).atFoot;
    shade.remove(middle + 1);
    shade.insert(middle - 1, crownAt(500.0f, 0.0f)); // moves away
    shade.update();
    EXPECT_GT(shade.light(middle).atFoot, before + 0.02f);
    EXPECT_EQ(shade.light(middle - 1).atFoot, 1.0f);
    shade.insert(middle + 1, crownAt(5.0f * ((middle + 1) % side), 5.0f * ((middle + 1) / side)));
    shade.insert(middle - 1, crownAt(5.0f * ((middle - 1) % side), 5.0f * ((middle - 1) / side)));
    shade.update();
    EXPECT_NEAR(shade.light(middle).atFoot, before, 1e-6f);
}

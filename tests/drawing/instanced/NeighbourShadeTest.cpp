// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/NeighbourShade.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

constexpr std::uint32_t side = 9, middle = side * side / 2;

NeighbourShade::Crown crownAt(float x, float y, float height = 20.0f, float density = 0.9f) {
    return {{x, y, 0.0f}, height, 3.0f, density};
}

/// Trees of one size, 5 m apart.
NeighbourShade stand(float density = 0.9f) {
    NeighbourShade shade;
    for (std::uint32_t i = 0; i < side * side; ++i)
        shade.put(i, crownAt(5.0f * static_cast<float>(i % side), 5.0f * static_cast<float>(i / side), 20.0f,
                             density));
    shade.update();
    return shade;
}

} // namespace

TEST(NeighbourShade, ATreeInTheOpenHasAllLight) {
    NeighbourShade shade;
    shade.put(3, crownAt(1e6f, -1e6f));
    shade.put(4, crownAt(0.0f, 0.0f));
    shade.update();
    EXPECT_EQ(shade.left(3).atFoot, 1.0f);
    EXPECT_EQ(shade.left(3).atTop, 1.0f);
}

TEST(NeighbourShade, AStandIsDarkAtItsFeetAndLitAtItsTopsAndEdges) {
    const NeighbourShade shade = stand();
    EXPECT_LT(shade.left(middle).atFoot, 0.65f);
    EXPECT_GT(shade.left(middle).atFoot, 0.1f);
    EXPECT_EQ(shade.left(middle).atTop, 1.0f) << "no crown is above it";
    EXPECT_GT(shade.left(0).atFoot, shade.left(middle).atFoot + 0.1f) << "a corner";
}

TEST(NeighbourShade, BareCrownsKeepLess) {
    EXPECT_GT(stand(0.35f).left(middle).atFoot, stand().left(middle).atFoot + 0.1f);
}

TEST(NeighbourShade, ASaplingUnderTallTreesIsShadedAllOver) {
    NeighbourShade shade = stand();
    shade.put(1000, crownAt(22.5f, 22.5f, 3.0f));
    shade.update();
    EXPECT_LT(shade.left(1000).atTop, 0.65f);
    EXPECT_NEAR(shade.left(1000).atTop, shade.left(1000).atFoot, 0.1f);
}

TEST(NeighbourShade, ChangesLeaveWhatATreeMadeAnewWouldHave) {
    NeighbourShade shade = stand();
    const float before = shade.left(middle).atFoot;
    shade.take(middle + 1);
    shade.put(middle - 1, crownAt(500.0f, 0.0f)); // moves away
    shade.update();
    EXPECT_GT(shade.left(middle).atFoot, before + 0.02f);
    EXPECT_EQ(shade.left(middle - 1).atFoot, 1.0f);
    shade.put(middle + 1, crownAt(5.0f * ((middle + 1) % side), 5.0f * ((middle + 1) / side)));
    shade.put(middle - 1, crownAt(5.0f * ((middle - 1) % side), 5.0f * ((middle - 1) / side)));
    shade.update();
    EXPECT_NEAR(shade.left(middle).atFoot, before, 1e-6f);
}

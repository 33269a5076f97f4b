// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/portraits/Silhouette.h>

#include <tests/tool/portraits/SolidMask.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// A chequerboard of 4 x 4 cells.
Silhouette::Mask chequered() {
    Silhouette::Mask mask{4, {}};
    for (int i = 0; i < 16; ++i)
        mask.solid.push_back((i + i / 4) % 2);
    return mask;
}

} // namespace

TEST(Silhouette, RectangleCoversPixelsWithCentresInside) {
    Silhouette picture(32);
    picture.draw({4.0f, 5.0f}, {10.0f, 0.0f}, {0.0f, 6.0f}, solidMask);
    EXPECT_EQ(picture.count(), 60u);
    EXPECT_TRUE(picture.black(4, 5));
    EXPECT_TRUE(picture.black(13, 10));
    EXPECT_FALSE(picture.black(14, 10));
    EXPECT_FALSE(picture.black(13, 11));
}

TEST(Silhouette, ParallelogramCoversItsArea) {
    for (const float turn : {0.0f, 0.4f, 1.9f, 4.0f}) {
        Silhouette picture(400);
        const glm::vec2 across = 150.0f * glm::vec2(std::cos(turn), std::sin(turn)),
                        along = 90.0f * glm::vec2(std::cos(turn + 1.2f), std::sin(turn + 1.2f));
        const glm::vec2 corner = glm::vec2(200.0f) - 0.5f * (across + along);
        const float area = std::abs(across.x * along.y - across.y * along.x);
        picture.draw(corner, across, along, solidMask);
        EXPECT_NEAR(static_cast<float>(picture.count()) / area, 1.0f, 0.01f) << turn;
        Silhouette half(400);
        half.draw(corner, across, along, chequered());
        EXPECT_NEAR(static_cast<float>(half.count()) / area, 0.5f, 0.01f) << turn;
    }
}

TEST(Silhouette, PartsOutsideAreClipped) {
    Silhouette picture(16);
    picture.draw({-8.0f, -8.0f}, {16.0f, 0.0f}, {0.0f, 16.0f}, solidMask);
    EXPECT_EQ(picture.count(), 64u);
    picture.draw({5.0f, 5.0f}, {4.0f, 4.0f}, {8.0f, 8.0f}, solidMask); // edge on
    picture.draw({1e9f, 0.0f}, {4.0f, 0.0f}, {0.0f, 4.0f}, solidMask);
    picture.draw({NAN, 0.0f}, {4.0f, 0.0f}, {0.0f, 4.0f}, solidMask);
    EXPECT_EQ(picture.count(), 64u);
}

TEST(Silhouette, OutlineClosesGapsAndHolesAndKeepsBays) {
    Silhouette picture(100);
    picture.draw({20.0f, 20.0f}, {60.0f, 0.0f}, {0.0f, 60.0f}, solidMask);
    const Silhouette square = picture.outline(8);
    EXPECT_EQ(square.count(), 3600u); // nothing to close
    Silhouette ring(100);
    ring.draw({20.0f, 20.0f}, {60.0f, 0.0f}, {0.0f, 10.0f}, solidMask);
    ring.draw({20.0f, 70.0f}, {60.0f, 0.0f}, {0.0f, 10.0f}, solidMask);
    ring.draw({20.0f, 20.0f}, {10.0f, 0.0f}, {0.0f, 60.0f}, solidMask);
    ring.draw({70.0f, 20.0f}, {10.0f, 0.0f}, {0.0f, 25.0f}, solidMask);
    ring.draw({70.0f, 51.0f}, {10.0f, 0.0f}, {0.0f, 29.0f}, solidMask); // leaves a gap of 6 on the right
    EXPECT_EQ(ring.outline(8).count(), 3600u);
    EXPECT_EQ(ring.outline(4).count(), ring.count()); // does not close the gap, so the inside stays open
    EXPECT_EQ(ring.common(square), ring.count());
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/StemFoot.h>
#include <tests/model/SampleTree.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgTreeWind {
namespace {

Skeleton stem(float height, float flare) {
    PalmParameters pole = barePole(height);
    pole.flare = flare;
    return makePalmTree(pole);
}

TEST(StemFoot, WidensTheGroundByTheFlare) {
    const StemFoot foot(stem(10.0f, 0.6f));
    float mean = 0.0f, widest = 0.0f;
    for (int i = 0; i < 60; ++i) {
        const float here = foot.widening(0.0f, 0.10471976f * static_cast<float>(i));
        mean += here / 60.0f;
        widest = glm::max(widest, here);
    }
    EXPECT_NEAR(mean, 1.0f + 0.6f * 0.99f, 0.001f);
    EXPECT_GT(widest, 1.3f * mean) << "buttress roots should protrude";
    EXPECT_LT(foot.widening(0.5f, 0.0f), foot.widening(0.1f, 0.0f));
}

TEST(StemFoot, ReachesATenthOfTheTreeAndAtMostBreastHeight) {
    EXPECT_NEAR(StemFoot(stem(5.0f, 0.6f)).height(), 0.5f, 0.1f);
    EXPECT_EQ(StemFoot(stem(40.0f, 0.6f)).height(), 1.2f);
    EXPECT_EQ(StemFoot(stem(40.0f, 0.6f)).widening(1.2f, 1.0f), 1.0f);
}

TEST(StemFoot, NormalsPointAwayFromRootsAndUp) {
    const StemFoot foot(stem(20.0f, 0.6f));
    constexpr float step = 0.01f, radius = 0.3f;
    for (int i = 0; i < 60; ++i) {
        const float angle = 0.10471976f * static_cast<float>(i), z = 0.2f;
        const glm::vec3 normal = foot.normal(z, angle, radius);
        EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
        EXPECT_GT(normal.z, 0.0f) << "the foot widens downward";
        const float rises = foot.widening(z, angle + step) - foot.widening(z, angle - step);
        EXPECT_LE(rises * normal.y, 1e-4f) << angle;
    }
    EXPECT_NEAR(foot.normal(1.19f, 1.0f, radius).x, 1.0f, 0.01f);
}

TEST(StemFoot, WithoutAFlareDoesNotWiden) {
    const StemFoot foot(stem(10.0f, 0.0f));
    EXPECT_EQ(foot.height(), 0.0f);
    EXPECT_EQ(foot.widening(0.0f, 1.0f), 1.0f);
}

} // namespace
} // namespace osgTreeWind

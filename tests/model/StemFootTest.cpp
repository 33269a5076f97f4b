// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/StemFoot.h>
#include <tests/model/SampleTree.h>

#include <glm/common.hpp>
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
    EXPECT_GT(widest, 1.1f * mean) << "buttress roots should protrude";
    EXPECT_LT(foot.widening(0.5f, 0.0f), foot.widening(0.1f, 0.0f));
}

TEST(StemFoot, ReachesATenthOfTheTreeAndAtMostBreastHeight) {
    EXPECT_NEAR(StemFoot(stem(5.0f, 0.6f)).height(), 0.5f, 0.1f);
    EXPECT_EQ(StemFoot(stem(40.0f, 0.6f)).height(), 1.2f);
    EXPECT_EQ(StemFoot(stem(40.0f, 0.6f)).widening(1.2f, 1.0f), 1.0f);
}

TEST(StemFoot, WithoutAFlareDoesNotWiden) {
    const StemFoot foot(stem(10.0f, 0.0f));
    EXPECT_EQ(foot.height(), 0.0f);
    EXPECT_EQ(foot.widening(0.0f, 1.0f), 1.0f);
}

} // namespace
} // namespace osgTreeWind

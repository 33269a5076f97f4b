// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeTiers.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

DrawingOptions heights() {
    DrawingOptions drawing;
    drawing.full = 800.0f; // also sets 400, 200, and 3200 for Full
    drawing.reduced = 100.0f;
    drawing.impostor = 50.0f;
    drawing.blend = 0.2f;
    return drawing;
}

} // namespace

TEST(TreeTiersTest, ChoosesTheTierByHeightOnTheScreen) {
    const TreeTiers tiers(heights());
    const struct {
        float pixels;
        Tier tier;
    } cases[] = {{1e9f, Tier::Full},          {3200.0f, Tier::Full},       {3199.0f, Tier::Sprays},
                 {800.0f, Tier::Sprays},      {639.0f, Tier::Boughs},      {400.0f, Tier::Boughs},
                 {319.0f, Tier::FewerBoughs}, {200.0f, Tier::FewerBoughs}, {159.0f, Tier::FewBoughs},
                 {100.0f, Tier::FewBoughs},   {79.0f, Tier::FewestBoughs}, {50.0f, Tier::FewestBoughs},
                 {39.0f, Tier::Impostor},     {0.0f, Tier::Impostor}};
    for (const auto& each : cases) {
        EXPECT_EQ(tiers.choose(each.pixels).tier, each.tier) << each.pixels;
        EXPECT_EQ(tiers.choose(each.pixels).fade, 1.0f) << each.pixels;
    }
}

TEST(TreeTiersTest, TiersFadeLinearly) {
    const TreeTiers tiers(heights());
    EXPECT_NEAR(tiers.choose(799.9f).fade, 1.0f, 0.01f);
    EXPECT_NEAR(tiers.choose(720.0f).fade, 0.5f, 1e-5f);
    EXPECT_EQ(tiers.choose(720.0f).tier, Tier::Sprays);
    EXPECT_NEAR(tiers.choose(640.1f).fade, 0.0f, 0.01f);
    EXPECT_EQ(tiers.choose(45.0f).tier, Tier::FewestBoughs) << "fades to the impostor";
}

TEST(TreeTiersTest, WithoutTiersAllTreesAreDrawnInFull) {
    DrawingOptions drawing = heights();
    drawing.tiers = false;
    const TreeTiers tiers(drawing);
    EXPECT_FALSE(tiers.areEnabled());
    for (const float pixels : {0.0f, 0.001f, 30.0f, 1e6f}) {
        EXPECT_EQ(tiers.choose(pixels).tier, Tier::Full) << pixels;
        EXPECT_EQ(tiers.choose(pixels).fade, 1.0f) << pixels;
    }
}

TEST(TreeTiersTest, WithoutBlendTiersChangeAtOnce) {
    DrawingOptions drawing = heights();
    drawing.blend = 0.0f;
    const TreeTiers tiers(drawing);
    EXPECT_EQ(tiers.choose(800.0f).tier, Tier::Sprays);
    EXPECT_EQ(tiers.choose(799.0f).tier, Tier::Boughs);
    EXPECT_EQ(tiers.choose(799.0f).fade, 1.0f);
}

TEST(TreeTiersTest, FullMotionStartsBeforeBranchesAppear) {
    const TreeTiers tiers(heights());
    EXPECT_EQ(tiers.choose(tiers.fullMotionPixels()).tier, Tier::Impostor);
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/stand/TreeTiers.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

DrawingOptions heights() {
    DrawingOptions drawing;
    drawing.full = 300.0f;
    drawing.reduced = 120.0f;
    drawing.impostor = 50.0f;
    drawing.blend = 0.2f;
    return drawing;
}

} // namespace

TEST(TreeTiersTest, aTreeHasTheTierOfItsHeightOnTheScreen) {
    const TreeTiers tiers(heights());
    const struct {
        float pixels;
        Tier tier;
    } cases[] = {{1e9f, Tier::Full},      {300.0f, Tier::Full},        {239.0f, Tier::Reduced},
                 {120.0f, Tier::Reduced}, {95.0f, Tier::ReducedTwice}, {50.0f, Tier::ReducedTwice},
                 {39.0f, Tier::Impostor}, {0.0f, Tier::Impostor}};
    for (const auto& each : cases) {
        EXPECT_EQ(tiers.choose(each.pixels).tier, each.tier) << each.pixels;
        EXPECT_EQ(tiers.choose(each.pixels).fade, 1.0f) << each.pixels;
    }
}

TEST(TreeTiersTest, tiersCrossOverEvenly) {
    const TreeTiers tiers(heights());
    EXPECT_NEAR(tiers.choose(299.9f).fade, 1.0f, 0.01f);
    EXPECT_NEAR(tiers.choose(270.0f).fade, 0.5f, 1e-5f);
    EXPECT_EQ(tiers.choose(270.0f).tier, Tier::Full);
    EXPECT_NEAR(tiers.choose(240.1f).fade, 0.0f, 0.01f);
    EXPECT_EQ(tiers.choose(45.0f).tier, Tier::ReducedTwice) << "and the impostor takes the rest";
}

TEST(TreeTiersTest, withoutTiersAllIsDrawnInFull) {
    DrawingOptions drawing = heights();
    drawing.tiers = false;
    const TreeTiers tiers(drawing);
    EXPECT_FALSE(tiers.on());
    for (const float pixels : {0.0f, 0.001f, 30.0f, 1e6f}) {
        EXPECT_EQ(tiers.choose(pixels).tier, Tier::Full) << pixels;
        EXPECT_EQ(tiers.choose(pixels).fade, 1.0f) << pixels;
    }
}

TEST(TreeTiersTest, withoutABlendTiersChangeAtOnce) {
    DrawingOptions drawing = heights();
    drawing.blend = 0.0f;
    const TreeTiers tiers(drawing);
    EXPECT_EQ(tiers.choose(300.0f).tier, Tier::Full);
    EXPECT_EQ(tiers.choose(299.0f).tier, Tier::Reduced);
    EXPECT_EQ(tiers.choose(299.0f).fade, 1.0f);
}

TEST(TreeTiersTest, aTreeIsAwakeBeforeItsBranchesAreSeen) {
    const TreeTiers tiers(heights());
    EXPECT_EQ(tiers.choose(tiers.wakingPixels()).tier, Tier::Impostor);
}

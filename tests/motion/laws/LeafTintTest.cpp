// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Luminance.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr glm::vec3 green{0.11f, 0.20f, 0.05f};

struct Hsv {
    double hue, saturation; ///< Degrees; [0, 1].
};

/// Hue and saturation of a linear colour after gamma encoding.
Hsv seen(const glm::vec3& linear) {
    double c[3];
    for (int i = 0; i < 3; ++i) {
        const double x = static_cast<double>(linear[i]);
        c[i] = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    }
    const double most = *std::max_element(c, c + 3), least = *std::min_element(c, c + 3);
    return {120.0 + 60.0 * (c[2] - c[0]) / (most - least), 1.0 - least / most}; // of a green
}

} // namespace

TEST(LeafTint, TurnsHueBy12DegreesAndSaturationBy15Percent) {
    const Hsv middle = seen(green), bluer = seen(Laws().leafTint(1.0f, 0.0f) * green),
              yellower = seen(Laws().leafTint(-1.0f, 0.0f) * green),
              full = seen(Laws().leafTint(0.0f, 1.0f) * green),
              pale = seen(Laws().leafTint(0.0f, -1.0f) * green);
    EXPECT_NEAR(bluer.hue - middle.hue, 12.0, 2.5);
    EXPECT_NEAR(yellower.hue - middle.hue, -12.0, 2.5);
    EXPECT_NEAR(full.saturation / middle.saturation, 1.15, 0.05);
    EXPECT_NEAR(pale.saturation / middle.saturation, 0.85, 0.05);
}

TEST(LeafTint, KeepsTheLuminanceOfAGreenLeaf) {
    for (const float hue : {-1.0f, 0.0f, 1.0f})
        for (const float saturation : {-1.0f, 0.0f, 1.0f})
            EXPECT_NEAR(luminance(Laws().leafTint(hue, saturation) * green) / luminance(green), 1.0, 0.025);
}

TEST(LeafTint, ClustersHaveManyGreens) {
    std::vector<double> hues;
    for (int leaf = 0; leaf < 1000; ++leaf)
        hues.push_back(seen(Laws().clusterTint(0.3f, static_cast<float>(leaf)) * green).hue);
    std::sort(hues.begin(), hues.end());
    EXPECT_GT(hues[900] - hues[100], 15.0);
}

TEST(LeafShade, FourSharesArePackedInAFloat) {
    for (const glm::vec4& shares : {glm::vec4(1, 1, 1, 1), glm::vec4(0, 0, 0, 0),
                                    glm::vec4(1, 0, 0.5f, 0.25f), glm::vec4(0.03f, 0.7f, 0.99f, 0.01f)}) {
        const glm::vec4 back = Laws().unpackedShares(Laws().packedShares(shares));
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(back[i], shares[i], 0.017f) << i;
    }
    EXPECT_EQ(Laws().packedShares(glm::vec4(1.0f)), 0.0f) << "geometry without shade data is in the open";
}

TEST(LeafShade, BetweenAxesTheShareIsInterpolated) {
    const glm::vec4 above(0.2f, 0.4f, 0.9f, 1.0f), below(0.1f, 0.3f, 0.5f, 1.0f);
    EXPECT_FLOAT_EQ(Laws().shareFrom({1, 0, 0}, above, below), 0.2f);
    EXPECT_FLOAT_EQ(Laws().shareFrom({0, -2, 0}, above, below), 0.3f);
    EXPECT_FLOAT_EQ(Laws().shareFrom({0, 0, 1}, above, below), 0.9f);
    EXPECT_FLOAT_EQ(Laws().shareFrom({-1, 0, 1}, above, below), 0.5f);
}

// SPDX-License-Identifier: MIT
// shaders/law/elementary.glsl against the standard library.
#include <osgTreeWind/motion/laws/Laws.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace osgTreeWind;

TEST(Elementary, ArcSineMatchesTheStandardLibrary) {
    for (int i = -10000; i <= 10000; ++i) {
        const double x = i / 10000.0;
        const float sine = static_cast<float>(x);
        EXPECT_NEAR(Laws().arcSine(sine), std::asin(static_cast<double>(sine)), 3e-7) << x;
    }
}

TEST(Elementary, ArcSineIsExactForSmallAngles) {
    EXPECT_EQ(Laws().arcSine(0.0f), 0.0f);
    EXPECT_EQ(Laws().arcSine(1e-6f), 1e-6f);
    EXPECT_EQ(Laws().arcSine(-1e-12f), -1e-12f);
}

TEST(Elementary, DecayedMatchesTheStandardExponential) {
    for (int i = 0; i <= 86000; ++i) {
        const float x = static_cast<float>(i) / 1000.0f;
        const double expected = std::exp(-static_cast<double>(x));
        ASSERT_NEAR(Laws().decayed(x) / expected, 1.0, 2e-7) << x;
    }
    EXPECT_EQ(Laws().decayed(0.0f), 1.0f);
}

TEST(Elementary, DecayedEndsAtZero) {
    for (const float x : {87.0f, 1e9f, std::numeric_limits<float>::infinity(), std::nanf("")})
        EXPECT_EQ(Laws().decayed(x), 0.0f);
}

TEST(Elementary, CosineAndSineMatchTheStandardLibrary) {
    for (int i = 0; i <= 100000; ++i) {
        const float x = static_cast<float>(i) / 1000.0f;
        const Laws::CosineSine turned = Laws().cosineSine(x);
        ASSERT_NEAR(turned.cosine, std::cos(static_cast<double>(x)), 3e-7) << x;
        ASSERT_NEAR(turned.sine, std::sin(static_cast<double>(x)), 3e-7) << x;
    }
    for (float x = 100.0f; x < 1e4f; x += 0.0137f) {
        const Laws::CosineSine turned = Laws().cosineSine(x);
        ASSERT_NEAR(turned.cosine, std::cos(static_cast<double>(x)), 3e-7) << x;
        ASSERT_NEAR(turned.sine, std::sin(static_cast<double>(x)), 3e-7) << x;
    }
}

TEST(Elementary, CosineAndSineStayInTheUnitCircle) {
    for (float x = 1e4f; x < 1e30f; x *= 1.01f)
        ASSERT_LE(std::hypot(Laws().cosineSine(x).cosine, Laws().cosineSine(x).sine), 1.000001f) << x;
}

TEST(Elementary, LogarithmMatchesTheStandardLibrary) {
    for (float x = 1.0f; x <= 64.0f; x += 0.001f)
        ASSERT_NEAR(Laws().logarithm(x), std::log(static_cast<double>(x)), 5e-7) << x;
    EXPECT_EQ(Laws().logarithm(1.0f), 0.0f);
}

// SPDX-License-Identifier: MIT
// shaders/law/limits.glsl.
#include <osgTreeWind/motion/laws/Laws.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace osgTreeWind;

TEST(Limits, BoundedKeepsClampsAndDropsNaN) {
    Laws laws;
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(laws.bounded(0.25f, 1.0f), 0.25f);
    EXPECT_EQ(laws.bounded(-3.0f, 1.0f), -1.0f);
    EXPECT_EQ(laws.bounded(infinity, 2.0f), 2.0f);
    EXPECT_EQ(laws.bounded(-infinity, 2.0f), -2.0f);
    EXPECT_EQ(laws.bounded(std::nanf(""), 2.0f), 0.0f);
}

TEST(Limits, AngleLimitIsAtMostAQuarterTurn) {
    EXPECT_EQ(Laws().angleLimit(0.5f), 0.5f);
    EXPECT_FLOAT_EQ(Laws().angleLimit(9.0f), std::acos(0.0f));
    EXPECT_EQ(Laws().angleLimit(-0.5f), 0.0f);
}

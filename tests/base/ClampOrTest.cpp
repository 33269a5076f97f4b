// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ClampOr.h>

#include <gtest/gtest.h>

#include <limits>

namespace osgTreeWind {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const float nan = std::nanf("");

TEST(ClampOr, ClampsToTheRange) {
    EXPECT_EQ(clampOr(0.5f, 0.0f, 1.0f, 7.0f), 0.5f);
    EXPECT_EQ(clampOr(-3.0f, 0.0f, 1.0f, 7.0f), 0.0f);
    EXPECT_EQ(clampOr(infinity, 0.0f, 1.0f, 7.0f), 1.0f);
    EXPECT_EQ(clampOr(-infinity, 0.0f, 1.0f, 7.0f), 0.0f);
}

TEST(ClampOr, ReplacesNaN) {
    EXPECT_EQ(clampOr(nan, 0.0f, 1.0f, 0.25f), 0.25f);
}

} // namespace
} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Random.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace osgTreeWind {
namespace {

// The first outputs of SplitMix64 for the seed 1234567, as published with the generator.
TEST(Random, MatchesThePublishedSequence) {
    Random random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317ull);
    EXPECT_EQ(random.next(), 3203168211198807973ull);
    EXPECT_EQ(random.next(), 9817491932198370423ull);
}

TEST(Random, UniformCoversItsRange) {
    Random random(1);
    double sum = 0.0;
    float low = 1.0f, high = 0.0f;
    for (int i = 0; i < 100000; ++i) {
        const float value = random.uniform();
        low = std::min(low, value);
        high = std::max(high, value);
        sum += static_cast<double>(value);
    }
    EXPECT_GE(low, 0.0f);
    EXPECT_LT(low, 1e-3f);
    EXPECT_LT(high, 1.0f);
    EXPECT_GT(high, 0.999f);
    EXPECT_NEAR(sum / 100000.0, 0.5, 0.005);
}

} // namespace
} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/SlowGusts.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using osgTreeWind::SlowGusts;

constexpr glm::vec3 mean(8.0f, 6.0f, 0.0f); // 10 m/s

TEST(SlowGusts, HaveMeanZeroVarianceOneAndALengthOfOneAndAHalfKilometres) {
    constexpr double step = 30.0; // seconds, or 300 m
    double sum = 0.0, squares = 0.0, lagged = 0.0, count = 0.0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const SlowGusts gusts(seed, mean);
        std::vector<double> series;
        for (int i = 0; i < 400; ++i)
            series.push_back(static_cast<double>(gusts.at(step * i).at({0.0f, 0.0f})));
        for (std::size_t i = 0; i + 40 < series.size(); ++i) {
            sum += series[i];
            squares += series[i] * series[i];
            count += 1.0;
            for (std::size_t lag = 0; lag < 40; ++lag) // up to 12 km
                lagged += (lag == 0 ? 0.5 : 1.0) * series[i] * series[i + lag];
        }
    }
    EXPECT_NEAR(sum / count, 0.0, 0.05);
    EXPECT_NEAR(squares / count, 1.0, 0.1);
    EXPECT_NEAR(10.0 * step * lagged / squares, 1500.0, 200.0);
}

TEST(SlowGusts, TravelWithTheWind) {
    const SlowGusts gusts(1, mean);
    for (double time = 0.0; time < 16000.0; time += 160.0) // multiples of 32 m along both axes
        EXPECT_NEAR(gusts.at(time).at({static_cast<float>(8.0 * time), static_cast<float>(6.0 * time)}),
                    gusts.at(0.0).at({0.0f, 0.0f}), 1e-3f);
}

TEST(SlowGusts, DependOnSeedPlaceAndTimeAlone) {
    const SlowGusts gusts(1, mean);
    SlowGusts::Now now = gusts.at(5.0);
    const float here = now.at({3.0f, 4.0f}), there = now.at({1e4f, -3e4f});
    EXPECT_EQ(here, now.at({3.0f, 4.0f}));
    EXPECT_NE(here, there);
    EXPECT_NE(here, SlowGusts(2, mean).at(5.0).at({3.0f, 4.0f}));
    for (const float wild : {std::numeric_limits<float>::quiet_NaN(), 1e30f, -1e30f})
        EXPECT_TRUE(std::isfinite(gusts.at(static_cast<double>(wild)).at({wild, wild})));
}

} // namespace

// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/SwayFeatures.h>
#include <osgTreeWind/base/Random.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

double gaussian(Random& random) {
    double sum = 0.0;
    for (int i = 0; i < 12; ++i)
        sum += random.uniform();
    return sum - 6.0;
}

/// Oscillator driven by white noise along a line 30 degrees from x, and by a third of it across that line.
std::vector<glm::dvec2> oscillator(double hz, double damping, double rate = 8.0) {
    Random random(3);
    const double h = 1.0 / (8.0 * rate), w = 2.0 * 3.141592653589793 * hz;
    glm::dvec2 x(0.0), v(0.0);
    std::vector<glm::dvec2> series;
    for (int i = 0; i < static_cast<int>(3600.0 * rate); ++i) {
        for (int k = 0; k < 8; ++k) {
            const double across = gaussian(random) / 3.0, along = gaussian(random);
            const glm::dvec2 push(along, across);
            v += h * (push / std::sqrt(h) - 2.0 * damping * w * v - w * w * x);
            x += h * v;
        }
        series.emplace_back(0.866 * x.x - 0.5 * x.y, 0.5 * x.x + 0.866 * x.y);
    }
    return series;
}

TEST(SwayFeatures, FindsTheFrequencyAndDampingOfAnOscillator) {
    for (const double damping : {0.05, 0.12}) {
        const auto found = swayFeatures(oscillator(0.3, damping), 8.0, 0.35);
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(found->frequency / 0.3, 1.0, 0.03);
        ASSERT_TRUE(found->damping.has_value());
        EXPECT_NEAR(*found->damping / damping, 1.0, 0.2);
        EXPECT_NEAR(found->alongOverAcross / 9.0, 1.0, 0.25);
        EXPECT_NEAR(found->skewness, 0.0, 0.15);
        EXPECT_NEAR(found->kurtosis, 3.0, 0.35);
        EXPECT_NEAR(found->peak, 3.09, 0.35);
        EXPECT_GT(found->share, damping < 0.1 ? 0.8 : 0.6);
    }
}

TEST(SwayFeatures, TheSkewnessIsPositive) {
    std::vector<glm::dvec2> series = oscillator(0.3, 0.1);
    double square = 0.0;
    for (const glm::dvec2& value : series)
        square += value.x * value.x / static_cast<double>(series.size());
    for (glm::dvec2& value : series)
        value *= 1.0 - 0.5 * std::tanh(value.x / std::sqrt(square));
    const auto found = swayFeatures(series, 8.0, 0.3);
    ASSERT_TRUE(found.has_value());
    EXPECT_GT(found->skewness, 0.3);
}

TEST(SwayFeatures, AreEmptyForUnsuitableSeries) {
    std::vector<glm::dvec2> series = oscillator(0.3, 0.1);
    EXPECT_FALSE(swayFeatures(series, 9.0, 0.3).has_value()) << "9 Hz is not a multiple of 4 Hz";
    EXPECT_FALSE(swayFeatures(series, 8.0, 3.0).has_value());
    series.resize(1000);
    EXPECT_FALSE(swayFeatures(series, 8.0, 0.3).has_value());
    EXPECT_FALSE(swayFeatures(std::vector<glm::dvec2>(30000), 8.0, 0.3).has_value()) << "constant series";
}

} // namespace

// SPDX-License-Identifier: MIT
// shaders/law/noise.glsl: Perlin noise on an integer hash, and NoiseTime.
#include <tests/Spectrum.h>

#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>

#include <glm/gtc/noise.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

using namespace osgTreeWind;

namespace {

constexpr int periods = 20000, perPeriod = 16;

struct Statistics {
    double mean = 0.0, variance = 0.0, largest = 0.0, largestStep = 0.0;
};

template <typename Noise>
Statistics measure(Noise noise) {
    Statistics s;
    double squares = 0.0, previous = noise(0, 0.0f);
    for (int i = 0; i < periods * perPeriod; ++i) {
        const double n = noise(i / perPeriod, static_cast<float>(i % perPeriod) / perPeriod);
        s.mean += n;
        squares += n * n;
        s.largest = std::max(s.largest, std::abs(n));
        s.largestStep = std::max(s.largestStep, std::abs(n - previous));
        previous = n;
    }
    s.mean /= periods * perPeriod;
    s.variance = squares / (periods * perPeriod) - s.mean * s.mean;
    return s;
}

Statistics streamStatistics(std::uint32_t stream) {
    return measure([=](int cell, float fraction) {
        return Laws().streamNoise(stream, static_cast<std::uint32_t>(cell), fraction);
    });
}

} // namespace

TEST(Noise, HashIsLowbias32) {
    // Bijective mixer of C. Wellons: 0 is its fixed point, and 1 by hand with 32-bit arithmetic.
    EXPECT_EQ(Laws().scrambleBits(0u), 0u);
    std::uint64_t x = 1;
    x = ((x ^ (x >> 16)) * 0x7feb352dull) % 4294967296ull;
    x = ((x ^ (x >> 15)) * 0x846ca68bull) % 4294967296ull;
    EXPECT_EQ(Laws().scrambleBits(1u), x ^ (x >> 16));
}

TEST(Noise, IsBoundedAndUnbiased) {
    for (const std::uint32_t stream : {0u, 1u, 77u, 4000000000u}) {
        const Statistics s = streamStatistics(stream);
        EXPECT_LE(s.largest, 1.0);
        EXPECT_GT(s.largest, 0.7); // and uses the range
        EXPECT_NEAR(s.mean, 0.0, 0.01);
    }
}

TEST(Noise, MatchesGlmPerlin) {
    const Statistics ours = streamStatistics(5u);
    const Statistics theirs = measure([](int cell, float fraction) {
        return glm::perlin(
            glm::vec2(static_cast<float>(cell % 280) + fraction, static_cast<float>(cell / 280) + 0.37f));
    });
    EXPECT_NEAR(theirs.mean, 0.0, 0.02);
    EXPECT_GT(ours.variance, 0.5 * theirs.variance);
    EXPECT_LT(ours.variance, 2.0 * theirs.variance);
}

TEST(Noise, VarianceIsThatOfUniformGradients) {
    // 4 E[g^2] * integral of f^2 (1-w)^2 + (1-f)^2 w^2, with E[g^2] = 1/3 and w the quintic fade.
    double integral = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const double f = (i + 0.5) / 10000, w = f * f * f * (f * (f * 6 - 15) + 10);
        integral += (f * f * (1 - w) * (1 - w) + (1 - f) * (1 - f) * w * w) / 10000;
    }
    EXPECT_NEAR(streamStatistics(9u).variance, 4.0 / 3.0 * integral, 0.003);
}

TEST(Noise, IsContinuous) {
    // The slope of 2 * Perlin with gradients in [-1, 1] stays below 2 * (1 + 1.875).
    for (const std::uint32_t stream : {3u, 8u})
        EXPECT_LT(streamStatistics(stream).largestStep, 5.75 / perPeriod);
}

TEST(Noise, IsContinuousBetweenCells) {
    Laws laws;
    for (std::uint32_t stream = 0; stream < 200; ++stream)
        for (std::uint32_t cell : {0u, 4294967295u}) {
            EXPECT_NEAR(laws.streamNoise(stream, cell, 0.999999f), laws.streamNoise(stream, cell + 1u, 0.0f),
                        1e-4f);
            float previous = laws.streamNoise(stream, cell, 0.0f);
            for (int i = 1; i < 1000; ++i) {
                const float n = laws.streamNoise(stream, cell, static_cast<float>(i) / 1000.0f);
                ASSERT_LT(std::abs(n - previous), 0.006f) << "stream " << stream;
                previous = n;
            }
        }
}

TEST(Noise, StreamsDoNotPassThroughZeroTogether) {
    int zeros = 0;
    for (std::uint32_t stream = 0; stream < 1000; ++stream)
        zeros += std::abs(Laws().streamNoise(stream, 3u, 0.0f)) < 0.01f;
    EXPECT_LT(zeros, 60);
}

TEST(Noise, StreamsAreUncorrelated) {
    Laws laws;
    const std::uint32_t a = laws.noiseStream(1, 4, 0);
    const double scale = streamStatistics(a).variance;
    for (const std::uint32_t b :
         {laws.noiseStream(1, 4, 1), laws.noiseStream(1, 5, 0), laws.noiseStream(2, 4, 0)}) {
        double product = 0.0;
        for (int i = 0; i < 40000; ++i)
            product += laws.streamNoise(a, static_cast<std::uint32_t>(i), 0.5f) *
                       laws.streamNoise(b, static_cast<std::uint32_t>(i), 0.5f) / 40000.0;
        EXPECT_LT(std::abs(product) / scale, 0.03);
    }
}

TEST(Noise, NeighbouringTreesElementsAndAxesHaveDifferentStreams) {
    Laws laws;
    std::set<std::uint32_t> streams;
    for (std::uint32_t seed = 0; seed < 10; ++seed)
        for (std::uint32_t element = 0; element < 200; ++element)
            for (std::uint32_t axis = 0; axis < 5; ++axis)
                streams.insert(laws.noiseStream(seed, element, axis));
    EXPECT_GE(streams.size(), 9998u); // 10^4 draws of 2^32: a collision in 86 runs
}

namespace {

/// 1 Hz noise of the laws, sampled at 32 Hz.
std::vector<double> noiseSeries(std::optional<float> exponent, std::size_t count) {
    Laws laws;
    std::vector<double> series;
    for (std::size_t i = 0; i < count; ++i) {
        const NoiseTime now = NoiseTime::at(static_cast<double>(i) / 32.0, 1.0f, exponent);
        series.push_back(laws.motionNoise(laws.noiseStream(7u, 3u, 1u), now.cell, now.fraction, now.gain));
    }
    return series;
}

} // namespace

TEST(OctaveNoise, PowerFallsAsFrequencyToTheMinusBeta) {
    for (const float beta : {0.0f, 0.5f, 1.0f, 1.5f, 2.0f, 2.5f, 3.0f}) {
        const std::vector<double> power = powerSpectrum(noiseSeries(beta, 1u << 20), 1u << 13);
        EXPECT_NEAR(spectralSlope(power, 32.0 / (1 << 13), 0.1, 1.6, 32), -beta, 0.1);
    }
}

TEST(OctaveNoise, HasTheVarianceOfPerlinNoiseAndIsRarelyClamped) {
    const auto variance = [](const std::vector<double>& series) {
        double sum = 0;
        for (const double x : series)
            sum += x * x;
        return sum / static_cast<double>(series.size());
    };
    const double perlin = variance(noiseSeries({}, 1u << 18));
    for (const float beta : {0.0f, 1.0f, 2.0f, 3.0f}) {
        const std::vector<double> series = noiseSeries(beta, 1u << 18);
        EXPECT_NEAR(variance(series) / perlin, 1.0, 0.1) << beta;
        EXPECT_LT(std::count(series.begin(), series.end(), 1.0) +
                      std::count(series.begin(), series.end(), -1.0),
                  300)
            << beta;
        EXPECT_LE(*std::max_element(series.begin(), series.end()), 1.0);
        EXPECT_GE(*std::min_element(series.begin(), series.end()), -1.0);
    }
}

TEST(OctaveNoise, IsContinuousThroughZeroAndBetweenCells) {
    Laws laws;
    const auto at = [&](double time) {
        const NoiseTime now = NoiseTime::at(time, 1.0f, 1.0f);
        return laws.motionNoise(5u, now.cell, now.fraction, now.gain);
    };
    for (double time = -20.0; time < 20.0; time += 1e-3)
        ASSERT_LT(std::abs(at(time + 1e-3) - at(time)), 0.03f) << time;
}

TEST(OctaveNoise, WithoutAGainIsPerlinNoise) {
    EXPECT_EQ(Laws().motionNoise(9u, 4u, 0.3f, 0.0f), Laws().streamNoise(9u, 4u, 0.3f));
}

TEST(NoiseTime, ExponentsAreClamped) {
    EXPECT_EQ(NoiseTime::at(1.0, 1.0f, 9.0f).gain, NoiseTime::at(1.0, 1.0f, 3.0f).gain);
    EXPECT_EQ(NoiseTime::at(1.0, 1.0f, 1.0f).gain, 1.0f);
    EXPECT_EQ(NoiseTime::at(1.0, 1.0f).gain, 0.0f);
    EXPECT_FLOAT_EQ(NoiseTime::at(4.0, 1.0f, 1.0f).fraction, 0.5f); // the slowest octave has 8 s
}

TEST(NoiseTime, SplitsPeriods) {
    const NoiseTime t = NoiseTime::at(10.0, 0.25f);
    EXPECT_EQ(t.cell, 2u);
    EXPECT_FLOAT_EQ(t.fraction, 0.5f);
}

TEST(NoiseTime, KeepsItsPrecisionAfterAYear) {
    const double year = 31536000.0;
    const NoiseTime a = NoiseTime::at(year, 1.0f), b = NoiseTime::at(year + 1.0 / 64.0, 1.0f);
    EXPECT_EQ(a.cell, b.cell);
    EXPECT_NEAR(b.fraction - a.fraction, 0.015625f, 1e-6f);
}

TEST(NoiseTime, IsContinuousThroughZero) {
    const NoiseTime before = NoiseTime::at(-0.25, 1.0f);
    EXPECT_EQ(before.cell, 4294967295u);
    EXPECT_FLOAT_EQ(before.fraction, 0.75f);
}

TEST(NoiseTime, FractionStaysBelowOne) {
    for (const double time : {0.99999999999, -1e-12, 5.0 - 1e-15, 1e300, -1e300, 4294967296.0 - 1e-9})
        EXPECT_LT(NoiseTime::at(time, 1.0f).fraction, 1.0f) << time;
    EXPECT_EQ(NoiseTime::at(0.99999999999, 1.0f).cell, 1u);
    EXPECT_EQ(NoiseTime::at(-1e-12, 1.0f).cell, 0u);
}

TEST(NoiseTime, ValuesThatAreNotFiniteCountAsZero) {
    for (const double time : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        EXPECT_EQ(NoiseTime::at(time, 1.0f).cell, 0u);
        EXPECT_EQ(NoiseTime::at(time, 1.0f).fraction, 0.0f);
    }
}

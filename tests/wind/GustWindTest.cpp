// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GustWind.h>

#include <tests/Spectrum.h>
#include <tests/base/FirstProblem.h>
#include <tests/wind/Extremes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace osgTreeWind {

namespace {

GustWind::Parameters defaultGusts() {
    GustWind::Parameters parameters;
    parameters.mean = {6, 8, 0};
    parameters.intensity = 0.2;
    parameters.lengthScale = 40;
    return parameters;
}

std::shared_ptr<const GustWind> made(const GustWind::Parameters& parameters) {
    auto wind = GustWind::create(parameters);
    EXPECT_TRUE(wind) << firstProblem(wind);
    return wind.value();
}

/// Component along the mean (6, 8, 0) of 10 m/s.
double along(const glm::vec3& velocity) {
    return 0.6 * velocity.x + 0.8 * velocity.y;
}
double across(const glm::vec3& velocity) {
    return -0.8 * velocity.x + 0.6 * velocity.y;
}

/// Mean and standard deviation.
struct Moments {
    double sum = 0.0, squares = 0.0;
    int count = 0;

    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    double mean() const { return sum / count; }
    double deviation() const { return std::sqrt(squares / count - mean() * mean()); }
};

/// Time series of the component along the mean at one place.
std::vector<double> record(const GustWind& wind, const glm::vec3& position, int count, double step) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(along(wind.velocity(position, i * step)));
    return values;
}

/// Log-log slope of the spectral density between `low` and `high` Hz, averaged over seeds.
double spectralSlopeOfGusts(double low, double high) {
    constexpr int count = 8192;
    constexpr double step = 0.05;
    std::vector<double> power(count / 2, 0.0);
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        GustWind::Parameters parameters = defaultGusts();
        parameters.seed = seed;
        std::vector<double> values = record(*made(parameters), {13, -7, 5}, count, step);
        for (double& value : values)
            value -= 10.0;
        const std::vector<double> one = powerSpectrum(values, count);
        for (std::size_t i = 0; i < power.size(); ++i)
            power[i] += one[i];
    }
    return spectralSlope(power, 1.0 / (count * step), low, high, 24);
}

} // namespace

TEST(GustWind, HasTheRequestedMeanAndDeviations) {
    Moments u, v, w;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        GustWind::Parameters parameters = defaultGusts();
        parameters.seed = seed;
        const auto wind = made(parameters);
        for (int i = 0; i < 8000; ++i) {
            const glm::vec3 velocity = wind->velocity({i * 97.3f, i % 90 * 83.1f, 10.0f}, i % 70 * 61.7f);
            u.add(along(velocity));
            v.add(across(velocity));
            w.add(velocity.z);
        }
    }
    EXPECT_NEAR(u.mean(), 10.0, 0.03);
    EXPECT_NEAR(v.mean(), 0.0, 0.03);
    EXPECT_NEAR(w.mean(), 0.0, 0.03);
    EXPECT_NEAR(u.deviation(), 0.2 * 10.0, 0.02 * 2.0);
    EXPECT_NEAR(v.deviation(), 0.8 * 2.0, 0.02 * 2.0);
    EXPECT_NEAR(w.deviation(), 0.5 * 2.0, 0.02 * 2.0);
}

/// f L / U from 0.5 to 8: above the energetic scales, below the smallest octave.
TEST(GustWind, SpectrumFallsWithTheFiveThirdsPower) {
    EXPECT_NEAR(spectralSlopeOfGusts(0.125, 2.0), -5.0 / 3.0, 0.1);
}

TEST(GustWind, LengthScaleIsTheIntegralOfTheCorrelation) {
    std::vector<double> correlation(120, 0.0); // every 2 m along the wind
    double variance = 0.0;
    for (std::uint32_t seed = 1; seed <= 30; ++seed) {
        GustWind::Parameters parameters = defaultGusts();
        parameters.seed = seed;
        const std::vector<double> u = record(*made(parameters), {}, 6000, 0.2);
        for (std::size_t i = 0; i + correlation.size() < u.size(); ++i) {
            variance += (u[i] - 10) * (u[i] - 10);
            for (std::size_t lag = 0; lag < correlation.size(); ++lag)
                correlation[lag] += (u[i] - 10) * (u[i + lag] - 10);
        }
    }
    double scale = -0.5 * 2.0;
    for (double c : correlation)
        scale += 2.0 * c / variance;
    EXPECT_NEAR(scale, 40.0, 6.0);
}

TEST(GustWind, TurbulenceTravelsWithTheMeanWind) {
    const auto wind = made(defaultGusts());
    for (double dt : {0.1, 1.0, 17.0, 300.0})
        for (const glm::vec3 at : {glm::vec3(0), glm::vec3(31, -12, 7), glm::vec3(-200, 90, 2)}) {
            const glm::vec3 here = wind->velocity(at, 5.0);
            const glm::vec3 there =
                wind->velocity(at + glm::vec3(6, 8, 0) * static_cast<float>(dt), 5.0 + dt);
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(there[i], here[i], 0.002) << "after " << dt << " s";
        }
}

TEST(GustWind, DoesNotRepeatWithinAnHour) {
    const std::vector<double> u = record(*made(defaultGusts()), {}, 18000, 0.2);
    Moments moments;
    for (double value : u)
        moments.add(value);
    const double variance = moments.deviation() * moments.deviation();
    for (std::size_t lag = 150; lag < 12000; lag += 2) { // 30 s, ten length scales, to 40 min
        double sum = 0.0;
        const std::size_t count = u.size() - lag;
        for (std::size_t i = 0; i < count; i += 3)
            sum += (u[i] - moments.mean()) * (u[i + lag] - moments.mean());
        ASSERT_LT(sum / static_cast<double>(count / 3) / variance, 0.5)
            << "after " << 0.2 * static_cast<double>(lag) << " s";
    }
}

TEST(GustWind, DependsOnTheSeedOnly) {
    GustWind::Parameters other = defaultGusts();
    other.seed = 2;
    const auto a = made(defaultGusts()), b = made(defaultGusts()), c = made(other);
    int different = 0;
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 at(3 * i, 5 * i, i);
        EXPECT_EQ(a->velocity(at, i), b->velocity(at, i));
        different += a->velocity(at, i) != c->velocity(at, i);
    }
    EXPECT_EQ(different, 100);
}

TEST(GustWind, IsContinuous) {
    const auto wind = made(defaultGusts());
    glm::vec3 before = wind->velocity({}, 0);
    for (int i = 1; i < 20000; ++i) {
        const glm::vec3 now = wind->velocity({}, i * 0.001);
        ASSERT_LT(glm::length(now - before), 0.1f) << "jump at " << i * 0.001 << " s";
        before = now;
    }
}

/// Standard deviation along the wind over the mean.
double intensityAt(float height, const GustWind::Parameters& parameters) {
    Moments moments;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        GustWind::Parameters seeded = parameters;
        seeded.seed = seed;
        const auto wind = made(seeded);
        for (int i = 0; i < 4000; ++i)
            moments.add(along(wind->velocity({i * 97.3f, i % 90 * 83.1f, height}, i)));
    }
    return moments.deviation() / moments.mean();
}

TEST(GustWind, IntensityFallsWithHeightAsInTheEurocode) {
    GustWind::Parameters parameters = defaultGusts();
    parameters.profile = LogProfile{10.0, 0.05};
    parameters.intensity = 1.0 / std::log(10.0 / 0.05);
    for (const float height : {5.0f, 10.0f, 20.0f, 50.0f}) {
        const double published = 1.0 / std::log(static_cast<double>(height) / 0.05); // EN 1991-1-4, 4.7
        EXPECT_NEAR(intensityAt(height, parameters) / published, 1.0, 0.04) << height;
    }
    EXPECT_NEAR(intensityAt(0.5f, parameters) / intensityAt(2.0f, parameters), 1.0, 0.05);
    parameters.profile.reset(); // the terrain follows from the intensity at 10 m
    for (const float height : {5.0f, 10.0f, 20.0f, 50.0f}) {
        const double published = 1.0 / std::log(static_cast<double>(height) / 0.05);
        EXPECT_NEAR(intensityAt(height, parameters) / published, 1.0, 0.04) << height;
    }
}

TEST(GustWind, ProfileScalesTheMean) {
    GustWind::Parameters parameters = defaultGusts();
    parameters.profile = LogProfile{10.0, 0.1};
    EXPECT_EQ(made(parameters)->velocity({3, 4, 0.05f}, 7), glm::vec3(0.0f));
    const float factor = static_cast<float>(std::log(20.0 / 0.1) / std::log(10.0 / 0.1));
    const glm::vec3 mean = made(parameters)->withoutGusts()->velocity({3, 4, 20}, 7);
    EXPECT_LT(glm::length(mean - factor * parameters.mean), 1e-4f);
}

TEST(GustWind, FollowsTheTerrain) {
    GustWind::Parameters parameters = defaultGusts();
    parameters.profile = LogProfile{10.0, 0.1};
    const auto wind = made(parameters);
    for (float height : {0.05f, 2.0f, 20.0f})
        for (float ground : {200.0f, -50.0f}) {
            const glm::vec3 there = wind->velocity({{3, 4, ground + height}, ground}, 7);
            EXPECT_LT(glm::length(there - wind->velocity({3, 4, height}, 7)), 1e-3f)
                << height << " m above ground at " << ground;
        }
}

TEST(GustWind, ZeroIntensityIsTheMeanAndZeroMeanIsCalm) {
    GustWind::Parameters parameters = defaultGusts();
    parameters.intensity = 0.0;
    EXPECT_EQ(made(parameters)->velocity({1, 2, 3}, 4), glm::vec3(6, 8, 0));
    parameters = defaultGusts();
    parameters.mean = glm::vec3(0.0f);
    EXPECT_EQ(made(parameters)->velocity({1, 2, 3}, 4), glm::vec3(0.0f));
}

TEST(GustWind, IsFiniteForExtremePlacesAndTimes) {
    GustWind::Parameters parameters = defaultGusts();
    expectFiniteEverywhere(*made(parameters));
    parameters.lengthScale = 1.0;
    parameters.profile = LogProfile{10.0, 0.1};
    expectFiniteEverywhere(*made(parameters));
}

TEST(GustWind, RefusesInvalidParameters) {
    const auto problemOf = [](auto spoil) {
        GustWind::Parameters parameters = defaultGusts();
        spoil(parameters);
        return firstProblem(GustWind::create(parameters));
    };
    EXPECT_EQ(problemOf([](auto& p) { p.mean.z = 1; }), "mean: expected a horizontal wind, found 1");
    EXPECT_EQ(problemOf([](auto& p) { p.mean.x = 1e9f; }),
              "mean: expected at most 200 m/s, found 1000000000");
    EXPECT_EQ(problemOf([](auto& p) { p.mean.y = std::numeric_limits<float>::quiet_NaN(); }),
              "mean: expected at most 200 m/s, found nan");
    EXPECT_EQ(problemOf([](auto& p) { p.intensity = -0.1; }),
              "intensity: expected a finite number in [0, 1], found -0.1");
    EXPECT_EQ(problemOf([](auto& p) { p.lengthScale = 0; }),
              "length_scale: expected a finite number in [1, 100000], found 0");
    EXPECT_EQ(problemOf([](auto& p) {
                  p.profile = LogProfile{1, 2};
              }),
              "profile: expected 0 < roughness < height in metres");
}

} // namespace osgTreeWind

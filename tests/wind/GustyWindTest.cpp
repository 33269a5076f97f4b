// SPDX-License-Identifier: MIT
#include <tests/Spectrum.h>
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/Wind.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace osgTreeWind {

namespace {

/// A uniform wind with gusts.
struct Gusts {
    glm::vec3 mean{5.0f, 0.0f, 0.0f};
    double intensity = 0.2, lengthScale = 60.0;
    std::optional<LogProfile> profile;
    std::uint32_t seed = 1;
};

Gusts defaultGusts() {
    Gusts parameters;
    parameters.mean = {6, 8, 0};
    parameters.intensity = 0.2;
    parameters.lengthScale = 40;
    return parameters;
}

WindFieldPtr made(const Gusts& parameters) {
    Wind wind(std::make_shared<UniformWind>(parameters.mean, parameters.profile));
    wind.gusts = {parameters.intensity, parameters.lengthScale, parameters.seed};
    return asField(wind);
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
std::vector<double> record(const WindField& wind, const glm::vec3& position, int count, double step) {
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
        Gusts parameters = defaultGusts();
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

TEST(GustyWind, HasTheRequestedMeanAndDeviations) {
    Moments u, v, w;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Gusts parameters = defaultGusts();
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
TEST(GustyWind, SpectrumFallsWithTheFiveThirdsPower) {
    EXPECT_NEAR(spectralSlopeOfGusts(0.125, 2.0), -5.0 / 3.0, 0.1);
}

TEST(GustyWind, LengthScaleIsTheIntegralOfTheCorrelation) {
    std::vector<double> correlation(120, 0.0); // every 2 m along the wind
    double variance = 0.0;
    for (std::uint32_t seed = 1; seed <= 30; ++seed) {
        Gusts parameters = defaultGusts();
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

/// Coherence of the component along the wind between a place and others, in the default wind of 5 m/s and 60
/// m.
class CoherenceOfGusts {
public:
    /// Cycles per metre of bin i is i / (window * step).
    static constexpr std::size_t window = 512, count = 4096;
    static constexpr float step = 2.0f; // metres of travel

    explicit CoherenceOfGusts(const std::vector<glm::vec3>& others)
        : _powers(others.size() + 1, std::vector<double>(window / 2)),
          _crosses(others.size(), std::vector<std::complex<double>>(window / 2)) {
        std::vector<WindPlace> places = {WindPlace(glm::vec3(0.0f, 0.0f, 10.0f))};
        for (const glm::vec3& other : others)
            places.emplace_back(places[0].position + other);
        std::vector<glm::vec3> velocities(places.size());
        for (std::uint32_t seed = 1; seed <= 100; ++seed) {
            Gusts parameters;
            parameters.seed = seed;
            const auto wind = made(parameters);
            std::vector<std::vector<double>> records(places.size());
            for (std::size_t i = 0; i < count; ++i) {
                const double time = static_cast<double>(step * static_cast<float>(i) / parameters.mean.x);
                wind->sample(places.data(), places.size(), time, velocities.data());
                for (std::size_t n = 0; n < places.size(); ++n)
                    records[n].push_back(static_cast<double>(velocities[n].x - parameters.mean.x));
            }
            for (std::size_t n = 0; n < places.size(); ++n) {
                const auto power = powerSpectrum(records[n], window);
                for (std::size_t i = 0; i < power.size(); ++i)
                    _powers[n][i] += power[i];
            }
            for (std::size_t n = 0; n < others.size(); ++n) {
                const auto cross = crossSpectrum(records[n + 1], records[0], window);
                for (std::size_t i = 0; i < cross.size(); ++i)
                    _crosses[n][i] += cross[i];
            }
        }
    }

    static double wavenumber(std::size_t bin) { return static_cast<double>(bin) / (window * step); }
    double at(std::size_t other, std::size_t bin) const {
        return std::abs(_crosses[other][bin]) / std::sqrt(_powers[0][bin] * _powers[other + 1][bin]);
    }
    /// Least-squares fit of exp(-decay f d / U).
    double decay(std::size_t other, double distance) const {
        double best = 0.0, least = 1e9;
        for (double decay = 1.0; decay < 30.0; decay += 0.05) {
            double squares = 0.0;
            for (std::size_t i = 1; wavenumber(i) * distance < 0.6; ++i) {
                const double error = at(other, i) - std::exp(-decay * wavenumber(i) * distance);
                squares += error * error;
            }
            if (squares < least) {
                least = squares;
                best = decay;
            }
        }
        return best;
    }

private:
    std::vector<std::vector<double>> _powers;
    std::vector<std::vector<std::complex<double>>> _crosses;
};

/// Coherence across the wind in isotropic turbulence with the spectrum of von Karman (1948). @param
/// wavenumber cycles per metre.
double isotropicCoherence(double distance, double length, double wavenumber) {
    const double x = distance * std::hypot(0.7468 / length, 6.283185307179586 * wavenumber);
    return std::pow(2.0, 1.0 / 6.0) / std::tgamma(5.0 / 6.0) *
           (std::pow(x, 5.0 / 6.0) * std::cyl_bessel_k(5.0 / 6.0, x) -
            0.5 * std::pow(x, 11.0 / 6.0) * std::cyl_bessel_k(1.0 / 6.0, x));
}

TEST(GustyWind, CoherenceAcrossAndUpwardDecaysAsPublished) {
    const double distances[] = {5.0, 10.0, 20.0, 50.0};
    std::vector<glm::vec3> others;
    for (const double distance : distances) {
        others.emplace_back(0.0f, distance, 0.0f);
        others.emplace_back(0.0f, 0.0f, distance);
    }
    const CoherenceOfGusts coherence(others);
    for (std::size_t n = 0; n < others.size(); ++n) {
        const double distance = distances[n / 2];
        EXPECT_NEAR(coherence.decay(n, distance) / 8.8, 1.0, 0.15) << distance << " m, IEC 61400-1:1999";
        const double slow = CoherenceOfGusts::wavenumber(1);
        EXPECT_NEAR(coherence.at(n, 1) / isotropicCoherence(distance, 60.0, slow), 1.0, 0.15) << distance;
    }
}

/// The squared coherence is exp(-a hypot(f d / U, b d)), with a = 8.4 s / U + 0.05, b = 0.25 / L^1.24 and s
/// the deviation of the velocity vector (Simley and Pao 2015).
TEST(GustyWind, ChangesOnItsWayAsPublished) {
    const double a = 8.4 * 0.2 * std::sqrt(1.0 + 0.8 * 0.8 + 0.5 * 0.5) + 0.05;
    const double b = 0.25 * std::pow(60.0, -1.24);
    const double distances[] = {20.0, 50.0, 100.0};
    const CoherenceOfGusts coherence({{20.0f, 0.0f, 0.0f}, {50.0f, 0.0f, 0.0f}, {100.0f, 0.0f, 0.0f}});
    for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t i = 1; i < 40; ++i) {
            const double wavenumber = CoherenceOfGusts::wavenumber(i);
            const double published = std::exp(-0.5 * a * distances[n] * std::hypot(wavenumber, b));
            if (published < 0.4)
                break;
            EXPECT_NEAR(coherence.at(n, i) / published, 1.0, 0.15) << distances[n] << ' ' << wavenumber;
        }
}

/// Correlation of the component along the wind between now and later, in the default wind.
double correlationAfter(double travel) {
    double product = 0.0, squares = 0.0;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Gusts parameters;
        parameters.seed = seed;
        const auto wind = made(parameters);
        for (int i = 0; i < 2000; ++i) {
            const WindPlace here(0.0f, 313.0f * static_cast<float>(i % 50), 10.0f);
            const WindPlace there(static_cast<float>(travel), here.position.y, 10.0f);
            const double time = 31.0 * (i / 50);
            const double now = static_cast<double>(wind->velocity(here, time).x - 5.0f);
            const double later = static_cast<double>(wind->velocity(there, time + travel / 5.0).x - 5.0f);
            product += now * later;
            squares += 0.5 * (now * now + later * later);
        }
    }
    return product / squares;
}

TEST(GustyWind, TravelsWithTheMeanWindForAWhile) {
    EXPECT_GT(correlationAfter(5.0), 0.95);
    const double after100 = correlationAfter(100.0);
    EXPECT_GT(after100, 0.3);
    EXPECT_LT(after100, 0.7);
    EXPECT_LT(correlationAfter(1000.0), 0.1);
}

TEST(GustyWind, DoesNotRepeatWithinAnHour) {
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

TEST(GustyWind, DependsOnTheSeedOnly) {
    Gusts other = defaultGusts();
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

TEST(GustyWind, IsContinuous) {
    const auto wind = made(defaultGusts());
    glm::vec3 before = wind->velocity({}, 0);
    for (int i = 1; i < 20000; ++i) {
        const glm::vec3 now = wind->velocity({}, i * 0.001);
        ASSERT_LT(glm::length(now - before), 0.1f) << "jump at " << i * 0.001 << " s";
        before = now;
    }
}

/// Standard deviation along the wind over the mean.
double intensityAt(float height, const Gusts& parameters) {
    Moments moments;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        Gusts seeded = parameters;
        seeded.seed = seed;
        const auto wind = made(seeded);
        for (int i = 0; i < 4000; ++i)
            moments.add(along(wind->velocity({i * 97.3f, i % 90 * 83.1f, height}, i)));
    }
    return moments.deviation() / moments.mean();
}

TEST(GustyWind, IntensityFallsWithHeightAsInTheEurocode) {
    Gusts parameters = defaultGusts();
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

TEST(GustyWind, FollowsTheTerrain) {
    Gusts parameters = defaultGusts();
    parameters.profile = LogProfile{10.0, 0.1};
    const auto wind = made(parameters);
    for (float height : {0.05f, 2.0f, 20.0f})
        for (float ground : {200.0f, -50.0f}) {
            const glm::vec3 there = wind->velocity({{3, 4, ground + height}, ground}, 7);
            EXPECT_LT(glm::length(there - wind->velocity({3, 4, height}, 7)), 1e-3f)
                << height << " m above ground at " << ground;
        }
}

TEST(GustyWind, ZeroIntensityIsTheMeanAndZeroMeanIsCalm) {
    Gusts parameters = defaultGusts();
    parameters.intensity = 0.0;
    EXPECT_EQ(made(parameters)->velocity({1, 2, 3}, 4), glm::vec3(6, 8, 0));
    parameters = defaultGusts();
    parameters.mean = glm::vec3(0.0f);
    EXPECT_EQ(made(parameters)->velocity({1, 2, 3}, 4), glm::vec3(0.0f));
}

TEST(GustyWind, IsFiniteForExtremePlacesAndTimes) {
    Gusts parameters = defaultGusts();
    expectFiniteEverywhere(*made(parameters));
    parameters.lengthScale = 1.0;
    parameters.profile = LogProfile{10.0, 0.1};
    expectFiniteEverywhere(*made(parameters));
}

} // namespace osgTreeWind

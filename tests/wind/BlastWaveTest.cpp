// SPDX-License-Identifier: MIT
#include <tests/wind/Winds.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/BlastWave.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

/// Drag impulse per drag area and density of a wind sampled every `step` seconds.
double sampledImpulse(const BlastWave& blast, double distance, double step, double phase) {
    double sum = 0.0;
    for (double time = phase * step; time < 6.0; time += step) {
        const double wind = blast.wind(distance, time);
        sum += wind * std::abs(wind) * step;
    }
    return sum;
}

/// The same of the Friedlander wave itself.
double blastImpulse(const BlastWave& blast, double distance) {
    const BlastWave::Front front = blast.front(distance);
    double sum = 0.0;
    for (double s = 0.0005; s < 12.0; s += 0.001) {
        const double wind = front.wind * (1.0 - s) * std::exp(-s);
        sum += wind * std::abs(wind) * 0.001 * front.duration;
    }
    return sum;
}

WindSource tonneAtTwoSeconds() {
    WindSource source;
    source.kind = WindSource::Kind::Explosion;
    source.charge = 1000.0;
    source.time = 2.0;
    return source;
}

/// Maximum lean of a birch 40 m from a tonne of TNT.
float maxLean(double step, double phase, ModalLevel level) {
    ForestDescription forest;
    forest.species = {*findSpecies("silver birch")};
    forest.trees.resize(1);
    forest.trees[0].position = {40.0, 0.0, 0.0};
    forest.trees[0].size.height = 15.0f;
    forest.wind.sources = {tonneAtTwoSeconds()};
    SimulationOptions options;
    options.distant = level == ModalLevel::Far;
    ForestSimulation simulation(forest, options);
    float farthest = 0.0f;
    for (double time = phase * step; time < 6.0; time += step) {
        simulation.advance(time);
        farthest = std::max(farthest, glm::length(movingForest(simulation).modal()->lean(0)));
    }
    return farthest;
}

} // namespace

/// Glasstone and Dolan 1977, table 3.07: peak overpressures and winds behind them.
TEST(BlastWave, WindBehindTheFrontMatchesTables) {
    const BlastWave blast(1000.0);
    constexpr double psi = 6894.76, milesAnHour = 0.44704;
    const double table[][2] = {{50, 934}, {20, 502}, {10, 294}, {5, 163}, {2, 70}};
    for (const auto& [pressure, speed] : table) {
        double near = 1.0, far = 1000.0; // metres
        for (int i = 0; i < 60; ++i)
            (blast.front(0.5 * (near + far)).overpressure > pressure * psi ? near : far) = 0.5 * (near + far);
        EXPECT_NEAR(blast.front(near).wind, speed * milesAnHour, 0.02 * speed * milesAnHour) << pressure;
    }
}

/// NATO AASTP-1: overpressures of charges on the ground by scaled distance, m/kg^(1/3).
TEST(BlastWave, OverpressuresMatchSafetyDistances) {
    const double table[][2] = {{22.2, 5e3}, {14.8, 9e3}, {8.0, 21e3}, {3.6, 70e3}};
    for (const auto& [distance, pressure] : table)
        for (const double charge : {1.0, 1000.0, 1e6}) {
            const double found = BlastWave(charge).front(distance * std::cbrt(charge)).overpressure;
            EXPECT_NEAR(found / pressure, 1.0, 0.25) << distance;
        }
}

TEST(BlastWave, FrontSlowsDownToTheSpeedOfSound) {
    const BlastWave blast(100.0);
    const double near = blast.front(11.0).arrival - blast.front(10.0).arrival,
                 far = blast.front(20001.0).arrival - blast.front(20000.0).arrival;
    EXPECT_LT(near, 0.8 / 340.3);
    EXPECT_NEAR(far, 1.0 / 340.3, 0.001 / 340.3);
    for (double distance = 1.0; distance < 1e5; distance *= 1.1) {
        const BlastWave::Front here = blast.front(distance), farther = blast.front(1.1 * distance);
        EXPECT_GT(here.wind, farther.wind) << distance;
        EXPECT_LT(here.arrival, farther.arrival) << distance;
    }
}

TEST(BlastWave, ImpulseDoesNotDependOnTheSamplingTimes) {
    for (const double charge : {1.0, 100.0, 1e4, 1e6}) { // durations of 4 to 400 ms
        const BlastWave blast(charge);
        const double distance = 8.0 * std::cbrt(charge), whole = blastImpulse(blast, distance);
        ASSERT_GT(whole, 0.0);
        for (const double step : {0.001, 1.0 / 60.0, 0.1, 0.2})
            for (const double phase : {0.0, 0.3, 0.77})
                EXPECT_NEAR(sampledImpulse(blast, distance, step, phase), whole, 0.02 * whole)
                    << charge << " kg, every " << step << " s";
    }
}

TEST(BlastWave, LongBlastIsNotAveraged) {
    const BlastWave blast(1e9); // a megatonne lasts for seconds
    const BlastWave::Front front = blast.front(8000.0);
    ASSERT_GT(front.duration, 2.0);
    for (const double s : {0.2, 0.5, 1.5, 2.5})
        EXPECT_NEAR(blast.wind(8000.0, front.arrival + s * front.duration + 0.1),
                    front.wind * (1.0 - s) * std::exp(-s), 0.02 * front.wind);
}

TEST(BlastWave, ArrivesReversesAndEnds) {
    const WindSource source = tonneAtTwoSeconds();
    const LayeredWind wind = withSources(nullptr, {source});
    const auto at = [&](const glm::vec3& place, double time) {
        return wind.velocity(WindPlace(place), time);
    };
    const double arrival = 2.0 + BlastWave(1000.0).front(50.0).arrival;
    EXPECT_EQ(glm::length(at({30.0f, 40.0f, 0.0f}, arrival - 1e-3)), 0.0f);
    const glm::vec3 out = at({30.0f, 40.0f, 0.0f}, arrival + 0.15);
    EXPECT_GT(out.x, 1.0f);
    EXPECT_NEAR(out.y / out.x, 4.0f / 3.0f, 1e-4f) << "away from the explosion";
    EXPECT_NEAR(glm::length(at({-50.0f, 0.0f, 0.0f}, arrival + 0.15)), glm::length(out), 1e-3f);
    EXPECT_LT(at({30.0f, 40.0f, 0.0f}, arrival + 0.23).x, 0.0f) << "reversed";
    EXPECT_LT(glm::length(at({30.0f, 40.0f, 0.0f}, arrival + 2.0)), 1e-3f);
}

TEST(BlastWave, IsFiniteAndBounded) {
    constexpr double inf = std::numeric_limits<double>::infinity(),
                     nan = std::numeric_limits<double>::quiet_NaN();
    for (const double charge : {1e-300, 1.0, 1e9, inf, nan}) {
        WindSource source = tonneAtTwoSeconds();
        source.charge = charge;
        const LayeredWind wind = withSources(nullptr, {source});
        for (const float x : {0.0f, 1e-6f, 0.1f, 1e3f, 1e9f, std::nanf("")})
            for (const double time : {-inf, 0.0, 2.0, 2.0 + 1e-9, 2.5, 1e12, inf, nan}) {
                const float speed = glm::length(wind.velocity(WindPlace(glm::vec3(x, 0.0f, 0.0f)), time));
                EXPECT_TRUE(speed <= 200.1f) << charge << ' ' << x << ' ' << time;
            }
    }
}

TEST(BlastWave, LeanOfATreeDoesNotDependOnTheFrameRate) {
    const float usual = maxLean(1.0 / 60.0, 0.0, ModalLevel::Near);
    EXPECT_GT(usual, 0.0f);
    for (const double phase : {0.0, 0.5})
        for (const double step : {1.0 / 1000.0, 1.0 / 144.0, 1.0 / 30.0})
            EXPECT_NEAR(maxLean(step, phase, ModalLevel::Near), usual, 0.08f * usual) << step;
    EXPECT_NEAR(maxLean(1.0 / 60.0, 0.0, ModalLevel::Far), usual, 0.25f * usual);
}

} // namespace osgTreeWind

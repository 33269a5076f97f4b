// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace osgTreeWind;

namespace {

using Limits = std::numeric_limits<float>;

glm::vec3 angles(float speed, double time, int leaf = 5, const LeafMotion& motion = {}, float own = 0.3f,
                 float gust = 1.0f) {
    Laws laws;
    return laws.leafFlutter(speed, gust, flutterPhases(time, motion), own, static_cast<float>(leaf),
                            flutterLimits(motion));
}

float largest(const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Mean square of all angles of a leaf over 400 s.
double meanSquare(float speed) {
    double sum = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 a = angles(speed, 0.1 * i);
        sum += static_cast<double>(a.x * a.x + a.y * a.y + a.z * a.z);
    }
    return sum / 4000.0;
}

/// Rms speed of the leaves on a card of 0.4 by 0.4 m, from their own motion alone, m/s.
float leafSpeed(float speed, const LeafMotion& motion) {
    Laws laws;
    const glm::vec2 tremble = leafTremble(motion);
    const auto place = [&](double time, int leaf, const glm::vec3& corner) {
        const glm::vec3 phases = flutterPhases(time, motion), turn = angles(speed, time, leaf, motion);
        return laws.turnVector(laws.leafRotation(turn.x, turn.y, turn.z), corner) +
               tremble.x * laws.trembleShare(speed, tremble.y) *
                   laws.trembleWave(corner, phases, 0.3f, static_cast<float>(leaf));
    };
    const auto onCard = [&](double time, int leaf, float u, float v) {
        const auto edge = [&](float z) {
            return glm::mix(place(time, leaf, {-0.2f, 0.0f, z}), place(time, leaf, {0.2f, 0.0f, z}), u);
        };
        return glm::mix(edge(0.0f), edge(0.4f), v);
    };
    constexpr double step = 0.01;
    double sum = 0.0;
    constexpr int samples = 20000;
    for (int i = 0; i < samples; ++i) {
        const auto part = [i](double ratio) { return static_cast<float>(ratio * i - std::floor(ratio * i)); };
        const glm::vec3 moved = onCard(0.37 * i + step, i % 50, part(0.618), part(0.755)) -
                                onCard(0.37 * i, i % 50, part(0.618), part(0.755));
        sum += static_cast<double>(glm::dot(moved, moved));
    }
    return static_cast<float>(std::sqrt(sum / samples) / step);
}

} // namespace

TEST(StatelessFlutter, CalmIsStill) {
    for (int leaf = 0; leaf < 50; ++leaf)
        EXPECT_EQ(largest(angles(0.0f, 3.7 * leaf, leaf)), 0.0f);
}

TEST(StatelessFlutter, StaysBoundedInAnyWind) {
    const glm::vec2 aspen = leafTremble(findSpecies("aspen")->leaf);
    for (const float speed : {90.0f, 1e30f, Limits::infinity()}) {
        EXPECT_LE(Laws().flutterAmplitude(speed), 1.0f);
        EXPECT_GT(Laws().trembleShare(speed, aspen.y), 0.1f);
        EXPECT_LT(Laws().trembleShare(speed, aspen.y), 0.15f);
    }
    EXPECT_EQ(Laws().trembleShare(0.0f, aspen.y), 0.0f);
}

// Goldshmid, Dabiri and Sader, arXiv 2504.10584: U = 740 sqrt(nu u / D), in low to moderate winds.
TEST(StatelessFlutter, LeafSpeedsMatchMeasurements) {
    for (const char* name : {"oak", "silver birch", "beech", "Norway maple", "linden"})
        for (const float speed : {1.0f, 2.0f, 3.0f, 4.0f, 5.0f}) {
            const LeafMotion motion = findSpecies(name)->leaf;
            const float measured = motion.size * speed * speed / (740.0f * 740.0f * 1.5e-5f);
            EXPECT_NEAR(leafSpeed(speed, motion) / measured, 1.0f, 0.25f) << name << " " << speed;
        }
}

TEST(StatelessFlutter, AspensTrembleInWindsTooWeakForOtherSpecies) {
    EXPECT_GT(leafSpeed(2.0f, findSpecies("aspen")->leaf), 4.0f * leafSpeed(2.0f, findSpecies("oak")->leaf));
}

TEST(StatelessFlutter, GrowsInABreezeAndShrinksInAGale) {
    double before = 0.0;
    for (const float speed : {0.5f, 1.6f, 3.4f, 5.5f, 10.0f, 25.0f}) {
        const double now = meanSquare(speed);
        EXPECT_GT(now, before) << speed;
        before = now;
    }
    for (const float speed : {40.0f, 60.0f}) {
        const double now = meanSquare(speed);
        EXPECT_LT(now, before) << speed;
        before = now;
    }
    EXPECT_GT(before, 0.05 * meanSquare(5.5f));
}

TEST(StatelessFlutter, LeavesRollInGusts) {
    for (int leaf = 0; leaf < 20; ++leaf) {
        const glm::vec3 lull = angles(12.0f, 3.0, leaf, {}, 0.3f, 0.7f),
                        gust = angles(12.0f, 3.0, leaf, {}, 0.3f, 1.3f);
        EXPECT_GT(gust.z, lull.z + 0.2f) << leaf;
        EXPECT_EQ(gust.x, lull.x);
        EXPECT_EQ(angles(0.0f, 3.0, leaf, {}, 0.3f, 1.4f), glm::vec3(0.0f));
    }
}

TEST(StatelessFlutter, GustsTurnSomeLeavesOver) {
    Laws laws;
    EXPECT_EQ(laws.turnedOver(0.0f, 1.4f), 0.0f);
    EXPECT_EQ(laws.turnedOver(12.0f, 0.7f), 0.0f);
    EXPECT_GT(laws.turnedOver(12.0f, 1.3f), 0.3f);
    EXPECT_GT(laws.turnedOver(20.0f, 1.0f), laws.turnedOver(10.0f, 1.0f) + 0.2f);
    EXPECT_LE(laws.turnedOver(200.0f, 1.45f), 1.0f);
}

TEST(StatelessFlutter, IsFasterForItsAmplitudeInAGale) {
    const auto pace = [](float speed) {
        double moved = 0.0;
        for (int i = 0; i < 4000; ++i)
            moved += static_cast<double>(glm::length(angles(speed, 0.1 * i + 0.01) - angles(speed, 0.1 * i)));
        return moved / std::sqrt(meanSquare(speed));
    };
    EXPECT_GT(pace(25.0f), 1.2 * pace(4.0f));
}

TEST(StatelessFlutter, StaysWithinTheLimitsOfTheSpecies) {
    LeafMotion motion;
    motion.maxAngleX = 0.4f;
    motion.maxAngleZ = 0.1f;
    motion.maxRotation = 0.2f;
    motion.factor = 0.5f;
    glm::vec3 most(0.0f);
    for (int i = 0; i < 40000; ++i)
        most = glm::max(most, glm::abs(angles(0.5f * static_cast<float>(i % 60), 0.07 * i, i % 97, motion)));
    EXPECT_LE(most.x, 0.2f);
    EXPECT_LE(most.y, 0.05f);
    EXPECT_LE(most.z, 0.2f);
    EXPECT_GT(most.x, 0.07f); // and uses a large part of them
    EXPECT_GT(most.y, 0.017f);
    EXPECT_GT(most.z, 0.13f);
}

TEST(StatelessFlutter, StaysWithinLimitsForAnyInput) {
    constexpr std::array<float, 9> hostile = {0.0f,
                                              -5.0f,
                                              0.4f,
                                              1e30f,
                                              -1e30f,
                                              Limits::max(),
                                              Limits::infinity(),
                                              -Limits::infinity(),
                                              Limits::quiet_NaN()};
    for (const float a : hostile)
        for (const float b : hostile)
            for (const float c : hostile)
                for (const float d : hostile) {
                    LeafMotion motion;
                    motion.maxAngleX = a;
                    motion.maxAngleZ = b;
                    motion.maxRotation = c;
                    motion.factor = motion.linkedFactor = motion.noiseFrequency = d;
                    const glm::vec3 v = angles(b, static_cast<double>(c), 3, motion, d);
                    ASSERT_LE(std::abs(v.x), 1.5708f);
                    ASSERT_LE(std::abs(v.y), 1.5708f);
                    ASSERT_LE(std::abs(v.z), 10.0f);
                }
}

TEST(StatelessFlutter, IsContinuousInTime) {
    for (int i = 0; i < 100000; ++i) // waves of up to 8.4 Hz, of at most 0.05 rad, move at most 4.7 rad/s
        ASSERT_LT(largest(angles(20.0f, 0.001 * i, i / 1000) - angles(20.0f, 0.001 * (i + 1), i / 1000)),
                  0.012f)
            << i;
}

TEST(StatelessFlutter, MeanIsNearZero) {
    for (int leaf = 0; leaf < 20; ++leaf) {
        glm::dvec3 sum(0.0);
        for (int i = 0; i < 20000; ++i)
            sum += glm::dvec3(angles(20.0f, 0.1 * i, leaf));
        EXPECT_LT(largest(glm::vec3(sum / 20000.0)), 0.004f) << leaf;
    }
}

TEST(StatelessFlutter, LeavesAndTreesAreNotInPhase) {
    for (int i = 0; i < 20; ++i) {
        double products = 0.0, squares = 0.0;
        for (int k = 0; k < 20000; ++k) {
            const float one = angles(20.0f, 0.1 * k, i).x;
            const float other =
                i % 2 ? angles(20.0f, 0.1 * k, i + 1).x : angles(20.0f, 0.1 * k, i, {}, 0.8f).x;
            products += static_cast<double>(one * other);
            squares += static_cast<double>(one * one);
        }
        EXPECT_LT(products / squares, 0.9) << i;
    }
}

TEST(StatelessFlutter, IsExactAfterThirtyDays) {
    const LeafMotion motion;
    const double month = 30.0 * 86400.0;
    for (int i = 0; i < 1000; ++i) {
        const double time = month + 0.013 * i;
        const glm::vec3 phases = flutterPhases(time, motion);
        const long double periods =
            static_cast<long double>(time) * static_cast<long double>(motion.noiseFrequency);
        EXPECT_NEAR(static_cast<double>(phases.y), static_cast<double>(periods - std::floor(periods)), 1e-6);
        ASSERT_LT(largest(angles(20.0f, time) - angles(20.0f, time + 0.001)), 0.012f);
    }
}

TEST(StatelessFlutter, ATreesLeavesFollowTheWindOfTheirUnits) {
    std::vector<LeafCluster> leaves(4);
    for (int i = 0; i < 4; ++i)
        leaves[static_cast<std::size_t>(i)].unit = i / 2;
    const std::vector<glm::vec3> winds = {{0.0f, 0.0f, 0.0f}, {0.0f, -6.0f, 8.0f}};
    const std::vector<glm::vec4> pulls = {{0.0f, 0.0f, 0.0f, 1.0f}, {0.1f, 0.5f, 0.2f, 0.9f}};
    std::vector<glm::vec4> result(4, glm::vec4(9.0f));
    StatelessFlutter flutter;
    flutter.leaves = {leaves.data(), leaves.size()};
    flutter.winds = {winds.data(), winds.size()};
    flutter.pulls = {pulls.data(), pulls.size()};
    flutter.phases = flutterPhases(12.3, {});
    flutter.limits = flutterLimits({});
    flutter.own = 0.3f;
    flutter.run(result.data());
    EXPECT_EQ(glm::vec3(result[0]), glm::vec3(0.0f));
    EXPECT_EQ(glm::vec3(result[1]), glm::vec3(0.0f));
    for (int i = 2; i < 4; ++i)
        EXPECT_EQ(glm::vec3(result[static_cast<std::size_t>(i)]),
                  angles(10.0f, 12.3, i, {}, 0.3f, result[static_cast<std::size_t>(i)].w));
    EXPECT_NE(result[2].w, result[3].w);
}

TEST(StatelessFlutter, RandomNumbersOfTreesAreUniform) {
    int low = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        const float own = treeRandom(seed);
        ASSERT_GE(own, 0.0f);
        ASSERT_LT(own, 1.0f);
        low += own < 0.5f;
    }
    EXPECT_NEAR(low, 500, 60);
}

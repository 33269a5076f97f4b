// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/Numeric.h>
#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/model/ThesisFrame.h>

#include <gtest/gtest.h>

#include <limits>

namespace osgTreeWind {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const float nan = std::nanf("");

TEST(Numeric, InRangeKeepsWhatIsInsideAndStopsAtTheEnds) {
    EXPECT_EQ(inRange(0.5f, 0.0f, 1.0f, 7.0f), 0.5f);
    EXPECT_EQ(inRange(-3.0f, 0.0f, 1.0f, 7.0f), 0.0f);
    EXPECT_EQ(inRange(infinity, 0.0f, 1.0f, 7.0f), 1.0f);
    EXPECT_EQ(inRange(-infinity, 0.0f, 1.0f, 7.0f), 0.0f);
}

TEST(Numeric, InRangeReplacesNaN) {
    EXPECT_EQ(inRange(nan, 0.0f, 1.0f, 0.25f), 0.25f);
}

TEST(Numeric, DirectionOfNothingIsTheFallback) {
    EXPECT_EQ(directionOr({0, 0, 0}, {0, 1, 0}), glm::vec3(0, 1, 0));
    EXPECT_EQ(directionOr({0, 0, -3}, {0, 1, 0}), glm::vec3(0, 0, -1));
}

TEST(Numeric, PerpendicularIsAUnitVectorAcrossAnyAxis) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        glm::vec3 axis{random.symmetric(), random.symmetric(), random.symmetric()};
        if (i < 3)
            axis = glm::vec3(i == 0, i == 1, i == 2);
        axis = glm::normalize(axis);
        const glm::vec3 across = perpendicular(axis);
        EXPECT_NEAR(glm::dot(across, axis), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(across), 1.0f, 1e-6f);
    }
}

// The first outputs of SplitMix64 for the seed 1234567, as published with the generator.
TEST(Random, GivesThePublishedSequence) {
    Random random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317ull);
    EXPECT_EQ(random.next(), 3203168211198807973ull);
    EXPECT_EQ(random.next(), 9817491932198370423ull);
}

TEST(Random, UniformFillsItsRange) {
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

// Design section 4: thesis Y-up (x, y, z) is OSG (x, -z, y).
TEST(ThesisFrame, UpIsUpAndHandednessIsKept) {
    EXPECT_EQ(fromThesis({1, 2, 3}), glm::vec3(1, -3, 2));
    EXPECT_EQ(fromThesis({0, 1, 0}), glm::vec3(0, 0, 1));
    EXPECT_EQ(glm::cross(fromThesis({1, 0, 0}), fromThesis({0, 1, 0})), fromThesis({0, 0, 1}));
}

TEST(ThesisFrame, ThereAndBackIsTheSame) {
    EXPECT_EQ(toThesis(fromThesis({1, 2, 3})), glm::vec3(1, 2, 3));
}

} // namespace
} // namespace osgTreeWind

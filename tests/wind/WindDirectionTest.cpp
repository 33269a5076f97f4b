// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindDirection.h>

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

using namespace osgTreeWind;

namespace {

struct Case {
    double from;
    glm::vec3 velocity; ///< At 10 m/s.
};

const float diagonal = 10.0f * std::sqrt(0.5f);

const Case compass[] = {
    {0, {0, -10, 0}},   {45, {-diagonal, -diagonal, 0}},
    {90, {-10, 0, 0}},  {135, {-diagonal, diagonal, 0}},
    {180, {0, 10, 0}},  {225, {diagonal, diagonal, 0}},
    {270, {10, 0, 0}},  {315, {diagonal, -diagonal, 0}},
    {360, {0, -10, 0}}, {-90, {10, 0, 0}},
    {630, {10, 0, 0}},
};

void expectHorizontal(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_NEAR(actual.x, expected.x, 1e-5f);
    EXPECT_NEAR(actual.y, expected.y, 1e-5f);
    EXPECT_EQ(actual.z, 0.0f);
}

} // namespace

TEST(WindDirection, FromIsWhereTheWindComesFrom) {
    for (const Case& c : compass) {
        SCOPED_TRACE(c.from);
        expectHorizontal(windVelocity({10.0, glm::radians(c.from)}, DirectionSense::From), c.velocity);
    }
}

TEST(WindDirection, TowardIsTheOppositeOfFrom) {
    for (const Case& c : compass) {
        SCOPED_TRACE(c.from);
        expectHorizontal(windVelocity({10.0, glm::radians(c.from)}, DirectionSense::Toward), -c.velocity);
    }
}

TEST(WindDirection, ReadingsLieWithinOneTurn) {
    for (const Case& c : compass) {
        SCOPED_TRACE(c.from);
        const WindReading from = windReading(c.velocity, DirectionSense::From);
        EXPECT_NEAR(from.speed, 10.0, 1e-5);
        EXPECT_NEAR(glm::degrees(from.direction), std::fmod(c.from + 360.0, 360.0), 1e-4);
        const WindReading toward = windReading(c.velocity, DirectionSense::Toward);
        EXPECT_NEAR(glm::degrees(toward.direction), std::fmod(c.from + 540.0, 360.0), 1e-4);
    }
}

TEST(WindDirection, DirectionOfACalmIsZero) {
    const WindReading calm = windReading({0, 0, 3}, DirectionSense::From);
    EXPECT_EQ(calm.speed, 0.0);
    EXPECT_EQ(calm.direction, 0.0);
}

TEST(WindDirection, AlmostNorthDoesNotRoundUpToAFullTurn) {
    const WindReading reading = windReading({-1e-30f, 1.0f, 0.0f}, DirectionSense::Toward);
    EXPECT_GE(reading.direction, 0.0);
    EXPECT_LT(reading.direction, glm::two_pi<double>());
}

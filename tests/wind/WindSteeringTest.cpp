// SPDX-License-Identifier: MIT
#include <tests/wind/Winds.h>

#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindSteering.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

TEST(WindSteering, KeepsUnsteeredParametersOfGusts) {
    Wind given(std::make_shared<UniformWind>(glm::vec3(0.0f, -6.0f, 0.0f), LogProfile{12.0, 0.2}));
    given.gusts = {0.3, 44.0, 9};
    WindSteering steering = steeringOf(given); // from the north
    EXPECT_NEAR(steering.speed, 6.0, 1e-6);
    EXPECT_NEAR(steering.from, 0.0, 1e-6);
    EXPECT_EQ(steering.gustiness, 0.3);
    steering.strengthen(2.0);
    steering.turnClockwise(-90.0);
    steering.changeGustiness(-0.1);
    const Wind now = steered(given, steering);
    const auto wind = std::dynamic_pointer_cast<const UniformWind>(now.field);
    ASSERT_TRUE(wind);
    EXPECT_LT(glm::length(wind->velocity() - glm::vec3(8.0f, 0.0f, 0.0f)), 1e-5f) << "from the west";
    EXPECT_NEAR(now.gusts.intensity, 0.2, 1e-12);
    EXPECT_EQ(now.gusts.lengthScale, 44.0);
    EXPECT_EQ(wind->profile()->roughness, 0.2);
    EXPECT_EQ(now.gusts.seed, 9u);
}

TEST(WindSteering, StartsAndStopsAWind) {
    WindSteering steering = steeringOf(nullptr);
    EXPECT_TRUE(steered(nullptr, steering).isCalm());
    steering.strengthen(3.0);
    const WindFieldPtr wind = steered(nullptr, steering).field;
    ASSERT_TRUE(wind);
    EXPECT_NEAR(wind->velocity(WindPlace(0.0f, 0.0f, 10.0f), 0.0).x, 3.0f, 1e-5f);
    EXPECT_LT(wind->velocity(WindPlace(0.0f, 0.0f, 2.0f), 0.0).x, 2.5f) << "weaker near the ground";
    steering.strengthen(-99.0);
    EXPECT_TRUE(steered(nullptr, steering).isCalm());
}

TEST(WindSteering, ScalesAndTurnsOtherWinds) {
    const auto given =
        std::make_shared<FunctionWind>([](const glm::vec3& p, double) { return glm::vec3(p.x, 0.0f, 0.0f); });
    WindSteering steering = steeringOf(given);
    EXPECT_FALSE(steering.isSynthetic);
    for (int i = 0; i < 3; ++i)
        steering.strengthen(1.0);
    steering.turnClockwise(90.0);
    const Wind wind = steered(given, steering);
    EXPECT_LT(glm::length(sampler(wind).velocity({10.0f, 0.0f, 0.0f}, 0.0) - glm::vec3(0.0f, -13.0f, 0.0f)),
              1e-4f);
    EXPECT_EQ(steeringOf(wind).strength, 1.3) << "without rounding errors";
    steering.strengthen(1.0);
    const Wind again = steered(wind, steering);
    EXPECT_EQ(again.field, given);
    EXPECT_DOUBLE_EQ(again.adjustment.strength, 1.4) << "not applied twice";
    steering.changeGustiness(0.1);
    EXPECT_EQ(steered(wind, steering).gusts.intensity, 0.1);
}

} // namespace

// SPDX-License-Identifier: MIT
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/FunctionWind.h>

using namespace osgTreeWind;

TEST(FunctionWind, CallsTheFunction) {
    const FunctionWind wind([](const glm::vec3& p, double t) { return p * float(t); });
    EXPECT_EQ(wind.velocity({1, 2, 3}, 2.0), glm::vec3(2, 4, 6));
}

TEST(FunctionWind, NonFiniteResultsAreCalm) {
    const FunctionWind wind([](const glm::vec3& p, double) { return glm::vec3(1.0f, 1.0f / p.x, 1.0f); });
    EXPECT_EQ(wind.velocity({2, 0, 0}, 0), glm::vec3(1, 0.5f, 1));
    EXPECT_EQ(wind.velocity({0, 0, 0}, 0), glm::vec3(0));
    expectFiniteEverywhere(wind);
}

TEST(FunctionWind, EmptyFunctionIsCalm) {
    EXPECT_EQ(FunctionWind({}).velocity({}, 0), glm::vec3(0));
}

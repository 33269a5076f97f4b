// SPDX-License-Identifier: MIT
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/UniformWind.h>

using namespace osgTreeWind;

TEST(UniformWind, IsConstantInSpaceAndTime) {
    const UniformWind wind({3, -2, 1});
    EXPECT_EQ(wind.velocity({0, 0, 0}, 0), glm::vec3(3, -2, 1));
    EXPECT_EQ(wind.velocity({1e6f, -5, 30}, 1e9), glm::vec3(3, -2, 1));
    expectFiniteEverywhere(wind);
}

TEST(UniformWind, IsCalmIfNotFinite) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(UniformWind({nan, 1, 1}).velocity({}, 0), glm::vec3(0));
    EXPECT_EQ(UniformWind({1, inf, 1}).velocity({}, 0), glm::vec3(0));
    EXPECT_EQ(UniformWind({1, 1, -inf}).velocity({}, 0), glm::vec3(0));
}

// SPDX-License-Identifier: MIT
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <glm/geometric.hpp>

#include <cmath>

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

TEST(UniformWind, FollowsItsProfileAboveTheGround) {
    const UniformWind wind({6, 8, 1}, LogProfile{10.0, 0.1});
    EXPECT_EQ(wind.velocity({3, 4, 0.05f}, 7), glm::vec3(0.0f));
    EXPECT_EQ(wind.velocity({{3, 4, 210}, 200}, 7), glm::vec3(6, 8, 1));
    const float factor = static_cast<float>(std::log(20.0 / 0.1) / std::log(10.0 / 0.1));
    WindPlace places[] = {{1, 2, 20}, {3, 4, 20}, {5, 6, 10}};
    glm::vec3 out[3];
    wind.sample(places, 3, 0.0, out);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(out[i], wind.velocity(places[i], 0.0));
    EXPECT_LT(glm::length(out[0] - factor * glm::vec3(6, 8, 1)), 1e-5f);
    expectFiniteEverywhere(wind);
    EXPECT_EQ(UniformWind({6, 8, 1}, LogProfile{1.0, 2.0}).velocity({1, 2, 3}, 0), glm::vec3(6, 8, 1));
}

// SPDX-License-Identifier: MIT
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/RetimedWind.h>

using namespace osgTreeWind;

namespace {

WindFieldPtr clockWind() {
    return std::make_shared<FunctionWind>([](const glm::vec3& p, double t) { return glm::vec3(t, p.y, 0); });
}

} // namespace

TEST(RetimedWind, HoursPassInAMinute) {
    const RetimedWind wind(clockWind(), {7200.0, 60.0});
    EXPECT_EQ(wind.velocity({0, 5, 0}, 0.0), glm::vec3(7200, 5, 0));
    EXPECT_EQ(wind.velocity({0, 5, 0}, 60.0), glm::vec3(10800, 5, 0));
}

TEST(RetimedWind, FreezesAndRunsBackwards) {
    EXPECT_EQ(RetimedWind(clockWind(), {10.0, 0.0}).velocity({}, 99.0).x, 10.0f);
    EXPECT_EQ(RetimedWind(clockWind(), {10.0, -1.0}).velocity({}, 4.0).x, 6.0f);
}

TEST(RetimedWind, ACarriedWindIsThatOfWhenTheAirPassedThePlane) {
    const RetimedWind wind(clockWind(), {100.0, 1.0, -30.0, 8.0});
    EXPECT_EQ(wind.velocity({-30, 0, 0}, 4.0).x, 104.0f);
    EXPECT_EQ(wind.velocity({50, 0, 0}, 4.0).x, 94.0f);
    const WindPlace places[] = {{-30, 1, 0}, {50, 2, 0}};
    glm::vec3 winds[2];
    wind.sample(places, 2, 4.0, winds);
    EXPECT_EQ(winds[0], glm::vec3(104, 1, 0));
    EXPECT_EQ(winds[1], glm::vec3(94, 2, 0));
}

TEST(RetimedWind, NoInnerWindIsCalm) {
    EXPECT_EQ(RetimedWind(nullptr, {0, 1}).velocity({}, 0), glm::vec3(0));
}

TEST(RetimedWind, StaysFinite) {
    expectFiniteEverywhere(RetimedWind(clockWind(), {1e300, 1e300}));
    expectFiniteEverywhere(RetimedWind(clockWind(), {0.0, std::numeric_limits<double>::quiet_NaN()}));
    expectFiniteEverywhere(RetimedWind(clockWind(), {0.0, 1.0, 0.0, 1e-300}));
}

// SPDX-License-Identifier: MIT
#include <tests/wind/Extremes.h>
#include <tests/wind/Winds.h>

#include <osgTreeWind/wind/FunctionWind.h>

using namespace osgTreeWind;

namespace {

WindFieldPtr clockWind() {
    return std::make_shared<FunctionWind>([](const glm::vec3& p, double t) { return glm::vec3(t, p.y, 0); });
}

} // namespace

TEST(WindClock, ScalesTime) {
    const LayeredWind wind = withClock(clockWind(), {7200.0, 60.0});
    EXPECT_EQ(wind.velocity({0, 5, 0}, 0.0), glm::vec3(7200, 5, 0));
    EXPECT_EQ(wind.velocity({0, 5, 0}, 60.0), glm::vec3(10800, 5, 0));
}

TEST(WindClock, FreezesAndPlaysBackward) {
    EXPECT_EQ(withClock(clockWind(), {10.0, 0.0}).velocity({}, 99.0).x, 10.0f);
    EXPECT_EQ(withClock(clockWind(), {10.0, -1.0}).velocity({}, 4.0).x, 6.0f);
}

TEST(WindClock, TravellingWindIsDelayedDownwind) {
    const LayeredWind wind = withClock(clockWind(), {100.0, 1.0, {8.0, 0.0}, {-30.0, 0.0}});
    EXPECT_EQ(wind.velocity({-30, 0, 0}, 4.0).x, 104.0f);
    EXPECT_EQ(wind.velocity({50, 0, 0}, 4.0).x, 94.0f);
    const WindPlace places[] = {{-30, 1, 0}, {50, 2, 0}};
    glm::vec3 winds[2];
    wind.sample(places, 2, 4.0, winds);
    EXPECT_EQ(winds[0], glm::vec3(104, 1, 0));
    EXPECT_EQ(winds[1], glm::vec3(94, 2, 0));
}

TEST(WindClock, TravelsInAnyDirection) {
    const LayeredWind wind = withClock(clockWind(), {0.0, 1.0, {-3.0, 4.0}}); // 5 m/s
    EXPECT_FLOAT_EQ(wind.velocity({-30, 40, 0}, 100.0).x, 90.0f);
    EXPECT_FLOAT_EQ(wind.velocity({40, 30, 0}, 100.0).x, 100.0f); // across the travel direction
    EXPECT_FLOAT_EQ(wind.velocity({30, -40, 0}, 100.0).x, 110.0f);
}

namespace {

/// The combined clock equals two nested samplers.
void expectEqualsNested(const WindClock& outer, const WindClock& inner) {
    const LayeredWind within = withClock(clockWind(), inner),
                      both = withClock(clockWind(), outer.then(inner));
    const LayeredWind apart = withClock(std::make_shared<FunctionWind>([&](const glm::vec3& p, double t) {
                                            return within.velocity(WindPlace(p), t);
                                        }),
                                        outer);
    for (const float x : {-40.0f, 0.0f, 25.0f})
        for (const double time : {-3.0, 0.0, 7.0})
            EXPECT_NEAR(both.velocity({x, 1, 0}, time).x, apart.velocity({x, 1, 0}, time).x, 1e-4)
                << x << ", " << time;
}

} // namespace

TEST(WindClock, ThenChainsTwoClocks) {
    expectEqualsNested({100.0, 60.0}, {7.0, 0.5});
    expectEqualsNested({100.0, 60.0}, {7.0, 0.5, {8.0, 0.0}, {-30.0, 0.0}});
    expectEqualsNested({100.0, 2.0, {4.0, 0.0}, {10.0, 0.0}}, {7.0, 0.5});
    expectEqualsNested({100.0, 2.0, {4.0, 0.0}, {10.0, 0.0}}, {7.0, 0.5, {8.0, 0.0}, {-30.0, 0.0}});
    const WindClock travelling{0.0, 1.0, {0.1, 0.3}, {7.0, 1.0}};
    EXPECT_EQ(travelling.then(WindClock()).travel, travelling.travel)
        << "exact, so that files do not change when rewritten";
    expectEqualsNested({100.0, 2.0, {3.0, 4.0}, {10.0, 7.0}}, {7.0, 0.5, {8.0, 0.0}, {-30.0, 0.0}});
    expectEqualsNested({100.0, 2.0, {-4.0, 0.0}, {10.0, 0.0}},
                       {7.0, 0.5, {8.0, 0.0}, {-30.0, 0.0}}); // opposite travel velocities cancel
}

TEST(WindClock, IsCalmWithoutAField) {
    EXPECT_EQ(withClock(nullptr, {0, 1}).velocity({}, 0), glm::vec3(0));
}

TEST(WindClock, StaysFinite) {
    expectFiniteEverywhere(withClock(clockWind(), {1e300, 1e300}));
    expectFiniteEverywhere(withClock(clockWind(), {0.0, std::numeric_limits<double>::quiet_NaN()}));
    expectFiniteEverywhere(withClock(clockWind(), {0.0, 1.0, {1e-300, 0.0}}));
}

// SPDX-License-Identifier: MIT
#include <tests/Near.h>
#include <tests/wind/Extremes.h>
#include <tests/wind/Winds.h>

#include <osgTreeWind/wind/FunctionWind.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <limits>

using namespace osgTreeWind;

namespace {

WindFieldPtr toward(const glm::vec3& velocity) {
    return std::make_shared<FunctionWind>([velocity](const glm::vec3&, double) { return velocity; });
}

TEST(WindAdjustment, TurnsANortherlyIntoAnEasterly) {
    const LayeredWind wind = withAdjustment(
        toward({0.0f, -4.0f, 1.0f}), {1.5, glm::half_pi<float>()}); // clockwise from above, as a compass
    expectNear(wind.velocity({}, 0.0), {-6.0f, 0.0f, 1.5f});
}

TEST(WindAdjustment, DoesNotMovePlaces) {
    const LayeredWind wind = withAdjustment(std::make_shared<FunctionWind>([](const glm::vec3& p, double t) {
                                                return glm::vec3(p.x, 0.0f, static_cast<float>(t));
                                            }),
                                            {1.0, glm::pi<float>()});
    expectNear(wind.velocity({7.0f, 5.0f, 0.0f}, 2.0), {-7.0f, 0.0f, 2.0f});
}

TEST(WindAdjustment, ClampsValuesAndStaysFinite) {
    expectFiniteEverywhere(withAdjustment(toward({5.0f, 3.0f, 0.0f}), {10.0, -99.0f}));
    expectFiniteEverywhere(withAdjustment(nullptr, {1e300, std::numeric_limits<float>::quiet_NaN()}));
    EXPECT_EQ(WindAdjustment({-1.0, 0.0}).matrix(), glm::mat3(0.0f));
}

} // namespace

// SPDX-License-Identifier: MIT
#include <tests/Near.h>
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/AdjustedWind.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/GustWind.h>

#include <glm/geometric.hpp>

#include <limits>

using namespace osgTreeWind;

namespace {

WindFieldPtr toward(const glm::vec3& velocity) {
    return std::make_shared<FunctionWind>([velocity](const glm::vec3&, double) { return velocity; });
}

TEST(AdjustedWind, ANortherlyTurnedAQuarterIsAnEasterly) {
    const AdjustedWind wind(toward({0.0f, -4.0f, 1.0f}), {1.5, 90.0}); // clockwise from above, as a compass
    expectNear(wind.velocity({}, 0.0), {-6.0f, 0.0f, 1.5f});
}

TEST(AdjustedWind, OfAnAdjustedWindItTakesWhatIsWithin) {
    const auto once =
        std::make_shared<AdjustedWind>(toward({3.0f, 0.0f, 0.0f}), AdjustedWind::Adjustment{2.0, 300.0});
    const AdjustedWind twice(once, {0.25, 105.0});
    EXPECT_EQ(twice.inner(), once->inner());
    EXPECT_EQ(twice.adjustment().strength, 0.5);
    EXPECT_EQ(twice.adjustment().turn, 45.0);
}

TEST(AdjustedWind, TurnsPlacesNowhere) {
    const AdjustedWind wind(std::make_shared<FunctionWind>([](const glm::vec3& p, double t) {
                                return glm::vec3(p.x, 0.0f, static_cast<float>(t));
                            }),
                            {1.0, 180.0});
    expectNear(wind.velocity({7.0f, 5.0f, 0.0f}, 2.0), {-7.0f, 0.0f, 2.0f});
}

TEST(AdjustedWind, WithoutGustsItIsTheMeanAdjusted) {
    GustWind::Parameters gusts;
    gusts.mean = {8.0f, 0.0f, 0.0f};
    const AdjustedWind wind(GustWind::create(gusts).value(), {0.5, 90.0});
    ASSERT_TRUE(wind.withoutGusts());
    expectNear(wind.withoutGusts()->velocity({3.0f, 4.0f, 5.0f}, 6.0), {0.0f, -4.0f, 0.0f});
    EXPECT_FALSE(AdjustedWind(toward({1.0f, 0.0f, 0.0f}), {}).withoutGusts());
}

TEST(AdjustedWind, StaysFiniteAndHoldsWhatIsOutOfRange) {
    GustWind::Parameters gusts;
    expectFiniteEverywhere(AdjustedWind(GustWind::create(gusts).value(), {10.0, -360.0}));
    expectFiniteEverywhere(AdjustedWind(nullptr, {1e300, std::numeric_limits<double>::quiet_NaN()}));
    EXPECT_EQ(AdjustedWind(nullptr, {-1.0, 0.0}).adjustment().strength, 0.0);
}

} // namespace

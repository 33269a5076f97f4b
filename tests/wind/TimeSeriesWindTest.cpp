// SPDX-License-Identifier: MIT
#include <tests/Near.h>
#include <tests/base/FirstProblem.h>
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/WindDirection.h>

#include <glm/trigonometric.hpp>

#include <functional>

using namespace osgTreeWind;

namespace {

WindSeries threeRecords() {
    WindSeries series;
    series.times = {10, 20, 50};
    series.velocities = {{1, 0, 0}, {3, 4, 0}, {0, -2, 6}};
    return series;
}

std::shared_ptr<const TimeSeriesWind> made(WindSeries series) {
    auto wind = TimeSeriesWind::create(std::move(series));
    EXPECT_TRUE(wind) << firstProblem(wind);
    return wind.value();
}

} // namespace

TEST(TimeSeriesWind, IsExactAtRecordsAndLinearBetween) {
    const auto wind = made(threeRecords());
    EXPECT_EQ(wind->velocity({5, 5, 5}, 10), glm::vec3(1, 0, 0));
    EXPECT_EQ(wind->velocity({5, 5, 5}, 20), glm::vec3(3, 4, 0));
    expectNear(wind->velocity({}, 15), {2, 2, 0});
    expectNear(wind->velocity({}, 30), {2, 2, 2});
}

TEST(TimeSeriesWind, ClampsBeforeAndAfter) {
    const auto wind = made(threeRecords());
    EXPECT_EQ(wind->velocity({}, -100), glm::vec3(1, 0, 0));
    EXPECT_EQ(wind->velocity({}, 1e9), glm::vec3(0, -2, 6));
}

TEST(TimeSeriesWind, RepeatsWithThePeriodOfTheRecord) {
    WindSeries series = threeRecords();
    series.repeat = true;
    const auto wind = made(series);
    for (int turn : {-3, -1, 1, 2, 1000})
        for (double t : {10.0, 15.0, 30.0, 49.0})
            expectNear(wind->velocity({}, t + 40.0 * turn), made(threeRecords())->velocity({}, t));
}

TEST(TimeSeriesWind, ARepeatedSingleRecordIsConstant) {
    WindSeries series;
    series.times = {7};
    series.velocities = {{1, 2, 3}};
    series.repeat = true;
    const auto wind = made(series);
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(1, 2, 3));
    EXPECT_EQ(wind->velocity({}, 100), glm::vec3(1, 2, 3));
}

// Halfway between 350 and 10 degrees is north; interpolating the numbers would give south.
TEST(TimeSeriesWind, InterpolatesComponentsNotDirections) {
    WindSeries series;
    series.times = {0, 1};
    series.velocities = {windVelocity({5, glm::radians(350.0)}, DirectionSense::From),
                         windVelocity({5, glm::radians(10.0)}, DirectionSense::From)};
    const glm::vec3 halfway = made(series)->velocity({}, 0.5);
    EXPECT_NEAR(halfway.x, 0.0f, 1e-5f);
    EXPECT_NEAR(halfway.y, -5.0f * std::cos(10.0f * 3.14159265f / 180.0f), 1e-5f);
}

TEST(TimeSeriesWind, FollowsTheLogarithmicProfile) {
    WindSeries series = threeRecords();
    series.profile = LogProfile{10.0, 0.1};
    const auto wind = made(series);
    expectNear(wind->velocity({0, 0, 10}, 20), {3, 4, 0});
    expectNear(wind->velocity({0, 0, 1}, 20), {1.5, 2, 0});
    EXPECT_EQ(wind->velocity({0, 0, 0.09f}, 20), glm::vec3(0));
    EXPECT_EQ(wind->velocity({0, 0, -2}, 20), glm::vec3(0));
}

TEST(TimeSeriesWind, ProfileStartsAtTheGround) {
    WindSeries series = threeRecords();
    series.profile = LogProfile{10.0, 0.1};
    const auto wind = made(series);
    for (float ground : {0.0f, 200.0f, -50.0f}) {
        const WindPlace places[] = {{{0, 0, ground + 10}, ground}, {{0, 0, ground - 1}, ground}};
        glm::vec3 winds[2];
        wind->sample(places, 2, 20, winds);
        expectNear(winds[0], {3, 4, 0});
        EXPECT_EQ(winds[1], glm::vec3(0));
        EXPECT_EQ(wind->velocity(places[0], 20), winds[0]);
    }
}

TEST(TimeSeriesWind, IsFiniteForExtremePlacesAndTimes) {
    const float max = std::numeric_limits<float>::max();
    WindSeries series = threeRecords();
    expectFiniteEverywhere(*made(series));
    series.repeat = true;
    series.profile = LogProfile{10.0, 0.1};
    series.velocities[1] = {max, -max, max};
    expectFiniteEverywhere(*made(series));
}

namespace {

struct BadSeries {
    const char* name;
    std::function<void(WindSeries&)> spoil;
    const char* problem;
};

void PrintTo(const BadSeries& bad, std::ostream* out) {
    *out << bad.name;
}

} // namespace

class TimeSeriesWindRefuses : public testing::TestWithParam<BadSeries> {};

TEST_P(TimeSeriesWindRefuses, WithKeyAndReason) {
    WindSeries series = threeRecords();
    GetParam().spoil(series);
    EXPECT_EQ(firstProblem(TimeSeriesWind::create(series)), GetParam().problem);
}

INSTANTIATE_TEST_SUITE_P(
    Series, TimeSeriesWindRefuses,
    testing::Values(
        BadSeries{"Empty", [](WindSeries& s) { s = {}; }, "times: expected at least one record"},
        BadSeries{"Lengths", [](WindSeries& s) { s.velocities.pop_back(); },
                  "velocities: expected one per time, 3, found 2"},
        BadSeries{"Order", [](WindSeries& s) { s.times[2] = 20; },
                  "times: expected increasing seconds, found times[2] = 20 after 20"},
        BadSeries{"HugeTime", [](WindSeries& s) { s.times[2] = 1e300; },
                  "times: expected seconds within 1e15, found times[2] = 1e+300"},
        BadSeries{"NotFinite", [](WindSeries& s) { s.velocities[1].y = std::nanf(""); },
                  "velocities: expected finite m/s at velocities[1]"},
        BadSeries{"Profile",
                  [](WindSeries& s) {
                      s.profile = LogProfile{0.1, 0.5};
                  },
                  "profile: expected 0 < roughness < height in metres, found roughness 0.5 and height 0.1"}),
    [](const auto& info) { return info.param.name; });

// SPDX-License-Identifier: MIT
#include <tests/Near.h>
#include <tests/base/FirstProblem.h>
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/GridWind.h>

#include <functional>

using namespace osgTreeWind;

namespace {

/// A grid filled from a formula of scene position and time.
GridWind::Grid filled(glm::ivec3 points, const std::vector<double>& times,
                      const std::function<glm::vec3(glm::dvec3, double)>& formula) {
    GridWind::Grid grid;
    grid.points = points;
    grid.origin = {100, -200, 10};
    grid.cell = {10, 20, 5};
    grid.times = times;
    for (double time : times.empty() ? std::vector<double>{0.0} : times)
        for (int k = 0; k < points.z; ++k)
            for (int j = 0; j < points.y; ++j)
                for (int i = 0; i < points.x; ++i) {
                    const glm::vec3 v = formula(grid.origin + grid.cell * glm::dvec3(i, j, k), time);
                    grid.values.insert(grid.values.end(), {v.x, v.y, v.z});
                }
    return grid;
}

/// Linear in every coordinate, so that interpolation is exact.
glm::vec3 linear(glm::dvec3 p, double t) {
    return {1 + 0.02 * p.x - 0.01 * p.y, 0.1 * p.z + 0.0001 * p.x * p.y, -2 + 0.5 * t};
}

std::shared_ptr<const GridWind> made(GridWind::Grid grid) {
    auto wind = GridWind::create(std::move(grid));
    EXPECT_TRUE(wind) << firstProblem(wind);
    return wind.value();
}

const std::vector<double> times = {5.0, 6.0, 10.0};

} // namespace

TEST(GridWind, GridPointsAreExact) {
    const auto wind = made(filled({4, 3, 2}, times, linear));
    EXPECT_EQ(wind->velocity({100, -200, 10}, 5.0), linear({100, -200, 10}, 5.0));
    EXPECT_EQ(wind->velocity({120, -180, 15}, 6.0), linear({120, -180, 15}, 6.0));
    EXPECT_EQ(wind->velocity({130, -160, 15}, 10.0), linear({130, -160, 15}, 10.0));
}

TEST(GridWind, IsLinearInSpaceAndTime) {
    const auto wind = made(filled({4, 3, 2}, times, linear));
    for (const glm::dvec3& p :
         {glm::dvec3(103, -197, 11), glm::dvec3(127.5, -165, 14), glm::dvec3(110, -171, 10)})
        for (double t : {5.0, 5.25, 7.0, 9.99})
            expectNear(wind->velocity(glm::vec3(p), t), linear(p, t));
}

TEST(GridWind, ClampsToTheEdgeOutside) {
    const auto wind = made(filled({4, 3, 2}, times, linear));
    expectNear(wind->velocity({0, -190, 12}, 6), linear({100, -190, 12}, 6));
    expectNear(wind->velocity({1e6f, -190, 12}, 6), linear({130, -190, 12}, 6));
    expectNear(wind->velocity({115, -500, 12}, 6), linear({115, -200, 12}, 6));
    expectNear(wind->velocity({115, 500, 12}, 6), linear({115, -160, 12}, 6));
    expectNear(wind->velocity({115, -190, 0}, 6), linear({115, -190, 10}, 6));
    expectNear(wind->velocity({115, -190, 99}, 6), linear({115, -190, 15}, 6));
}

TEST(GridWind, ClampsToTheFirstAndLastTime) {
    const auto wind = made(filled({2, 2, 2}, times, linear));
    EXPECT_EQ(wind->velocity({100, -200, 10}, -1e9).z, 0.5f);
    EXPECT_EQ(wind->velocity({100, -200, 10}, 1e9).z, 3.0f);
}

TEST(GridWind, SingleLayerAppliesToAllHeights) {
    const auto wind = made(filled({4, 3, 1}, {}, linear));
    expectNear(wind->velocity({115, -190, -50}, 0), linear({115, -190, 10}, 0));
    expectNear(wind->velocity({115, -190, 500}, 77), linear({115, -190, 10}, 0));
}

TEST(GridWind, SampleEqualsVelocity) {
    const auto wind = made(filled({4, 3, 2}, times, linear));
    std::vector<WindPlace> places;
    std::vector<glm::vec3> sampled(200);
    for (int i = 0; i < 200; ++i)
        places.emplace_back(95 + 0.2f * i, -205 + 0.3f * i, 8 + 0.05f * i);
    wind->sample(places.data(), places.size(), 7.3, sampled.data());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_EQ(sampled[i], wind->velocity(places[i], 7.3)) << i;
}

TEST(GridWind, LayersMayBeUneven) {
    GridWind::Grid grid;
    grid.points = {1, 1, 3};
    grid.heights = {2, 10, 50};
    grid.values = {1, 0, 0, 3, 0, 0, 8, 0, 0};
    const auto wind = made(grid);
    for (const auto& [z, u] : {std::pair(-5.0f, 1.0f), {2, 1}, {6, 2}, {10, 3}, {30, 5.5f}, {50, 8}, {99, 8}})
        EXPECT_NEAR(wind->velocity({3, 4, z}, 0).x, u, 1e-6) << "at " << z;
    expectFiniteEverywhere(*wind);
}

TEST(GridWind, HeightsMayBeAboveTheGround) {
    GridWind::Grid grid;
    grid.points = {1, 1, 2};
    grid.heights = {10, 100};
    grid.aboveGround = true;
    grid.values = {10, 0, 0, 20, 0, 0};
    const auto wind = GridWind::create(grid).value();
    EXPECT_FLOAT_EQ(wind->velocity({glm::vec3(0, 0, 855), 800.0f}, 0).x, 15.0f);
    EXPECT_FLOAT_EQ(wind->velocity({glm::vec3(0, 0, 55), 0.0f}, 0).x, 15.0f);
}

TEST(GridWind, FollowsTheLogarithmicProfileBelowItsLayers) {
    GridWind::Grid grid;
    grid.points = {1, 1, 2};
    grid.heights = {10, 100};
    grid.aboveGround = true;
    grid.roughness = 0.1;
    grid.values = {10, 0, 0, 20, 0, 0};
    const auto wind = GridWind::create(grid).value();
    const auto at = [&](float height) {
        return wind->velocity({glm::vec3(0, 0, 500), 500.0f - height}, 0).x;
    };
    EXPECT_FLOAT_EQ(at(1.0f), 5.0f) << "ln 10 is half of ln 100";
    EXPECT_EQ(at(0.05f), 0.0f);
    EXPECT_FLOAT_EQ(at(10.0f), 10.0f);
    EXPECT_FLOAT_EQ(at(55.0f), 15.0f) << "between layers it is linear";
    EXPECT_FLOAT_EQ(at(500.0f), 20.0f);
    grid.points.z = 1;
    grid.heights = {10};
    grid.values = {10, 0, 0};
    EXPECT_FLOAT_EQ(GridWind::create(grid).value()->velocity({0, 0, 100}, 0).x, 15.0f);
}

TEST(GridWind, LayersMayFollowTerrainAndChangeWithTime) {
    GridWind::Grid grid;
    grid.points = {2, 1, 2};
    grid.cell = {10, 1, 1};
    grid.times = {0, 1};
    grid.heights = {0, 100, 10, 110, 20, 120, 40, 140};
    for (float height : grid.heights)
        grid.values.insert(grid.values.end(), {height, 0, 0});
    const auto wind = made(grid); // u equals the height, clamped below and above
    EXPECT_NEAR(wind->velocity({0, 0, 5}, 0).x, 5, 1e-5);
    EXPECT_NEAR(wind->velocity({10, 0, 105}, 0).x, 105, 1e-5);
    EXPECT_NEAR(wind->velocity({5, 0, 52}, 0).x, 52, 1e-5);
    EXPECT_NEAR(wind->velocity({0, 0, 30}, 1).x, 30, 1e-5);
    EXPECT_NEAR(wind->velocity({0, 0, 5}, 1).x, 20, 1e-5);
    EXPECT_NEAR(wind->velocity({0, 0, 5}, 0.5).x, 12.5, 1e-5);
    expectFiniteEverywhere(*wind);
}

TEST(GridWind, IsFiniteForExtremePlacesAndTimes) {
    expectFiniteEverywhere(*made(filled({4, 3, 2}, times, linear)));
    expectFiniteEverywhere(*made(filled({1, 1, 1}, {}, linear)));
}

TEST(GridWind, TheLargestFloatsDoNotOverflow) {
    const float max = std::numeric_limits<float>::max();
    GridWind::Grid grid;
    grid.points = {2, 2, 1};
    grid.cell = glm::dvec3(1e-300);
    grid.values = {max, max, -max, max, -max, -max, max, max, -max, max, -max, -max};
    expectFiniteEverywhere(*made(grid));
}

namespace {

struct BadGrid {
    const char* name;
    std::function<void(GridWind::Grid&)> spoil;
    const char* problem;
};

void PrintTo(const BadGrid& bad, std::ostream* out) {
    *out << bad.name;
}

const float notANumber = std::numeric_limits<float>::quiet_NaN();

} // namespace

class GridWindRefuses : public testing::TestWithParam<BadGrid> {};

TEST_P(GridWindRefuses, WithKeyAndReason) {
    GridWind::Grid grid = filled({4, 3, 2}, times, linear);
    GetParam().spoil(grid);
    EXPECT_EQ(firstProblem(GridWind::create(grid)), GetParam().problem);
}

using Grid = GridWind::Grid;
INSTANTIATE_TEST_SUITE_P(
    Grid, GridWindRefuses,
    testing::Values(
        BadGrid{"TooFewValues", [](Grid& g) { g.values.pop_back(); },
                "values: expected 216 numbers (3 x 4 x 3 x 2 points x 3 times), found 215"},
        BadGrid{"NoValues",
                [](Grid& g) {
                    g.values.clear();
                    g.times.clear();
                },
                "values: expected 72 numbers (3 x 4 x 3 x 2 points), found 0"},
        BadGrid{"HugeSize", [](Grid& g) { g.points = glm::ivec3(1 << 30); },
                "values: expected 1.1141460353568422e+28 numbers (3 x 1073741824 x 1073741824 x "
                "1073741824 points "
                "x 3 times), found 216"},
        BadGrid{"NotFinite", [](Grid& g) { g.values[7] = notANumber; },
                "values: expected finite m/s, found nan at index 7"},
        BadGrid{"NoCell", [](Grid& g) { g.cell.y = 0; }, "cell: expected metres above 0, found 10, 0, 5"},
        BadGrid{"CellBackwards", [](Grid& g) { g.cell.x = -10; },
                "cell: expected metres above 0, found -10, 20, 5"},
        BadGrid{"CellNan", [](Grid& g) { g.cell.z = notANumber; },
                "cell: expected metres above 0, found 10, 20, nan"},
        BadGrid{"OriginNan", [](Grid& g) { g.origin.z = notANumber; }, "origin: expected finite metres"},
        BadGrid{"HeightsCount",
                [](Grid& g) {
                    g.heights = {1, 2, 3};
                },
                "heights: expected one for each layer, point, or point and time, found 3"},
        BadGrid{"HeightsDownward",
                [](Grid& g) {
                    g.heights = {2, 1};
                },
                "heights: expected finite metres, increasing upward, found 1 at index 1"},
        BadGrid{"RoughnessWithoutGround", [](Grid& g) { g.roughness = 0.1; },
                "roughness: expected heights above the ground, which it needs"},
        BadGrid{"RoughnessTooLarge",
                [](Grid& g) {
                    g.heights = {1, 2};
                    g.aboveGround = true;
                    g.roughness = 1.0;
                },
                "roughness: expected above 0 and below the lowest height, 1 m, found 1"},
        BadGrid{"HeightsNan",
                [](Grid& g) {
                    g.heights = {0, notANumber};
                },
                "heights: expected finite metres, increasing upward, found nan at index 1"},
        BadGrid{"NoPoints", [](Grid& g) { g.points.y = 0; },
                "points: expected at least 1 in each direction, found 4, 0, 2"},
        BadGrid{"TimesEqual", [](Grid& g) { g.times[1] = 5; },
                "times: expected increasing seconds, found times[1] = 5 after 5"},
        BadGrid{"TimesBackwards", [](Grid& g) { g.times[2] = 5.5; },
                "times: expected increasing seconds, found times[2] = 5.5 after 6"},
        BadGrid{"TimeNan", [](Grid& g) { g.times[0] = notANumber; },
                "times: expected seconds within 1e15, found times[0] = nan"}),
    [](const auto& info) { return info.param.name; });

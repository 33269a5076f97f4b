// SPDX-License-Identifier: MIT
// Gusts over winds that are not uniform.
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/wind/Winds.h>

#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/windfiles/WindFile.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace osgTreeWind;

namespace {

Wind withGusts(WindFieldPtr field, double intensity = 0.2, std::uint32_t seed = 1) {
    Wind wind(std::move(field));
    wind.gusts = {intensity, 40.0, seed};
    return wind;
}

/// 4 to 16 m/s that turn from south-east to north-west over 300 m, at the points of a grid of 100 m.
GridWind::Grid turningGrid() {
    GridWind::Grid grid;
    grid.points = {4, 4, 1};
    grid.origin = {-150.0, -150.0, 0.0};
    grid.cell = {100.0, 100.0, 1.0};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            const float speed = 4.0f * static_cast<float>(1 + y), angle = 0.5f * static_cast<float>(x) - 0.6f;
            for (const float v : {speed * std::cos(angle), speed * std::sin(angle), 0.5f})
                grid.values.push_back(v);
        }
    return grid;
}

std::shared_ptr<const GridWind> turning() {
    return GridWind::create(turningGrid()).value();
}

/// Mean and deviations along the mean, across it and upward, over times and seeds.
struct GustStatistics {
    glm::dvec3 mean{0.0}, deviation{0.0};

    GustStatistics(const Wind& given, const WindPlace& place, int seeds = 40) {
        std::vector<glm::dvec3> all;
        for (int seed = 1; seed <= seeds; ++seed) {
            Wind wind = given;
            wind.gusts.seed = static_cast<std::uint32_t>(seed);
            const WindFieldPtr field = asField(wind);
            for (int i = 0; i < 250; ++i)
                all.emplace_back(field->velocity(place, 29.0 * i));
        }
        for (const glm::dvec3& v : all)
            mean += v / static_cast<double>(all.size());
        const double speed = std::hypot(mean.x, mean.y);
        glm::dvec3 squares(0.0);
        for (const glm::dvec3& v : all) {
            const glm::dvec3 u = v - mean;
            const glm::dvec3 turned((u.x * mean.x + u.y * mean.y) / speed,
                                    (u.y * mean.x - u.x * mean.y) / speed, u.z);
            squares += turned * turned / static_cast<double>(all.size());
        }
        deviation = glm::sqrt(squares);
    }
};

/// The mean is that of the field; gusts have the given deviation along it, and 0.8 and 0.5 of that across and
/// upward (IEC 61400-1).
void expectGustsOver(const Wind& wind, const WindPlace& place, double intensity) {
    const GustStatistics found(wind, place);
    Wind steady = wind;
    steady.gusts.intensity = 0.0;
    const glm::dvec3 mean(asField(steady)->velocity(place, 0.0));
    const double speed = std::hypot(mean.x, mean.y);
    EXPECT_LT(glm::distance(found.mean, mean), 0.02 * speed) << place.position.x << ' ' << place.position.y;
    const glm::dvec3 expected = intensity * speed * glm::dvec3(1.0, 0.8, 0.5);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found.deviation[i] / expected[i], 1.0, 0.1) << i << " at " << place.position.x;
}

} // namespace

TEST(WindGusts, HaveTheLocalMeanStrengthAndDirectionOfTheField) {
    for (const float x : {-150.0f, -40.0f, 73.0f, 400.0f})
        for (const float y : {-100.0f, 20.0f, 150.0f})
            expectGustsOver(withGusts(turning()), WindPlace(x, y, 10.0f), 0.2);
}

/// EN 1991-1-4: the intensity is in proportion to 1 / ln(z / z0).
TEST(WindGusts, IntensityFallsWithTheHeightAboveTheGround) {
    GridWind::Grid grid = turningGrid();
    grid.heights = {20.0f};
    grid.aboveGround = true;
    grid.roughness = 0.1;
    const Wind wind = withGusts(GridWind::create(grid).value());
    for (const float height : {6.0f, 20.0f, 60.0f})
        expectGustsOver(wind, WindPlace(glm::vec3(30.0f, -10.0f, 500.0f + height), 500.0f),
                        0.2 * std::log(20.0 / 0.1) / std::log(static_cast<double>(height) / 0.1));
    grid.points.z = 2; // several layers: the intensity is that at 10 m
    grid.heights = {5.0f, 40.0f};
    grid.values.insert(grid.values.end(), grid.values.begin(), grid.values.end());
    expectGustsOver(withGusts(GridWind::create(grid).value()), WindPlace(30.0f, -10.0f, 10.0f), 0.2);
    for (const float height : {5.0f, 30.0f}) // unknown ground: the roughness makes the intensity at 10 m
        expectGustsOver(withGusts(turning()), WindPlace(30.0f, -10.0f, height),
                        1.0 / (5.0 + std::log(static_cast<double>(height) / 10.0)));
}

TEST(WindGusts, WithoutIntensityTheFieldIsUnchanged) {
    const auto field = turning();
    EXPECT_EQ(asField(withGusts(field, 0.0)), field);
    Wind turned = withGusts(field, 0.0), plain = field;
    turned.adjustment.turn = plain.adjustment.turn = 0.3f;
    EXPECT_EQ(asField(turned)->velocity({3, 4, 5}, 6.0), asField(plain)->velocity({3, 4, 5}, 6.0));
}

TEST(WindGusts, AreContinuousAcrossCells) {
    const WindFieldPtr wind = asField(withGusts(turning()));
    for (const double time : {3.0, 5000.0, 1e6}) {
        glm::vec3 last = wind->velocity(WindPlace(-200.0f, -180.0f, 10.0f), time);
        for (float at = -200.0f; at < 200.0f; at += 0.005f) {
            const glm::vec3 next = wind->velocity(WindPlace(at, 0.9f * at, 10.0f), time);
            ASSERT_LT(glm::distance(next, last), 0.05f) << at << " m at " << time << " s";
            last = next;
        }
    }
}

/// The integral time scale is the length over the speed of travel: that of the field at (0, 0).
TEST(WindGusts, HaveTheLengthScaleAndTravelWithTheMeanWind) {
    const auto field = turning();
    const glm::vec3 travel = field->velocity(WindPlace(0.0f, 0.0f, 10.0f), 0.0) * glm::vec3(1, 1, 0);
    const double speed = static_cast<double>(glm::length(travel));
    constexpr int lags = 80;
    double products[lags] = {}, downwind = 0.0, upwind = 0.0, squares = 0.0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        const WindFieldPtr wind = asField(withGusts(field, 0.2, seed));
        const auto along = [&](const glm::vec3& place, double time) {
            const WindPlace at(place.x, place.y, 10.0f);
            const glm::vec3 mean = field->velocity(at, 0.0);
            return static_cast<double>(glm::dot(wind->velocity(at, time) - mean, mean) /
                                       glm::dot(mean, mean));
        };
        for (int i = 0; i < 60; ++i) {
            const double time = 37.0 * i, now = along({}, time);
            squares += now * now;
            for (int lag = 0; lag < lags; ++lag)
                products[lag] += now * along({}, time + 2.0 * lag / speed); // every 2 m
            downwind += now * along(3.0f * travel, time + 3.0);
            upwind += now * along(-3.0f * travel, time + 3.0);
        }
    }
    double scale = -1.0;
    for (const double product : products)
        scale += 2.0 * product / squares;
    EXPECT_NEAR(scale, 40.0, 8.0);
    EXPECT_GT(downwind / squares, 0.65);
    EXPECT_LT(upwind / squares, 0.4);
}

/// The direction of gusts is then that of the mean at (0, 0).
TEST(WindGusts, HaveTheTurbulenceOfTheField) {
    GridWind::Grid grid = turningGrid();
    for (int i = 0; i < 16; ++i)
        grid.deviations.push_back(0.5f * static_cast<float>(1 + i / 4)); // northward
    std::fill_n(grid.values.begin(), 12, 0.0f);                          // calm in the south
    Wind wind = withGusts(GridWind::create(grid).value());
    wind.adjustment.strength = 2.0;
    const glm::dvec3 travel(wind.field->velocity(WindPlace(0.0f, 0.0f, 10.0f), 0.0));
    for (const float y : {-150.0f, 0.0f, 150.0f}) {
        const double expected = 2.0 * 0.5 * (1.0 + (static_cast<double>(y) + 150.0) / 100.0);
        double along = 0.0, across = 0.0, up = 0.0, count = 0.0;
        for (std::uint32_t seed = 1; seed <= 40; ++seed) {
            wind.gusts.seed = seed;
            const WindFieldPtr gusty = asField(wind);
            for (int i = 0; i < 250; ++i, ++count) {
                const WindPlace place(40.0f, y, 10.0f);
                const glm::dvec3 u(gusty->velocity(place, 29.0 * i) -
                                   2.0f * wind.field->velocity(place, 0.0));
                along += std::pow((u.x * travel.x + u.y * travel.y) / std::hypot(travel.x, travel.y), 2.0);
                across += std::pow((u.x * travel.y - u.y * travel.x) / std::hypot(travel.x, travel.y), 2.0);
                up += u.z * u.z;
            }
        }
        EXPECT_NEAR(std::sqrt(along / count) / expected, 1.0, 0.1) << y;
        EXPECT_NEAR(std::sqrt(across / count) / expected, 0.8, 0.08) << y;
        EXPECT_NEAR(std::sqrt(up / count) / expected, 0.5, 0.05) << y;
    }
    wind.gusts.intensity = 0.0;
    EXPECT_EQ(asField(wind)->velocity({1, 2, 3}, 4.0), 2.0f * wind.field->velocity({1, 2, 3}, 4.0));
}

TEST(WindGusts, FollowClockAndAdjustment) {
    const auto field = turning();
    const WindPlace place(40.0f, -30.0f, 12.0f);
    Wind wind = withGusts(field);
    const glm::vec3 later = asField(wind)->velocity(place, 90.0);
    wind.clock.start = 30.0;
    wind.clock.scale = 2.0;
    EXPECT_LT(glm::distance(asField(wind)->velocity(place, 30.0), later), 1e-4f);
    wind.clock.scale = 0.0;
    EXPECT_EQ(asField(wind)->velocity(place, 7.0), asField(wind)->velocity(place, 8.0)) << "frozen";
    Wind adjusted = withGusts(field);
    adjusted.adjustment = {2.0, 0.5f};
    const GustStatistics found(adjusted, place);
    const glm::dvec3 mean(adjusted.adjustment.matrix() * field->velocity(place, 0.0));
    EXPECT_LT(glm::distance(found.mean, mean), 0.02 * glm::length(mean));
    EXPECT_NEAR(found.deviation.x / (0.2 * std::hypot(mean.x, mean.y)), 1.0, 0.1);
    EXPECT_NEAR(found.deviation.y / found.deviation.x, 0.8, 0.08);
}

/// On a globe, gusts keep to the vertical of the forest.
TEST(WindGusts, BlowInTheFramesOfTheForestAndOfAGlobe) {
    const glm::vec3 mean(3.0f, 4.0f, 0.0f);
    const glm::dmat4 onGlobe = glm::translate(glm::dmat4(1.0), {3.7e6, -2.1e6, 4.7e6}) *
                               glm::rotate(glm::dmat4(1.0), 1.1, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
    Wind globe = withGusts(std::make_shared<UniformWind>(glm::vec3(onGlobe * glm::dvec4(mean, 0.0))));
    globe.frame = WindFrame::Geocentric;
    const WindFieldPtr flat = asField(withGusts(std::make_shared<UniformWind>(mean)));
    const LayeredWind there = sampler(globe, onGlobe);
    for (int i = 0; i < 50; ++i) {
        const WindPlace place(7.0f * static_cast<float>(i), -3.0f, 12.0f);
        EXPECT_LT(glm::distance(there.velocity(place, 3.0 * i), flat->velocity(place, 3.0 * i)), 1e-3f) << i;
    }
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), glm::dvec3(50.0, 20.0, 0.0));
    const LayeredWind scene = sampler(withGusts(turning()), moved);
    EXPECT_EQ(scene.velocity({3, 4, 5}, 6.0), asField(withGusts(turning()))->velocity({53, 24, 5}, 6.0));
}

TEST(WindGusts, OfACanopyReplaceThem) {
    auto map = std::make_shared<CanopyMap>();
    map->usual.closure = 1.0f;
    map->usual.profile = CanopyProfile::ofStand(20.0f, 2.0f);
    map->usual.shelter.fill(1.0f);
    map->isUniform = true;
    const LayeredWind weak = inStand(withGusts(turning(), 0.1), *map, 60.0f, 1),
                      strong = inStand(withGusts(turning(), 0.6), *map, 60.0f, 1),
                      none = inStand(turning(), *map, 60.0f, 1);
    for (int i = 0; i < 50; ++i) {
        const WindPlace place(3.0f * static_cast<float>(i), 8.0f, 2.0f + static_cast<float>(i % 30));
        EXPECT_EQ(weak.velocity(place, 3.0 * i), strong.velocity(place, 3.0 * i)) << i;
        EXPECT_NE(weak.velocity(place, 3.0 * i), none.velocity(place, 3.0 * i)) << "slow gusts";
    }
}

TEST(WindGusts, OfInvalidValuesAreProblemsAndNeverNaN) {
    const auto problemOf = [](WindGusts gusts) {
        Wind wind(turning());
        wind.gusts = gusts;
        const glm::vec3 v = asField(wind)->velocity({1, 2, 3}, 4.0);
        EXPECT_TRUE(std::isfinite(v.x + v.y + v.z)) << gusts.intensity << ' ' << gusts.lengthScale;
        const Diagnostics problems = check(wind);
        return problems.empty() ? std::string() : problems.front().text();
    };
    EXPECT_EQ(problemOf({0.2, 40.0, 1}), "");
    EXPECT_EQ(problemOf({-0.1, 40.0, 1}), "wind.intensity: expected a finite number in [0, 1], found -0.1");
    EXPECT_EQ(problemOf({1.5, 40.0, 1}), "wind.intensity: expected a finite number in [0, 1], found 1.5");
    EXPECT_EQ(problemOf({NAN, 40.0, 1}), "wind.intensity: expected a finite number in [0, 1], found nan");
    EXPECT_EQ(problemOf({0.2, 0.0, 1}),
              "wind.length_scale: expected a finite number in [1, 100000], found 0");
    EXPECT_EQ(problemOf({0.2, INFINITY, 1}),
              "wind.length_scale: expected a finite number in [1, 100000], found inf");
}

TEST(WindGusts, AreFiniteOverExcessiveWinds) {
    for (const float speed : {0.0f, 9e3f, 1e30f, 3.4e38f}) {
        const glm::vec3 v =
            asField(withGusts(std::make_shared<UniformWind>(glm::vec3(speed, -speed, speed)), 1.0))
                ->velocity({1, 2, 3}, 1e300);
        EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) << speed;
    }
}

/// WindNinja's grid of 1 km: the mean at its cells is that of the file.
TEST(WindGusts, BlowOverWindNinjasField) {
    REQUIRE_REAL_DATA(speeds, "wind/windninja_pig/198001010100/output/PIG_1000m_vel.asc");
    WindFileOptions options;
    options.origin = {-1500000.0, -60000.0, 0.0};
    options.height = 10.0;
    options.roughness = 0.001; // ice
    const auto file = readWindFile(speeds, options);
    ASSERT_TRUE(file) << firstProblem(file);
    Wind wind = file.value().wind;
    wind.gusts = {0.25, 60.0, 1};
    for (const glm::vec2& place :
         {glm::vec2(0.0f), glm::vec2(900.0f, -20300.0f), glm::vec2(60000.0f, 30000.0f)})
        expectGustsOver(wind, WindPlace(place.x, place.y, 10.0f), 0.25);
}

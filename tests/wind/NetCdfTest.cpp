// SPDX-License-Identifier: MIT
// NetCDF against numbers that ncdump prints; skipped where GDAL was not built in.
#include <osgTreeWind/wind/WindFile.h>

#include "../TestData.h"
#include "../base/FirstProblem.h"
#include "../io/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

namespace osgTreeWind {

namespace {

/// The file, or a null field and a note where NetCDF is not built in.
Result<WindFile> readAt(const std::string& path, const glm::dvec3& origin = glm::dvec3(0.0)) {
    WindFileOptions options;
    options.origin = origin;
    return readWindFile(path, options);
}

bool withoutGdal(const Result<WindFile>& file) {
    return firstProblem(file).find("NetCDF needs GDAL") != std::string::npos;
}

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
}

#define REQUIRE_NETCDF(path)                                                                                 \
    if (withoutGdal(readAt(path)))                                                                           \
    GTEST_SKIP() << "built without GDAL"

struct Spot {
    glm::dvec3 place;
    double time;
    glm::vec3 velocity;
};

} // namespace

/// u = 1 + i at the first time and one more at the second, v = 0 in the southern row and 1 in the northern,
/// w = the layer: small.cdl, with rows from the north and heights 2, 10 and 50 m.
TEST(NetCdf, QesLayoutWithUnevenHeightsTimesAndPacking) {
    const std::string path = std::string(OSGTREEWIND_TEST_DATA) + "/wind/small.nc";
    REQUIRE_NETCDF(path);
    const auto file = readAt(path);
    ASSERT_TRUE(file) << firstProblem(file);
    const WindField& wind = *file.value().field;
    expectNear(wind.velocity({100, 200, 2}, 0), {1, 0, 0}, 1e-6f);
    expectNear(wind.velocity({120, 220, 10}, 3600), {4, 1, 1}, 1e-6f);
    expectNear(wind.velocity({110, 210, 30}, 1800), {2.5f, 0.5f, 1.5f}, 1e-6f);
    EXPECT_EQ(wind.velocity({120, 200, 2}, 0), glm::vec3(0.0f)) << "there are no data";
    EXPECT_EQ(file.value().summary.times, (std::vector<double>{0, 3600}));
    EXPECT_EQ(file.value().summary.start, "6 hours since 2020-01-01");
    EXPECT_EQ(file.value().summary.points, glm::ivec3(3, 2, 3));
}

TEST(NetCdf, SpeedAndDirectionOnAxesInKilometres) {
    REQUIRE_REAL_DATA(path, "wind/ndfd_20170603T1800.nc");
    REQUIRE_NETCDF(path);
    const auto from = [](double speed, double degrees) {
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        return glm::vec3(-speed * std::sin(angle), -speed * std::cos(angle), 0.0);
    };
    for (const Spot& spot : {Spot{{-1640665.53, 2052449.95, 10}, 0, from(4.4375, 154)},
                             Spot{{-1432411.62, 2052449.95, 10}, 0, from(2.5625, 160)},
                             Spot{{-1539078.25, 2179436.52, 0}, 5, from(4.0625, 116)},
                             Spot{{-1432411.62, 2319122.07, 10}, 0, from(4.25, 183)}}) {
        const auto file = readAt(path, spot.place);
        ASSERT_TRUE(file) << firstProblem(file);
        expectNear(file.value().field->velocity({}, spot.time), spot.velocity, 2e-3f);
        EXPECT_EQ(file.value().summary.points, glm::ivec3(83, 106, 1));
        EXPECT_EQ(file.value().summary.unit, "m/s");
        EXPECT_EQ(file.value().summary.low.z, 10.0);
    }
}

TEST(NetCdf, WrfComponentsAreMeansOfTheirNeighbours) {
    REQUIRE_REAL_DATA(path, "wind/ci_test_file.nc");
    REQUIRE_NETCDF(path);
    for (const Spot& spot : {Spot{{0, 0, 30.2112}, 0, {8.878456, 0.126071, -0.000041}},
                             Spot{{470000, 470000, 5642.0566}, 3 * 10800.0, {5.942756, 10.416983, 0.037516}},
                             Spot{{300000, 200000, 697.0188}, 10800.0, {18.463464, -3.894093, -0.045457}}}) {
        const auto file = readAt(path, spot.place);
        ASSERT_TRUE(file) << firstProblem(file);
        expectNear(file.value().field->velocity({}, spot.time), spot.velocity, 1e-4f);
        EXPECT_EQ(file.value().summary.points, glm::ivec3(48, 48, 14));
        EXPECT_EQ(file.value().summary.times, (std::vector<double>{0, 10800, 21600, 32400}));
    }
}

TEST(NetCdf, BrokenFilesAreRefused) {
    REQUIRE_REAL_DATA(path, "wind/ndfd_20170603T1800.nc");
    REQUIRE_NETCDF(path);
    std::ifstream input(path, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(input), {}};
    const TemporaryFolder folder;
    for (std::size_t length : {std::size_t(4), std::size_t(100), std::size_t(3000)})
        EXPECT_FALSE(readAt(folder.write("cut.nc", whole.substr(0, length)))) << "cut at " << length;
    std::mt19937 random(3);
    for (int round = 0; round < 100; ++round) {
        std::string bytes = whole;
        for (int i = 0; i < 4; ++i)
            bytes[random() % 12000] = static_cast<char>(random());
        const auto file = readAt(folder.write("changed.nc", bytes));
        EXPECT_TRUE(file || !file.problems().front().message.empty());
    }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
// NetCDF compared with the output of ncdump; skipped without GDAL.
#include <tests/Folders.h>
#include <tests/windfiles/NetCdfReading.h>

#include <tests/TestData.h>
#include <tests/io/TemporaryFolder.h>

#include <cmath>
#include <tuple>

namespace osgTreeWind {

namespace {

struct Spot {
    glm::dvec3 place;
    double time;
    glm::vec3 velocity;
};

} // namespace

/// u = 1 + i at the first time and one more at the second, v = 0 in the southern row and 1 in the northern,
/// w = the layer: small.cdl, with rows from the north and heights 2, 10 and 50 m.
TEST(NetCdf, ReadsQesLayoutWithUnevenHeightsTimesAndPacking) {
    const std::string path = std::string(OSGTREEWIND_TEST_DATA) + "/wind/small.nc";
    REQUIRE_NETCDF(path);
    const auto file = readAt(path);
    ASSERT_TRUE(file) << firstProblem(file);
    const WindFieldPtr field = asField(file.value().wind);
    const WindField& wind = *field;
    expectNear(wind.velocity({100, 200, 2}, 0), {1, 0, 0}, 1e-6f);
    expectNear(wind.velocity({120, 220, 10}, 3600), {4, 1, 1}, 1e-6f);
    expectNear(wind.velocity({110, 210, 30}, 1800), {2.5f, 0.5f, 1.5f}, 1e-6f);
    EXPECT_EQ(wind.velocity({120, 200, 2}, 0), glm::vec3(0.0f)) << "missing data";
    EXPECT_EQ(file.value().summary.times, (std::vector<double>{0, 3600}));
    EXPECT_EQ(file.value().summary.start, "2020-01-01T06:00:00Z");
    EXPECT_EQ(file.value().summary.points, glm::ivec3(3, 2, 3));
}

/// Velocities in the file are relative to true north, which is n (longitude - 95 W) to the left of the y axis
/// of its projection, Lambert around 25 N and 95 W on a sphere of 6371.2 km.
TEST(NetCdf, ReadsSpeedAndDirectionOnAxesInKilometres) {
    REQUIRE_REAL_DATA(path, "wind/ndfd_20170603T1800.nc");
    REQUIRE_NETCDF(path);
    const double degree = 3.14159265358979323846 / 180.0;
    const auto from = [&](double x, double y, double speed, double degrees) {
        const double convergence = std::atan2(x, 6371200.0 / std::tan(25.0 * degree) - y);
        const double angle = degrees * degree - convergence;
        return Spot{{x, y, 10}, 0, glm::vec3(-speed * std::sin(angle), -speed * std::cos(angle), 0.0)};
    };
    for (const Spot& spot :
         {from(-1640665.53, 2052449.95, 4.4375, 154), from(-1432411.62, 2052449.95, 2.5625, 160),
          from(-1539078.25, 2179436.52, 4.0625, 116), from(-1432411.62, 2319122.07, 4.25, 183)}) {
        const auto file = readAt(path, spot.place);
        ASSERT_TRUE(file) << firstProblem(file);
        expectNear(asField(file.value().wind)->velocity({}, spot.time), spot.velocity, 2e-3f);
        EXPECT_EQ(file.value().summary.points, glm::ivec3(83, 106, 1));
        EXPECT_EQ(file.value().summary.unit, "m/s");
        EXPECT_EQ(file.value().summary.low.z, 10.0);
        EXPECT_EQ(file.value().summary.direction, "from, degrees clockwise from true north");
        EXPECT_NE(file.value().summary.coordinates.find("+proj=lcc +lat_1=25"), std::string::npos);
        EXPECT_TRUE(hasNote(file.value().summary, "they are turned to the grid's y axis, by 7.03 to "
                                                  "8.23 degrees clockwise"));
    }
}

/// The same cells, with speeds and directions from ncdump.
TEST(NetCdf, ReadsSpeedAndDirectionAsStored) {
    REQUIRE_REAL_DATA(path, "wind/ndfd_20170603T1800.nc");
    REQUIRE_NETCDF(path);
    for (const auto& [x, y, speed, degrees] : {std::tuple{-1640665.53, 2052449.95, 4.4375, 154.0},
                                               {-1432411.62, 2052449.95, 2.5625, 160.0},
                                               {-1539078.25, 2179436.52, 4.0625, 116.0},
                                               {-1432411.62, 2319122.07, 4.25, 183.0}}) {
        const auto file = readAt(path, {x, y, 10}, true);
        ASSERT_TRUE(file) << firstProblem(file);
        const double angle = degrees * 3.14159265358979323846 / 180.0;
        expectNear(asField(file.value().wind)->velocity({}, 0),
                   {-speed * std::sin(angle), -speed * std::cos(angle), 0}, 2e-3f);
        EXPECT_TRUE(
            hasNote(file.value().summary,
                    "velocities in the file are relative to true north; in a forest they are turned to the "
                    "grid's y axis, by 7.03 to 8.23 degrees clockwise"));
    }
}

TEST(NetCdf, RefusesBrokenFiles) {
    REQUIRE_REAL_DATA(path, "wind/ndfd_20170603T1800.nc");
    REQUIRE_NETCDF(path);
    const std::string whole = fileBytes(path);
    const TemporaryFolder folder;
    for (std::size_t length : {std::size_t(4), std::size_t(100), std::size_t(3000)})
        EXPECT_FALSE(readAt(folder.write("cut.nc", whole.substr(0, length)))) << "cut at " << length;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
// WRF output in its projection, compared with closed forms of the projection and the output of ncdump.
#include <tests/windfiles/NetCdfReading.h>

#include <tests/TestData.h>
#include <tests/io/TemporaryFolder.h>

#include <cmath>
#include <tuple>

namespace osgTreeWind {

namespace {

const std::string lambertFile = smallNetCdf("wrf_lambert.nc"), polarFile = smallNetCdf("wrf_polar.nc");

glm::vec3 windAt(const std::string& path, const glm::dvec3& place, double time) {
    const auto file = readAt(path, place);
    EXPECT_TRUE(file) << firstProblem(file);
    return file ? asField(file.value().wind)->velocity({}, time) : glm::vec3(-999.0f);
}

/// wrf_polar.nc with other dimensions of an array, numbered as in make_wrf.py: 0 is Time, 2 the two levels, 3
/// the rows, 5 the columns. The array must not become larger.
std::string withDimensions(std::string bytes, const std::string& array, const std::vector<int>& dimensions) {
    const std::size_t data = bytes.size() - 128 * 4,
                      at = bytes.find(std::string("\0\0\0", 3) + static_cast<char>(array.size()) + array);
    std::string list;
    for (int number : dimensions)
        list += std::string("\0\0\0", 3) + static_cast<char>(number);
    const std::size_t count = at + 4 + (array.size() + 3) / 4 * 4; // offset of the number of dimensions, 3
    EXPECT_EQ(bytes.substr(count, 4), std::string("\0\0\0\3", 4)) << array;
    bytes.insert(data, std::string(12 - list.size(), '\0')); // keeps the offsets of the data
    bytes[count + 3] = static_cast<char>(dimensions.size());
    return bytes.replace(count + 4, 12, list);
}

/// A cell of ci_test_file.nc: means of the staggered neighbours from ncdump.
struct Cell {
    double time, longitude, latitude, height;
    glm::vec3 velocity;
};

} // namespace

TEST(NetCdfWrf, VariableNamesTheComponents) {
    REQUIRE_NETCDF(polarFile);
    WindFileOptions options;
    options.asStored = true;
    options.variable = {"U", "V"};
    const auto named = readWindFile(polarFile, options);
    ASSERT_TRUE(named) << firstProblem(named);
    EXPECT_EQ(named.value().summary.points, readAt(polarFile, {}, true).value().summary.points);
    options.variable = {"U", "W"};
    EXPECT_EQ(firstProblem(readWindFile(polarFile, options)),
              polarFile + ": expected wind.variable = \"U\" or \"U10\" for WRF output, found 'W'");
    options.variable = {"U10"};
    EXPECT_EQ(firstProblem(readWindFile(polarFile, options)),
              polarFile + ": U10: expected this array of 3 dimensions in WRF output");
}

/// The projection is Mercator around 89 W on a sphere of 6370 km; the grid moves with a storm.
TEST(NetCdfWrf, CellsAreAtTheirLatitudesAndLongitudes) {
    REQUIRE_REAL_DATA(path, "wind/ci_test_file.nc");
    REQUIRE_NETCDF(path);
    const double degree = 3.14159265358979323846 / 180.0, radius = 6370000.0;
    const Cell cells[] = {
        {0, -91.6534042, 21.8039494, 30.2112, {8.878456, 0.126071, -0.000041}},
        {10800, -89.4947052, 23.7115364, 332.6069, {17.369737, -2.091266, -0.030965}},
        {21600, -88.2354584, 23.3817062, 1315.0068, {17.955265, 10.065489, 0.003610}},
        {32400, -89.4047546, 24.4505901, 5581.7466, {21.127940, -1.796586, 0.094829}},
    };
    for (const Cell& cell : cells) {
        const glm::dvec2 place(radius * (cell.longitude + 89.0) * degree,
                               radius * std::log(std::tan((45.0 + 0.5 * cell.latitude) * degree)));
        const auto file = readAt(path, {place, 0.0});
        ASSERT_TRUE(file) << firstProblem(file);
        const WindSummary& summary = file.value().summary;
        const glm::dvec2 index = (place - glm::dvec2(summary.low)) / 10000.0;
        EXPECT_LT(std::abs(index.x - std::round(index.x)), 1e-3) << "of a cell";
        EXPECT_LT(std::abs(index.y - std::round(index.y)), 1e-3) << "of a cell";
        // The wind changes by several m/s between cells, so that 1e-3 of a cell is negligible.
        // Heights are above the terrain, which is sea here.
        expectNear(asField(file.value().wind)->velocity({0, 0, static_cast<float>(cell.height)}, cell.time),
                   cell.velocity, 1e-2f);
        EXPECT_EQ(summary.points, glm::ivec3(48, 48, 14));
        EXPECT_EQ(summary.times, (std::vector<double>{0, 10800, 21600, 32400}));
        EXPECT_EQ(summary.coordinates, "+proj=merc +lat_ts=0 +lon_0=-89 +R=6370000");
        EXPECT_TRUE(hasNote(summary, "the model's grid moves"));
    }
}

/// In the small files of make_wrf.py u is the column and v the row of a cell, both 100 more after an hour.
TEST(NetCdfWrf, PlacesALambertGrid) {
    REQUIRE_NETCDF(lambertFile);
    expectNear(windAt(lambertFile, {-500000, 20000, 10}, 0), {0, 0, 0}, 1e-3f);
    expectNear(windAt(lambertFile, {-473000, 38000, 10}, 0), {3, 2, 0}, 1e-3f);
    const WindSummary summary = readAt(lambertFile).value().summary;
    EXPECT_EQ(summary.coordinates, "+proj=lcc +lat_1=30 +lat_2=60 +lat_0=45 +lon_0=10 +R=6370000");
    EXPECT_EQ(summary.direction, "components toward x, y and up of the model's grid");
}

TEST(NetCdfWrf, PlacesWindOfAMovingGrid) {
    REQUIRE_NETCDF(lambertFile); // moves one cell east and two north
    expectNear(windAt(lambertFile, {-482000, 38000, 10}, 3600), {101, 100, 0}, 1e-3f);
    expectNear(windAt(lambertFile, {-473000, 38000, 10}, 3600), {102, 100, 0}, 1e-3f);
    expectNear(windAt(lambertFile, {-500000, 20000, 10}, 3600), {100, 100, 0}, 1e-3f);
}

TEST(NetCdfWrf, MovingGridIsFixedAsStored) {
    REQUIRE_NETCDF(lambertFile);
    const auto file = readAt(lambertFile, {-473000, 38000, 10}, true);
    ASSERT_TRUE(file) << firstProblem(file);
    expectNear(asField(file.value().wind)->velocity({}, 3600), {103, 102, 0}, 1e-3f);
    EXPECT_TRUE(hasNote(file.value().summary, "in a forest they are placed where they blew"));
    EXPECT_FALSE(hasNote(file.value().summary, "edges held"));
}

/// Means of the staggered neighbours of one time and cell, from ncdump.
TEST(NetCdfWrf, CellsOfAllTimesAreThoseOfTheFileAsStored) {
    REQUIRE_REAL_DATA(path, "wind/ci_test_file.nc");
    REQUIRE_NETCDF(path);
    const glm::dvec2 corner(readAt(path).value().summary.low);
    for (const auto& [time, cell, height, velocity] :
         {std::tuple{10800.0, glm::dvec2(0, 0), 30.1937, glm::vec3(8.492837, -3.194436, 0.000624)},
          {21600.0, {31, 20}, 333.0792, {20.262849, -2.727398, -0.010895}},
          {32400.0, {5, 47}, 1318.1066, {-4.531000, -19.213836, -0.034763}},
          {32400.0, {12, 30}, 30.4217, {9.727924, -11.523107, -0.001528}}}) {
        const auto file = readAt(path, {corner + 10000.0 * cell, 0.0}, true);
        ASSERT_TRUE(file) << firstProblem(file);
        expectNear(asField(file.value().wind)->velocity({0, 0, static_cast<float>(height)}, time), velocity,
                   2e-3f);
    }
}

TEST(NetCdfWrf, PlacesAPolarGrid) {
    REQUIRE_NETCDF(polarFile);
    expectNear(windAt(polarFile, {-300000, 1200000, 10}, 0), {0, 0, 0}, 1e-3f);
    expectNear(windAt(polarFile, {-273000, 1218000, 10}, 0), {3, 2, 0}, 1e-3f);
    const WindSummary summary = readAt(polarFile).value().summary;
    EXPECT_EQ(summary.coordinates, "+proj=stere +lat_0=-90 +lat_ts=-70 +lon_0=10 +R=6370000");
    EXPECT_FALSE(hasNote(summary, "moves"));
}

TEST(NetCdfWrf, LatitudeOrLongitudeMayBeConstantInTime) {
    REQUIRE_NETCDF(polarFile);
    const TemporaryFolder folder;
    for (const char* array : {"XLAT", "XLONG"}) {
        const std::string path = folder.write("a.nc", withDimensions(fileBytes(polarFile), array, {3, 5}));
        expectNear(windAt(path, {-273000, 1218000, 10}, 0), {3, 2, 0}, 1e-3f);
    }
}

TEST(NetCdfWrf, UnknownProjectionsAreRelativeToTheCorner) {
    REQUIRE_NETCDF(polarFile);
    const TemporaryFolder folder;
    const std::string bytes = fileBytes(polarFile);
    const std::pair<std::string, const char*> cases[] = {
        {renamed(bytes, "MAP_PROJ", "MAP_PORJ"), "has no supported projection"},
        {renamed(bytes, "STAND_LON", "STAND_LAT"), "has no supported projection"},
        {withAttribute(bytes, "MAP_PROJ", 6), "has no supported projection"},
        {withAttribute(bytes, "MAP_PROJ", 3), "XLAT and XLONG do not match the projection"},
        {renamed(bytes, "XLONG", "XLANG"), "XLAT and XLONG do not match the projection"},
        {withDimensions(bytes, "XLAT", {0}), "XLAT and XLONG do not match the projection"},
        {withDimensions(bytes, "XLONG", {3}), "XLAT and XLONG do not match the projection"},
        {withDimensions(bytes, "XLAT", {0, 3, 2}), "XLAT and XLONG do not match the projection"},
        {withDimensions(bytes, "XLAT", {5, 3}), "XLAT and XLONG do not match the projection"}};
    for (const auto& [changed, note] : cases) {
        const std::string path = folder.write("a.nc", changed);
        expectNear(windAt(path, {27000, 18000, 10}, 0), {3, 2, 0}, 1e-4f);
        const WindSummary summary = readAt(path).value().summary;
        EXPECT_EQ(summary.coordinates, "");
        EXPECT_TRUE(hasNote(summary, note)) << note;
        EXPECT_TRUE(hasNote(summary, "x and y are metres from the centre of the south-western cell"));
    }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
// Wind in longitude and latitude, as written by ECMWF and others.
#include <tests/windfiles/NetCdfWriting.h>

#include <osgTreeWind/places/Crs.h>

#include <glm/trigonometric.hpp>

namespace osgTreeWind {

namespace {

/// Like ERA5 until 2024: packed with a negative scale, latitudes from the north in 32-bit floats. u is the
/// longitude / 10 and v the latitude / 10, both 1 more at the second time.
void writePacked(const std::string& path, const Numbers& longitudes, const Numbers& latitudes) {
    const double scale = -0.0011, offset = 3.0;
    NetCdfWriter file(path);
    file.axis("longitude", longitudes, "degrees_east", {}, NC_FLOAT)
        .axis("latitude", latitudes, "degrees_north", {}, NC_FLOAT)
        .axis("time", {1034160, 1034161}, "hours since 1900-01-01 00:00:00.0", {{"calendar", "gregorian"}},
              NC_INT);
    const NetCdfAttributes packing = {{"units", "m s**-1"},
                                      {"scale_factor", scale},
                                      {"add_offset", offset},
                                      {"_FillValue", -32767.0},
                                      {"missing_value", -32767.0}};
    for (const bool isU : {true, false}) {
        Numbers numbers =
            packed(valuesOver({0, 1}, latitudes, longitudes,
                              [&](double t, double y, double x) { return t + (isU ? x : y) / 10.0; }),
                   scale, offset);
        numbers[1] = isU ? -32767.0 : numbers[1]; // north-western row, second column, first time
        file.array(isU ? "u10" : "v10", {"time", "latitude", "longitude"}, packing, numbers, NC_SHORT);
    }
}

/// Writes a component of the wind, as DWD and ERA5 serve it, or its speed or direction; everywhere the same.
void writeComponent(const std::string& path, const std::string& name, double value,
                    const std::string& unit = "m s**-1") {
    const Numbers longitudes = numbersFrom(9.0, 0.25, 4), latitudes = numbersFrom(50.5, -0.25, 3);
    NetCdfWriter(path)
        .axis("longitude", longitudes, "degrees_east")
        .axis("latitude", latitudes, "degrees_north")
        .array(name, {"latitude", "longitude"}, {{"units", unit}},
               valuesOver(latitudes, longitudes, [&](double, double) { return value; }));
}

/// u is the longitude and v the latitude, in m/s, -180 to 180.
double within180(double longitude) {
    return longitude - 360.0 * std::round(longitude / 360.0);
}

void writeGlobe(const std::string& path, double west) {
    const Numbers longitudes = numbersFrom(west, 2.5, 144), latitudes = numbersFrom(90.0, -2.5, 73);
    NetCdfWriter file(path);
    file.axis("lon", longitudes, "degrees_east", {}, NC_FLOAT)
        .axis("lat", latitudes, "degrees_north", {}, NC_FLOAT)
        .array("u", {"lat", "lon"}, metresPerSecond,
               valuesOver(latitudes, longitudes, [](double, double x) { return within180(x); }), NC_FLOAT)
        .array("v", {"lat", "lon"}, metresPerSecond,
               valuesOver(latitudes, longitudes, [](double y, double) { return y; }), NC_FLOAT);
}

/// Expects that each point of a window has the wind of its longitude and latitude.
void expectOwnWind(const GridWind::Grid& grid) {
    for (int y = 0; y < grid.points.y; ++y)
        for (int x = 0; x < grid.points.x; ++x) {
            const glm::vec3 velocity = velocityAt(grid, 0, 0, y, x);
            const double east = within180(grid.origin.x + x * grid.cell.x);
            EXPECT_NEAR(std::cos(glm::radians(double(velocity.x))), std::cos(glm::radians(east)), 1e-6);
            EXPECT_NEAR(std::sin(glm::radians(double(velocity.x))), std::sin(glm::radians(east)), 1e-6);
            EXPECT_NEAR(velocity.y, grid.origin.y + y * grid.cell.y, 1e-4);
        }
}

/// The rotated pole of CORDEX for Europe; u is eastward_wind if `eastward`.
void writeRotated(const std::string& path, bool eastward, const std::string& mapping = "rotated_pole") {
    const Numbers longitudes = numbersFrom(-10, 5, 5), latitudes = numbersFrom(-5, 5, 3);
    const std::string u = eastward ? "eastward_wind" : "grid_eastward_wind",
                      v = eastward ? "northward_wind" : "grid_northward_wind";
    NetCdfWriter(path)
        .axis("rlon", longitudes, "degrees", {{"standard_name", "grid_longitude"}, {"axis", "X"}})
        .axis("rlat", latitudes, "degrees", {{"standard_name", "grid_latitude"}, {"axis", "Y"}})
        .array("rotated_pole", {},
               {{"grid_mapping_name", "rotated_latitude_longitude"},
                {"grid_north_pole_latitude", 39.25},
                {"grid_north_pole_longitude", -162.0}},
               {0}, NC_INT)
        .array("uas", {"rlat", "rlon"}, {{"units", "m s-1"}, {"standard_name", u}, {"grid_mapping", mapping}},
               Numbers(15, 10.0), NC_FLOAT)
        .array("vas", {"rlat", "rlon"}, {{"units", "m s-1"}, {"standard_name", v}, {"grid_mapping", mapping}},
               Numbers(15, 0.0), NC_FLOAT);
}

} // namespace

TEST(NetCdfDegrees, ReadsPackedShortsFromTheNorthLikeEra5) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/era5.nc";
    writePacked(path, numbersFrom(11, 0.25, 5), numbersFrom(48.5, -0.25, 4));
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_EQ(grid.points, glm::ivec3(5, 4, 1));
    EXPECT_EQ(grid.origin, glm::dvec3(11, 47.75, 0));
    EXPECT_EQ(grid.cell, glm::dvec3(0.25, 0.25, 1));
    EXPECT_EQ(grid.times, (Numbers{0, 3600}));
    EXPECT_EQ(grid.heights, std::vector<float>{10.0f});
    EXPECT_TRUE(grid.aboveGround);
    expectNear(velocityAt(grid, 0, 0, 0, 0), {1.1f, 4.775f, 0}, 6e-4f);
    expectNear(velocityAt(grid, 0, 0, 3, 4), {1.2f, 4.85f, 0}, 6e-4f);
    expectNear(velocityAt(grid, 1, 0, 1, 2), {2.15f, 5.8f, 0}, 6e-4f);
    EXPECT_TRUE(std::isnan(velocityAt(grid, 0, 0, 3, 1).x)) << "missing data";
    const WindSummary summary = summaryOf(path);
    EXPECT_EQ(summary.crs, "EPSG:4326");
    EXPECT_EQ(summary.coordinates, "WGS 84");
    EXPECT_EQ(summary.unit, "m/s");
    EXPECT_EQ(summary.start, "2017-12-23T00:00:00Z");
    EXPECT_TRUE(summary.notes.empty());
}

/// GDAL would treat a fill value of NaN as packed 0, which is valid wind.
TEST(NetCdfDegrees, IgnoresAFillValueOfNaNForPackedNumbers) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/nan.nc";
    {
        NetCdfWriter file(path, NC_NETCDF4);
        file.axis("lon", {1, 2}, "degrees_east").axis("lat", {1, 2}, "degrees_north");
        const NetCdfAttributes packing = {{"units", "m/s"}, {"scale_factor", 0.5}, {"add_offset", 4.0}};
        file.array("u", {"lat", "lon"}, packing, {0, 1, 2, 3}, NC_SHORT)
            .array("v", {"lat", "lon"}, packing, {0, 0, 0, 0}, NC_SHORT);
    }
    REQUIRE_NETCDF(path);
    expectNear(velocityAt(gridOf(path), 0, 0, 0, 0), {4, 4, 0}, 1e-6f);
    // The classic library allows a fill value of another type.
    const std::string classic = folder.path() + "/classic.nc";
    {
        NetCdfWriter file(classic);
        file.axis("lon", {1, 2}, "degrees_east").axis("lat", {1, 2}, "degrees_north");
        const NetCdfAttributes packing = {
            {"units", "m/s"}, {"scale_factor", 0.5}, {"_FillVolue", std::nan("")}, {"add_offset", 4.0}};
        file.array("u", {"lat", "lon"}, packing, {0, 1, 2, 3}, NC_SHORT)
            .array("v", {"lat", "lon"}, packing, {0, 0, 0, 0}, NC_SHORT);
    }
    const std::string marked =
        folder.write("marked.nc", renamed(fileBytes(classic), "_FillVolue", "_FillValue"));
    const GridWind::Grid grid = gridOf(marked);
    expectNear(velocityAt(grid, 0, 0, 0, 0), {4, 4, 0}, 1e-6f);
    expectNear(velocityAt(grid, 0, 0, 1, 1), {5.5f, 4, 0}, 1e-6f);
}

TEST(NetCdfDegrees, ReadsTenAndHundredMetresAsTwoLayers) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/new.nc";
    {
        NetCdfWriter file(path, NC_NETCDF4);
        file.axis("valid_time", {1709251200, 1709254800, 1709258400}, "seconds since 1970-01-01",
                  {{"calendar", "proleptic_gregorian"}, {"standard_name", "time"}}, NC_INT64)
            .axis("latitude", {1, 0}, "degrees_north")
            .axis("longitude", {20, 21}, "degrees_east")
            .array("number", {}, {{"units", "1"}}, {0}, NC_INT64);
        for (const auto& [name, value] : {std::pair{"u100", 8.0}, {"v100", -1.0}, {"u10", 5.0}, {"v10", 2.0}})
            file.array(name, {"valid_time", "latitude", "longitude"},
                       {{"units", "m s**-1"},
                        {"standard_name", name[0] == 'u' ? "eastward_wind" : "northward_wind"},
                        {"coordinates", "number valid_time latitude longitude expver"}},
                       Numbers(12, value), NC_FLOAT);
    }
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_EQ(grid.points, glm::ivec3(2, 2, 2));
    EXPECT_EQ(grid.heights, (std::vector<float>{10, 100}));
    EXPECT_TRUE(grid.aboveGround);
    EXPECT_EQ(grid.times, (Numbers{0, 3600, 7200}));
    for (int t = 0; t < 3; ++t) {
        EXPECT_EQ(velocityAt(grid, t, 0, 1, 1), glm::vec3(5, 2, 0));
        EXPECT_EQ(velocityAt(grid, t, 1, 0, 1), glm::vec3(8, -1, 0));
    }
    EXPECT_EQ(summaryOf(path).start, "2024-03-01T00:00:00Z");
    EXPECT_TRUE(summaryOf(path).notes.empty());
    // 50 m above ground is between the layers.
    WindFileOptions options;
    options.crs = "EPSG:32634";
    options.origin = {444000, 55000, 300}; // 20.5 E, 0.5 N, where true north is grid north
    const auto file = readWindFile(path, options);
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_NEAR(asField(file.value().wind)->velocity(WindPlace({0, 0, 850}, 800), 0).x, 5 + 3 * 40.0 / 90,
                1e-3);
}

TEST(NetCdfDegrees, PrefersFinalToPreliminaryData) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/expver.nc";
    {
        NetCdfWriter file(path);
        file.axis("longitude", {1, 2}, "degrees_east")
            .axis("latitude", {1, 2}, "degrees_north")
            .axis("expver", {1, 5}, "")
            .axis("time", {0, 1}, "hours since 1900-01-01");
        const NetCdfAttributes marked = {{"units", "m/s"}, {"_FillValue", -99.0}};
        const Numbers numbers = {1, 1, 1, 1, -99, -99, -99, -99, -99, -99, -99, -99, 5, 5, 5, 5};
        file.array("u10", {"time", "expver", "latitude", "longitude"}, marked, numbers, NC_FLOAT)
            .array("v10", {"time", "expver", "latitude", "longitude"}, marked, numbers, NC_FLOAT);
    }
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_EQ(velocityAt(grid, 0, 0, 0, 0), glm::vec3(1, 1, 0));
    EXPECT_EQ(velocityAt(grid, 1, 0, 1, 1), glm::vec3(5, 5, 0));
}

TEST(NetCdfDegrees, RecognizesNamesWithHeights) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/names.nc";
    for (const auto& [u, v, height] : {std::tuple{"U10M", "V10M", 10.0f},
                                       {"u_50m", "v_50m", 50.0f},
                                       {"10u", "10v", 10.0f},
                                       {"100u", "100v", 100.0f},
                                       {"uas", "vas", 10.0f}}) {
        NetCdfWriter(path)
            .axis("lon", {1, 2}, "degrees_east")
            .axis("lat", {1, 2}, "degrees_north")
            .array(u, {"lat", "lon"}, metresPerSecond, {1, 2, 3, 4})
            .array(v, {"lat", "lon"}, metresPerSecond, {5, 6, 7, 8});
        REQUIRE_NETCDF(path);
        const GridWind::Grid grid = gridOf(path);
        EXPECT_EQ(grid.heights, std::vector<float>{height}) << u;
        EXPECT_EQ(velocityAt(grid, 0, 0, 1, 0), glm::vec3(3, 7, 0)) << u;
    }
}

TEST(NetCdfDegrees, ScalarHeightIsAboveGround) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/height.nc";
    NetCdfWriter(path)
        .axis("lon", {1, 2}, "degrees_east")
        .axis("lat", {1, 2}, "degrees_north")
        .array("lev_2", {}, {{"units", "m"}, {"standard_name", "height"}}, {2})
        .array("ua", {"lat", "lon"}, {{"units", "m/s"}, {"coordinates", "time lev_2"}}, {1, 2, 3, 4})
        .array("va", {"lat", "lon"}, metresPerSecond, {5, 6, 7, 8});
    REQUIRE_NETCDF(path);
    EXPECT_EQ(gridOf(path).heights, std::vector<float>{2.0f});
    EXPECT_TRUE(gridOf(path).aboveGround);
}

TEST(NetCdfDegrees, ReadsAWindowAcrossTheSeam) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/globe.nc";
    for (const double west : {0.0, -180.0}) {
        writeGlobe(path, west);
        REQUIRE_NETCDF(path);
        for (const double middle : {0.0, 12.0, 179.0, -179.0, 181.0, 358.0}) {
            const GridWind::Grid grid =
                gridOf(path, WindArea{"EPSG:4326", {middle - 2, 46}, {middle + 2, 48}});
            EXPECT_LE(grid.points.x, 6) << west << " " << middle;
            EXPECT_LE(grid.origin.x, middle - 2);
            EXPECT_GE(grid.origin.x + grid.cell.x * (grid.points.x - 1), middle + 2);
            EXPECT_LE(grid.origin.y, 46);
            EXPECT_LE(grid.points.y, 5);
            expectOwnWind(grid);
        }
    }
}

TEST(NetCdfDegrees, LongitudesMayCrossTheSeamWithinTheArray) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/fiji.nc";
    const Numbers longitudes = {178, 179, -180, -179}, latitudes = {-18, -17};
    NetCdfWriter(path)
        .axis("lon", longitudes, "degrees_east")
        .axis("lat", latitudes, "degrees_north")
        .array("u", {"lat", "lon"}, metresPerSecond,
               valuesOver(latitudes, longitudes, [](double, double x) { return x; }))
        .array("v", {"lat", "lon"}, metresPerSecond,
               valuesOver(latitudes, longitudes, [](double y, double) { return y; }));
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_EQ(grid.origin.x, 178);
    EXPECT_EQ(grid.cell.x, 1);
    EXPECT_EQ(velocityAt(grid, 0, 0, 0, 2), glm::vec3(-180, -18, 0));
}

TEST(NetCdfDegrees, DimensionsMayBeInAnyOrder) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/order.nc";
    const Numbers longitudes = {1, 2, 3}, latitudes = {50, 51};
    NetCdfWriter(path)
        .axis("lon", longitudes, "degrees_east")
        .axis("lat", latitudes, "degrees_north")
        .array("u", {"lon", "lat"}, metresPerSecond,
               valuesOver(longitudes, latitudes, [](double x, double) { return x; }))
        .array("v", {"lat", "lon"}, metresPerSecond,
               valuesOver(latitudes, longitudes, [](double y, double) { return y; }));
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_EQ(grid.points, glm::ivec3(3, 2, 1));
    EXPECT_EQ(velocityAt(grid, 0, 0, 1, 2), glm::vec3(3, 51, 0));
}

/// True north in rotated coordinates: the great circle to the true pole at longitude 0, latitude 39.25.
TEST(NetCdfDegrees, TurnsEastwardWindOfARotatedPole) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/rotated.nc";
    writeRotated(path, true);
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    for (const glm::ivec2 at : {glm::ivec2(0, 0), {4, 2}, {2, 1}, {1, 2}}) {
        const double longitude = glm::radians(-10.0 + 5.0 * at.x), latitude = glm::radians(-5.0 + 5.0 * at.y),
                     pole = glm::radians(39.25);
        const double north = std::atan2(std::sin(-longitude) * std::cos(pole),
                                        std::cos(latitude) * std::sin(pole) -
                                            std::sin(latitude) * std::cos(pole) * std::cos(longitude));
        expectNear(velocityAt(grid, 0, 0, at.y, at.x), {10 * std::cos(north), -10 * std::sin(north), 0},
                   2e-3f);
    }
    const Result<Crs> crs = Crs::parse(summaryOf(path).crs);
    ASSERT_TRUE(crs) << firstProblem(crs);
    EXPECT_TRUE(crs.value().isDegrees());
    EXPECT_TRUE(hasNote(summaryOf(path), "turned to the grid's y axis"));
}

TEST(NetCdfDegrees, FindsAnAreaOfARotatedPoleWithoutTurningGridWind) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/rotated.nc";
    writeRotated(path, false);
    REQUIRE_NETCDF(path);
    // The rotated place 0, 0 is 18 E 50.75 N.
    const GridWind::Grid grid = gridOf(path, WindArea{"EPSG:4326", {17.9, 50.7}, {18.1, 50.8}});
    EXPECT_EQ(grid.origin, glm::dvec3(-10, -5, 0));
    EXPECT_EQ(grid.points, glm::ivec3(5, 3, 1));
    EXPECT_EQ(velocityAt(grid, 0, 0, 0, 0), glm::vec3(10, 0, 0));
}

TEST(NetCdfDegrees, ReadsTheFirstMemberOrMonthWithANote) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/month.nc";
    NetCdfWriter(path)
        .axis("lon", {1, 2}, "degrees_east")
        .axis("lat", {1, 2}, "degrees_north")
        .axis("month", {1, 7}, "")
        .array("u", {"month", "lat", "lon"}, metresPerSecond, {1, 2, 3, 4, 5, 6, 7, 8})
        .array("v", {"month", "lat", "lon"}, metresPerSecond, {1, 2, 3, 4, 5, 6, 7, 8});
    REQUIRE_NETCDF(path);
    EXPECT_EQ(gridOf(path).values.size(), 12u);
    EXPECT_EQ(velocityAt(gridOf(path), 0, 0, 1, 1), glm::vec3(4, 4, 0));
    EXPECT_TRUE(hasNote(summaryOf(path), "only the first of 2 along month"));
}

TEST(NetCdfDegrees, TakesOneComponentOfEachFile) {
    const TemporaryFolder folder;
    const std::string u = folder.path() + "/u.nc", v = folder.path() + "/v.nc",
                      speed = folder.path() + "/speed.nc", direction = folder.path() + "/direction.nc";
    writeComponent(u, "u10", 3.0);
    writeComponent(v, "v10", -1.5);
    writeComponent(speed, "wind_speed", std::hypot(3.0, 1.5));
    writeComponent(direction, "wind_from_direction", glm::degrees(std::atan2(-3.0, 1.5)), "degree");
    WindFileOptions options;
    options.asStored = true;
    for (const auto& files : {std::vector{u, v}, {v, u}, {speed, direction}, {direction, speed}}) {
        const auto wind = readWindFiles(files, {}, options);
        ASSERT_TRUE(wind) << firstProblem(wind);
        const glm::vec3 velocity = asField(wind.value().wind)->velocity({9.3f, 50.2f, 10.0f}, 0.0);
        EXPECT_NEAR(velocity.x, 3.0f, 1e-5f);
        EXPECT_NEAR(velocity.y, -1.5f, 1e-5f);
        EXPECT_EQ(wind.value().summary.notes.back(), "components are read from pairs of files");
    }
    EXPECT_FALSE(readWindFiles({u, u}, {}, options)) << "the same component twice";
}

TEST(NetCdfDegrees, UnitsAreSpelledInManyWays) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/a.nc";
    for (const auto& [unit, speed] : {std::pair("m.s-1", 36.0),
                                      {"meter second-1", 36.0},
                                      {"kmh", 10.0},
                                      {"cm/s", 0.36},
                                      {"furlongs", -1.0}}) {
        const Numbers axis = numbersFrom(0.0, 100.0, 3);
        NetCdfWriter(path)
            .axis("x", axis, "m")
            .axis("y", axis, "m")
            .array("u", {"y", "x"}, {{"units", unit}}, Numbers(9, 36.0))
            .array("v", {"y", "x"}, {{"units", unit}}, Numbers(9, 36.0));
        REQUIRE_NETCDF(path);
        WindFileOptions options;
        const auto wind = readWindFile(path, options);
        if (speed > 0.0) {
            ASSERT_TRUE(wind) << unit << firstProblem(wind);
            EXPECT_NEAR(wind.value().summary.fastest, speed * std::sqrt(2.0), 1e-5) << unit;
        } else
            EXPECT_NE(firstProblem(wind).find("found 'furlongs'; speed_unit replaces it"), std::string::npos)
                << firstProblem(wind);
        options.speedUnit = "kn";
        const auto asked = readWindFile(path, options);
        ASSERT_TRUE(asked) << firstProblem(asked);
        EXPECT_NEAR(asked.value().summary.fastest, 36.0 * std::sqrt(2.0) * 1852.0 / 3600.0, 1e-5);
        EXPECT_TRUE(hasNote(asked.value().summary, "speed_unit, kn, replaces the unit of the file"));
    }
}

} // namespace osgTreeWind

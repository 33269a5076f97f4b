// SPDX-License-Identifier: MIT
// Staggered components on cell faces, as written by PALM and other models.
#include <tests/windfiles/NetCdfWriting.h>

namespace osgTreeWind {

namespace {

/// Linear in every direction, so that means of neighbours are exact.
double eastOf(double z, double y, double x) {
    return 0.05 * x - 0.02 * y + 0.01 * z + 1.0;
}
double northOf(double z, double y, double x) {
    return 0.03 * y + 0.01 * x - 0.02 * z;
}
double upOf(double z, double y, double x) {
    return 0.004 * z + 0.001 * x - 0.002 * y;
}

/// Axes of a PALM run of 6 x 5 x 4 cells of 10 m, upper layers stretched.
struct Palm {
    Numbers x = numbersFrom(5, 10, 6), xu = numbersFrom(0, 10, 6), y = numbersFrom(5, 10, 5),
            yv = numbersFrom(0, 10, 5), zu = {-5, 5, 15, 26}, zw = {0, 10, 20, 32};
    std::string ofV = "x"; ///< The axis of v east.
    double building = 0.0; ///< u, v and w of the first cells are this, unless 0.
};

void writePalm(const std::string& path, const Palm& palm) {
    NetCdfWriter file(path);
    file.axis("time", {600, 1200}, "seconds since 2019-03-06 10:00:00 +00")
        .axis("zu_3d", palm.zu, "meters")
        .axis("zw_3d", palm.zw, "meters")
        .axis("x", palm.x, "meters")
        .axis("xu", palm.xu, "meters")
        .axis("y", palm.y, "meters")
        .axis("yv", palm.yv, "meters");
    const NetCdfAttributes attributes = {{"units", "m/s"}, {"_FillValue", -9999.0}};
    const auto twice = [&](Numbers numbers) {
        const Numbers once = numbers;
        numbers.insert(numbers.end(), once.begin(), once.end());
        if (palm.building != 0.0)
            numbers[0] = numbers[1] = palm.building;
        return numbers;
    };
    file.array("u", {"time", "zu_3d", "y", "xu"}, attributes,
               twice(valuesOver(palm.zu, palm.y, palm.xu, eastOf)), NC_FLOAT)
        .array("v", {"time", "zu_3d", "yv", palm.ofV}, attributes,
               twice(valuesOver(palm.zu, palm.yv, palm.ofV == "x" ? palm.x : palm.xu, northOf)), NC_FLOAT)
        .array("w", {"time", "zw_3d", "y", "x"}, attributes, twice(valuesOver(palm.zw, palm.y, palm.x, upOf)),
               NC_FLOAT);
}

} // namespace

TEST(NetCdfStaggered, LinearPalmFieldIsExactAtCellCentres) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/palm.nc";
    const Palm palm;
    writePalm(path, palm);
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    ASSERT_EQ(grid.points, glm::ivec3(5, 4, 4)) << "centres that have neighbours on both sides";
    EXPECT_EQ(grid.origin, glm::dvec3(5, 5, 0));
    EXPECT_EQ(grid.heights, (std::vector<float>{-5, 5, 15, 26}));
    EXPECT_EQ(grid.times, (Numbers{0, 600}));
    EXPECT_EQ(summaryOf(path).start, "2019-03-06T10:10:00Z");
    for (int z = 1; z < 4; ++z) // the lowest centre is below the lowest w
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 5; ++x) {
                const double east = 5 + 10 * x, north = 5 + 10 * y,
                             high = palm.zu[static_cast<std::size_t>(z)];
                expectNear(velocityAt(grid, 1, z, y, x),
                           {eastOf(high, north, east), northOf(high, north, east), upOf(high, north, east)},
                           1e-5f);
            }
    EXPECT_NEAR(velocityAt(grid, 0, 0, 0, 0).z, upOf(0, 5, 5), 1e-6) << "w at the ground is used below";
}

TEST(NetCdfStaggered, WindowEqualsTheWholeFile) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/palm.nc";
    writePalm(path, {});
    REQUIRE_NETCDF(path);
    const GridWind::Grid whole = gridOf(path), part = gridOf(path, WindArea{"", {34, 14}, {34, 14}});
    EXPECT_EQ(part.points, glm::ivec3(4, 3, 4));
    EXPECT_EQ(part.origin, glm::dvec3(15, 5, 0));
    for (int y = 0; y < part.points.y; ++y)
        for (int x = 0; x < part.points.x; ++x)
            EXPECT_EQ(velocityAt(part, 1, 2, y, x), velocityAt(whole, 1, 2, y, x + 1));
}

TEST(NetCdfStaggered, HasNoDataInsideBuildings) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/palm.nc";
    Palm palm;
    palm.building = -9999.0;
    writePalm(path, palm);
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_TRUE(std::isnan(velocityAt(grid, 0, 0, 0, 0).x)) << "both faces are inside the building";
    EXPECT_NEAR(velocityAt(grid, 0, 0, 0, 1).x, eastOf(-5, 5, 20), 1e-5) << "one face is inside";
    EXPECT_NEAR(velocityAt(grid, 0, 0, 0, 2).x, eastOf(-5, 5, 25), 1e-5);
}

TEST(NetCdfStaggered, RefusesComponentsThatDoNotMatch) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/palm.nc";
    writePalm(path, {});
    REQUIRE_NETCDF(path);
    Palm third, far, coarse, high;
    third.x = numbersFrom(3, 10, 6);
    coarse.x = numbersFrom(5, 20, 6);
    far.yv = numbersFrom(2.5, 10, 5);
    high.zw = {200, 210, 220, 230};
    for (const auto& [palm, message] :
         {std::pair{third, "v: its dimension x is neither the same as xu"},
          {coarse, "v: its dimension x is neither the same as xu"},
          {far, "v: its dimension yv is neither the same as y"},
          {high,
           "w: expected the dimension zu_3d of the other arrays of wind, or one of the same coordinates, "
           "found zw_3d"}}) {
        writePalm(path, palm);
        const Result<WindContent> content = contentOf(path);
        ASSERT_FALSE(content) << message;
        EXPECT_NE(firstProblem(content).find(message), std::string::npos) << firstProblem(content);
    }
}

/// One more face than cells, with names without meaning, and the same axis with two names.
TEST(NetCdfStaggered, MatchesAxesByCoordinatesNotNames) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/c.nc";
    const Numbers x = numbersFrom(500, 1000, 4), faces = numbersFrom(0, 1000, 5),
                  y = numbersFrom(500, 1000, 3), sides = numbersFrom(0, 1000, 4);
    NetCdfWriter(path)
        .axis("ni", x, "m")
        .axis("nip1", faces, "m")
        .axis("nj", y, "m")
        .axis("njp1", sides, "m")
        .array("u", {"nj", "nip1"}, metresPerSecond,
               valuesOver(y, faces, [](double b, double a) { return eastOf(0, b, a); }))
        .array("v", {"njp1", "ni"}, metresPerSecond,
               valuesOver(sides, x, [](double b, double a) { return northOf(0, b, a); }));
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    ASSERT_EQ(grid.points, glm::ivec3(4, 3, 1)) << "every cell has both faces";
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i) {
            const double east = 500 + 1000 * i, north = 500 + 1000 * j;
            expectNear(velocityAt(grid, 0, 0, j, i), {eastOf(0, north, east), northOf(0, north, east), 0},
                       1e-4f);
        }
    NetCdfWriter(path)
        .axis("x_1", x, "m")
        .axis("x_2", x, "m")
        .axis("y", y, "m")
        .array("u", {"y", "x_1"}, metresPerSecond, valuesOver(y, x, [](double, double a) { return a; }))
        .array("v", {"y", "x_2"}, metresPerSecond, valuesOver(y, x, [](double b, double) { return b; }));
    expectNear(velocityAt(gridOf(path), 0, 0, 2, 3), {3500, 2500, 0}, 1e-3f);
}

/// x and y of PALM are relative to its corner; separate arrays contain projected coordinates.
TEST(NetCdfStaggered, PlacesPalmInItsCrs) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/utm.nc";
    const Numbers x = {5, 15}, y = {5, 15};
    NetCdfWriter(path)
        .axis("x", x, "m")
        .axis("y", y, "m")
        .array("E_UTM", {"x"}, {{"units", "m"}, {"standard_name", "projection_x_coordinate"}},
               {390005, 390015})
        .array("N_UTM", {"y"}, {{"units", "m"}, {"standard_name", "projection_y_coordinate"}},
               {5820005, 5820015})
        .array("crs", {},
               {{"grid_mapping_name", "transverse_mercator"},
                {"semi_major_axis", 6378137.0},
                {"inverse_flattening", 298.257222101},
                {"longitude_of_central_meridian", 15.0},
                {"latitude_of_projection_origin", 0.0},
                {"scale_factor_at_central_meridian", 0.9996},
                {"false_easting", 500000.0},
                {"false_northing", 0.0},
                {"longitude_of_prime_meridian", 0.0}},
               {0}, NC_INT)
        .array("u", {"y", "x"}, {{"units", "m/s"}, {"grid_mapping", "crs"}}, {1, 2, 3, 4})
        .array("v", {"y", "x"}, {{"units", "m/s"}, {"grid_mapping", "crs"}}, {5, 6, 7, 8});
    REQUIRE_NETCDF(path);
    const WindSummary summary = summaryOf(path);
    EXPECT_FALSE(summary.crs.empty());
    EXPECT_EQ(gridOf(path).origin, glm::dvec3(390005, 5820005, 0));
    EXPECT_EQ(gridOf(path, WindArea{"EPSG:25833", {390006, 5820006}, {390007, 5820007}}).points,
              glm::ivec3(2, 2, 1));
}

} // namespace osgTreeWind

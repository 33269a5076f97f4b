// SPDX-License-Identifier: MIT
// Reading only the window around the area where wind is needed.
#include <tests/TestData.h>
#include <tests/windfiles/NetCdfWriting.h>

#include <chrono>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// Expects that each point of a part, with its heights, equals the same place of the whole.
void expectPart(const GridWind::Grid& part, const GridWind::Grid& whole) {
    const glm::dvec2 off = glm::dvec2(part.origin - whole.origin) / glm::dvec2(whole.cell);
    const auto x0 = static_cast<int>(std::lround(off.x)), y0 = static_cast<int>(std::lround(off.y));
    EXPECT_LT(std::abs(off.x - x0) + std::abs(off.y - y0), 1e-6);
    EXPECT_EQ(part.times, whole.times);
    ASSERT_EQ(part.points.z, whole.points.z);
    const auto steps = static_cast<int>(std::max<std::size_t>(1, whole.times.size()));
    ASSERT_EQ(part.values.size(), std::size_t(3) * static_cast<std::size_t>(steps * part.points.x *
                                                                            part.points.y * part.points.z));
    for (int t = 0; t < steps; ++t)
        for (int z = 0; z < part.points.z; ++z)
            for (int y = 0; y < part.points.y; ++y)
                for (int x = 0; x < part.points.x; ++x)
                    EXPECT_EQ(velocityAt(part, t, z, y, x), velocityAt(whole, t, z, y0 + y, x0 + x));
}

/// Hourly ERA5 of the whole globe for 30 days. Values are only written around 11.5 E, 48 N, in the last hour
/// of each day: u is the hour / 100, v is 2.
void writeMonth(const std::string& path, int mode, std::size_t hours) {
    int file = 0, dimensions[3], axes[3], winds[2],
        status = nc_create(path.c_str(), mode | NC_CLOBBER, &file);
    const char* const names[] = {"time", "latitude", "longitude"};
    const char* const units[] = {"hours since 1900-01-01 00:00:00.0", "degrees_north", "degrees_east"};
    const std::size_t sizes[] = {hours, 721, 1440};
    int previous = 0;
    status |= nc_set_fill(file, NC_NOFILL, &previous);
    for (int axis = 0; axis < 3; ++axis) {
        status |= nc_def_dim(file, names[axis], sizes[axis], &dimensions[axis]);
        status |= nc_def_var(file, names[axis], NC_FLOAT, 1, &dimensions[axis], &axes[axis]);
        status |= nc_put_att_text(file, axes[axis], "units", std::string(units[axis]).size(), units[axis]);
    }
    const double scale = 0.001, offset = 0.0;
    const short fill = -32767;
    for (int i = 0; i < 2; ++i) {
        status |= nc_def_var(file, i == 0 ? "u10" : "v10", NC_SHORT, 3, dimensions, &winds[i]);
        status |= nc_put_att_double(file, winds[i], "scale_factor", NC_DOUBLE, 1, &scale);
        status |= nc_put_att_double(file, winds[i], "add_offset", NC_DOUBLE, 1, &offset);
        status |= nc_put_att_text(file, winds[i], "units", 7, "m s**-1");
        if ((mode & NC_NETCDF4) != 0) {
            const std::size_t chunk[] = {1, 721, 1440};
            status |= nc_put_att_short(file, winds[i], "_FillValue", NC_SHORT, 1, &fill);
            status |= nc_def_var_chunking(file, winds[i], NC_CHUNKED, chunk);
            status |= nc_def_var_deflate(file, winds[i], 1, 1, 1);
        }
    }
    status |= nc_enddef(file);
    for (int axis = 0; axis < 3; ++axis) {
        const Numbers at = axis == 0   ? numbersFrom(1043135, 1, hours)
                           : axis == 1 ? numbersFrom(90, -0.25, 721)
                                       : numbersFrom(0, 0.25, 1440);
        status |= nc_put_var_double(file, axes[axis], at.data());
    }
    for (std::size_t t = 23; t < hours; t += 24) {
        const std::size_t start[] = {t, 160, 40}, count[] = {1, 16, 16};
        const std::vector<short> u(256, static_cast<short>(10 * t)), v(256, 2000);
        status |= nc_put_vara_short(file, winds[0], start, count, u.data());
        status |= nc_put_vara_short(file, winds[1], start, count, v.data());
    }
    status |= nc_close(file);
    EXPECT_EQ(status, NC_NOERR);
}

void expectMonth(const std::string& path, std::size_t hours) {
    const auto before = std::chrono::steady_clock::now();
    const GridWind::Grid grid = gridOf(path, WindArea{"EPSG:32632", {680000, 5330000}, {700000, 5345000}});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    ::testing::Test::RecordProperty("milliseconds", static_cast<int>(1000 * took.count()));
    EXPECT_LT(took.count(), 20.0) << "2 s on an idle machine";
    ASSERT_EQ(grid.times.size(), hours);
    EXPECT_LE(grid.points.x * grid.points.y, 25);
    const auto last = static_cast<int>(hours) - 1;
    expectNear(velocityAt(grid, last, 0, 0, 0), {0.01f * static_cast<float>(last), 2, 0}, 1e-5f);
}

} // namespace

TEST(NetCdfWindow, EqualsTheWholeFileInMetresAndDegrees) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/a.nc";
    const Numbers x = numbersFrom(-50, 2, 40), y = numbersFrom(40, -2, 30), z = {10, 50};
    for (const bool degrees : {true, false}) {
        NetCdfWriter(path)
            .axis("x", x, degrees ? "degrees_east" : "km")
            .axis("y", y, degrees ? "degrees_north" : "km")
            .axis("z", z, "m")
            .array("u", {"z", "y", "x"}, metresPerSecond,
                   valuesOver(z, y, x, [](double c, double b, double a) { return a + b / 100 + c / 1000; }))
            .array("v", {"z", "y", "x"}, metresPerSecond,
                   valuesOver(z, y, x, [](double c, double b, double a) { return b - a / 100 - c / 1000; }));
        REQUIRE_NETCDF(path);
        const double unit = degrees ? 1 : 1000;
        const GridWind::Grid whole = gridOf(path),
                             part = gridOf(path, WindArea{"", {-11 * unit, -4 * unit}, {3 * unit, 7 * unit}});
        EXPECT_EQ(whole.points, glm::ivec3(40, 30, 2));
        EXPECT_EQ(part.points, glm::ivec3(11, 9, 2));
        EXPECT_EQ(part.cell, glm::dvec3(2 * unit, 2 * unit, 1)) << "metres, where the file has km";
        expectPart(part, whole);
    }
}

TEST(NetCdfWindow, EqualsTheWholeFileForAMovingWrfGrid) {
    for (const char* name : {"wrf_lambert.nc", "wrf_polar.nc"}) {
        const std::string path = smallNetCdf(name);
        REQUIRE_NETCDF(path);
        const GridWind::Grid whole = gridOf(path);
        const glm::dvec2 corner(whole.origin), cell(whole.cell);
        const std::string crs = summaryOf(path).crs;
        for (const glm::dvec2 at : {glm::dvec2(0), glm::dvec2(3, 2), glm::dvec2(1.5, 0.5)}) {
            const glm::dvec2 place = corner + at * cell;
            const GridWind::Grid part = gridOf(path, WindArea{crs, place, place});
            EXPECT_LE(part.values.size(), whole.values.size());
            expectPart(part, whole);
        }
    }
}

TEST(NetCdfWindow, EqualsTheWholeFileForARealMovingGridWithHeights) {
    REQUIRE_REAL_DATA(path, "wind/ci_test_file.nc");
    REQUIRE_NETCDF(path);
    const GridWind::Grid whole = gridOf(path),
                         part = gridOf(path, WindArea{"EPSG:4326", {-89.9, 23.4}, {-89.8, 23.5}});
    EXPECT_LE(part.points.x, 5);
    EXPECT_LE(part.points.y, 5);
    expectPart(part, whole);
    EXPECT_EQ(part.heights.size(), part.values.size() / 3);
}

TEST(NetCdfWindow, FindsAnAreaInAnotherCrs) {
    const std::string path = smallNetCdf("wrf_lambert.nc");
    REQUIRE_NETCDF(path);
    const GridWind::Grid whole = gridOf(path);
    // The south-western cell by its latitude and longitude from make_wrf.py.
    const GridWind::Grid part = gridOf(path, WindArea{"EPSG:4326", {3.5, 44.9}, {3.7, 45.1}});
    EXPECT_EQ(part.origin.x, whole.origin.x);
    EXPECT_LE(part.points.x, whole.points.x);
    expectPart(part, whole);
}

TEST(NetCdfWindow, AreaOutsideTheCrsIsAnError) {
    const std::string path = smallNetCdf("wrf_polar.nc");
    REQUIRE_NETCDF(path);
    const Result<WindContent> content = contentOf(path, WindArea{"nonsense", {0, 0}, {1, 1}});
    ASSERT_FALSE(content);
    EXPECT_EQ(firstProblem(content).substr(0, path.size()), path);
    EXPECT_NE(firstProblem(content).find("expected a coordinate reference system"), std::string::npos);
}

TEST(NetCdfWindow, ReadsACityFromAMonthOfTheGlobe) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/month.nc";
    for (const int mode : {NC_64BIT_OFFSET, NC_NETCDF4}) {
        const std::size_t hours = mode == NC_NETCDF4 ? 24 : 720;
        writeMonth(path, mode, hours);
        if (mode == NC_64BIT_OFFSET) { // unwritten parts are holes of a sparse file
            std::filesystem::resize_file(path, 2 * 721 * 1440 * 2 * hours + 100000);
        }
        REQUIRE_NETCDF(smallNetCdf("small.nc"));
        expectMonth(path, hours);
    }
}

TEST(NetCdfWindow, RefusesTheWholeGlobe) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/month.nc";
    writeMonth(path, NC_64BIT_OFFSET, 720);
    REQUIRE_NETCDF(smallNetCdf("small.nc"));
    EXPECT_NE(firstProblem(contentOf(path))
                  .find("u10: expected at most 536870912 numbers to read, found 747532800; "
                        "choose a smaller area"),
              std::string::npos)
        << firstProblem(contentOf(path));
    // Truncated within the values.
    std::filesystem::resize_file(path, 100000000);
    EXPECT_NE(firstProblem(contentOf(path, WindArea{"EPSG:4326", {11, 48}, {12, 49}}))
                  .find("the file is too short"),
              std::string::npos);
}

} // namespace osgTreeWind

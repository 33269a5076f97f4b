// SPDX-License-Identifier: MIT
// Ambiguous or invalid files: one error each, with the array and the expectation.
#include <tests/FullTests.h>
#include <tests/windfiles/NetCdfWriting.h>

#include <osgTreeWind/base/Span.h>

namespace osgTreeWind {

namespace {

const std::vector<std::string> latLon = {"lat", "lon"};

/// Axes of 3 longitudes and 2 latitudes.
NetCdfWriter& axes(NetCdfWriter& file) {
    return file.axis("lon", {1, 2, 3}, "degrees_east").axis("lat", {50, 51}, "degrees_north");
}

NetCdfWriter& winds(NetCdfWriter& file, const std::vector<std::string>& dimensions,
                    const std::string& unit = "m/s", std::size_t count = 6) {
    return file.array("u", dimensions, {{"units", unit}}, Numbers(count, 1))
        .array("v", dimensions, {{"units", unit}}, Numbers(count, 1));
}

struct Broken {
    const char* message;
    std::function<void(NetCdfWriter&)> write;
};

const Broken files[] = {
    {"expected arrays of wind", [](NetCdfWriter& file) { axes(file); }},
    {"expected arrays of wind", [](NetCdfWriter& file) { axes(file).array("u", latLon, {}, Numbers(6, 1)); }},
    {"expected arrays of wind",
     [](NetCdfWriter& file) {
         axes(file).array("u10", latLon, {}, Numbers(6, 1)).array("u100", latLon, {}, Numbers(6, 1));
         file.array("t2m", latLon, {}, Numbers(6, 1));
     }},
    {"v: expected the unit of the other components, m/s, found 'kn'",
     [](NetCdfWriter& file) {
         axes(file)
             .array("u", latLon, {{"units", "m/s"}}, Numbers(6, 1))
             .array("v", latLon, {{"units", "knots"}}, Numbers(6, 1));
     }},
    {"lon: expected evenly spaced coordinates, found 4 at index 2 instead of 5",
     [](NetCdfWriter& file) {
         file.axis("lon", {1, 3, 4, 7}, "degrees_east").axis("lat", {50, 51}, "degrees_north");
         winds(file, latLon, "m/s", 8);
     }},
    {"lat: expected evenly spaced coordinates, found 50 at index 0 instead of 50",
     [](NetCdfWriter& file) {
         file.axis("lon", {1, 2, 3}, "degrees_east").axis("lat", {50, 50}, "degrees_north");
         winds(file, latLon);
     }},
    {"lat: expected coordinates of at most 90, found 91",
     [](NetCdfWriter& file) {
         file.axis("lon", {1, 2, 3}, "degrees_east").axis("lat", {90, 91}, "degrees_north");
         winds(file, latLon);
     }},
    {"lat: expected finite coordinates",
     [](NetCdfWriter& file) {
         file.axis("lon", {1, 2, 3}, "degrees_east").axis("lat", {std::nan(""), 91}, "degrees_north");
         winds(file, latLon);
     }},
    {"lon: expected coordinates of this dimension",
     [](NetCdfWriter& file) {
         winds(file.dimension("lon", 3).axis("lat", {50, 51}, "degrees_north"), latLon);
     }},
    {"u: expected both of its dimensions y and lon in degrees or both in a map projection",
     [](NetCdfWriter& file) {
         winds(file.axis("lon", {1, 2, 3}, "degrees_east").axis("y", {50, 51}, "m"), {"y", "lon"});
     }},
    {"x: expected coordinates in m, km, feet or degrees, found 'parsecs'",
     [](NetCdfWriter& file) {
         winds(file.axis("x", {1, 2, 3}, "parsecs").axis("y", {50, 51}, "m"), {"y", "x"});
     }},
    {"longitude: expected longitudes and latitudes of one dimension each, or x and y of a projection; found "
     "them on "
     "2 (a "
     "curvilinear grid)",
     [](NetCdfWriter& file) {
         file.dimension("j", 2).dimension("i", 3);
         file.array("longitude", {"j", "i"}, {{"units", "degrees_east"}}, {1, 2, 3, 1, 2, 3})
             .array("latitude", {"j", "i"}, {{"units", "degrees_north"}}, {1, 1, 1, 2, 2, 2});
         winds(file, {"j", "i"});
     }},
    {"uas: expected a grid_mapping of a rotated pole",
     [](NetCdfWriter& file) {
         file.axis("rlon", {1, 2, 3}, "degrees", {{"standard_name", "grid_longitude"}})
             .axis("rlat", {1, 2}, "degrees", {{"standard_name", "grid_latitude"}});
         file.array("uas", {"rlat", "rlon"}, {{"grid_mapping", "none"}}, Numbers(6, 1))
             .array("vas", {"rlat", "rlon"}, {}, Numbers(6, 1));
     }},
    {"v: expected the dimension lev of the other arrays of wind, or one of the same coordinates, found none",
     [](NetCdfWriter& file) {
         axes(file).axis("lev", {10, 20}, "m");
         file.array("u", {"lev", "lat", "lon"}, {}, Numbers(12, 1)).array("v", latLon, {}, Numbers(6, 1));
     }},
    {"v: expected the dimension time of the other arrays of wind, or one of the same coordinates, found "
     "time_2",
     [](NetCdfWriter& file) {
         axes(file)
             .axis("time", {0, 1}, "hours since 2000-01-01")
             .axis("time_2", {0, 2}, "hours since 2000-01-01");
         file.array("u", {"time", "lat", "lon"}, {}, Numbers(12, 1))
             .array("v", {"time_2", "lat", "lon"}, {}, Numbers(12, 1));
     }},
    {"v: expected 12 numbers, at all times, found 6",
     [](NetCdfWriter& file) {
         axes(file).axis("time", {0, 1}, "hours since 2000-01-01");
         file.array("u", {"time", "lat", "lon"}, {}, Numbers(12, 1)).array("v", latLon, {}, Numbers(6, 1));
     }},
    {"time: expected times of this dimension",
     [](NetCdfWriter& file) {
         axes(file).dimension("time", 2);
         winds(file, {"time", "lat", "lon"}, "m/s", 12);
     }},
    {"wind_direction: expected degrees, found 'rad'",
     [](NetCdfWriter& file) {
         axes(file)
             .array("wind_speed", latLon, {{"units", "m/s"}}, Numbers(6, 1))
             .array("wind_direction", latLon, {{"units", "rad"}}, Numbers(6, 1));
     }},
    {"wind_direction: expected speeds not below 0 and directions of -360 to 360, found 1 and 999",
     [](NetCdfWriter& file) {
         axes(file)
             .array("wind_speed", latLon, {{"units", "m/s"}}, Numbers(6, 1))
             .array("wind_direction", latLon, {{"units", "degree"}}, Numbers(6, 999));
     }},
};

} // namespace

TEST(NetCdfBroken, ReportsOneClearErrorEach) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/broken.nc";
    const int modes[] = {NC_NETCDF4, NC_64BIT_OFFSET};
    for (const int mode : Span(modes, static_cast<std::size_t>(casesToRun(2, 1))))
        for (const Broken& broken : files) {
            {
                NetCdfWriter file(path, mode);
                broken.write(file);
            }
            REQUIRE_NETCDF(path);
            const Result<WindContent> content = contentOf(path);
            ASSERT_FALSE(content) << broken.message;
            EXPECT_EQ(content.problems().size(), 1u) << broken.message;
            EXPECT_EQ(firstProblem(content).substr(0, path.size() + 2), path + ": ");
            EXPECT_NE(firstProblem(content).find(broken.message), std::string::npos)
                << "expected " << broken.message << "\nfound    " << firstProblem(content);
        }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
// WRF output with heights above the model's terrain, and with only 10 m winds.
#include <tests/windfiles/NetCdfWriting.h>

#include <glm/trigonometric.hpp>

#include <osgTreeWind/places/Crs.h>

namespace osgTreeWind {

namespace {

constexpr std::size_t columns = 5, rows = 4;
constexpr double radius = 6370000.0, cell = 3000.0;

/// Cells in Mercator projection, the first at its origin; u is the column, v the row.
class WrfWriter {
public:
    explicit WrfWriter(const std::string& path) : _file(path) {
        _file.dimension("Time", 2)
            .dimension("south_north", rows)
            .dimension("west_east", columns)
            .attribute("DX", cell)
            .attribute("DY", cell)
            .attribute("MAP_PROJ", 3.0)
            .attribute("TRUELAT1", 0.0)
            .attribute("STAND_LON", 0.0);
        Numbers latitudes, longitudes;
        for (int t = 0; t < 2; ++t)
            for (std::size_t y = 0; y < rows; ++y)
                for (std::size_t x = 0; x < columns; ++x) {
                    longitudes.push_back(static_cast<double>(x) * cell / (radius * glm::radians(1.0)));
                    latitudes.push_back(
                        2 *
                        (glm::degrees(std::atan(std::exp(static_cast<double>(y) * cell / radius))) - 45.0));
                }
        _file.array("XLAT", flat(), {}, latitudes, NC_FLOAT).array("XLONG", flat(), {}, longitudes, NC_FLOAT);
    }

    NetCdfWriter& file() { return _file; }

    static std::vector<std::string> flat() { return {"Time", "south_north", "west_east"}; }

    void addTimes(const std::string& unit) {
        NetCdfAttributes attributes;
        if (!unit.empty())
            attributes = {{"units", unit}};
        _file.array("XTIME", {"Time"}, attributes, {0, 60}, NC_FLOAT);
    }

    void addTenMetres() {
        Numbers u, v;
        for (int t = 0; t < 2; ++t)
            for (std::size_t y = 0; y < rows; ++y)
                for (std::size_t x = 0; x < columns; ++x) {
                    u.push_back(static_cast<double>(x) + 10 * t);
                    v.push_back(static_cast<double>(y));
                }
        _file.array("U10", flat(), {{"units", "m s-1"}}, u, NC_FLOAT)
            .array("V10", flat(), {{"units", "m s-1"}}, v, NC_FLOAT);
    }

    /// Three levels at 40, 120 and 280 m above terrain of 500 m, 100 m more for each column.
    void addLevels(bool ground, std::size_t faces = columns + 1) {
        _file.dimension("bottom_top", 3)
            .dimension("bottom_top_stag", 4)
            .dimension("south_north_stag", rows + 1)
            .dimension("west_east_stag", faces);
        const double tops[] = {0, 80, 160, 400};
        Numbers base, heights;
        for (int t = 0; t < 2; ++t) {
            for (const double top : tops)
                for (std::size_t i = 0; i < rows * columns; ++i)
                    base.push_back(9.81 * (500 + 100 * static_cast<double>(i % columns) + top));
            for (std::size_t i = 0; i < rows * columns; ++i)
                heights.push_back(500 + 100 * static_cast<double>(i % columns));
        }
        const NetCdfAttributes unit = {{"units", "m s-1"}};
        Numbers u, v;
        for (std::size_t i = 0; i < 2 * 3 * rows * faces; ++i)
            u.push_back(static_cast<double>(i % faces) - 0.5);
        for (std::size_t i = 0; i < 2 * 3 * (rows + 1) * columns; ++i)
            v.push_back(static_cast<double>(i / columns % (rows + 1)) - 0.5);
        const std::vector<std::string> mass = {"Time", "bottom_top_stag", "south_north", "west_east"};
        _file.array("U", {"Time", "bottom_top", "south_north", "west_east_stag"}, unit, u, NC_FLOAT)
            .array("V", {"Time", "bottom_top", "south_north_stag", "west_east"}, unit, v, NC_FLOAT)
            .array("W", mass, unit, Numbers(base.size(), 0.25), NC_FLOAT)
            .array("PH", mass, {}, Numbers(base.size(), 0.0), NC_FLOAT)
            .array("PHB", mass, {}, base, NC_FLOAT);
        if (ground)
            _file.array("HGT", flat(), {{"units", "m"}}, heights, NC_FLOAT);
    }

private:
    NetCdfWriter _file;
};

} // namespace

TEST(NetCdfWrfGround, HeightsAreAboveTheTerrainOfTheModel) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/wrf.nc";
    {
        WrfWriter wrf(path);
        wrf.addTimes("minutes since 2005-08-28 00:00:00");
        wrf.addLevels(true);
    }
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_TRUE(grid.aboveGround);
    ASSERT_EQ(grid.heights.size(), 2u * 3 * rows * columns);
    for (std::size_t i = 0; i < grid.heights.size(); ++i)
        EXPECT_NEAR(grid.heights[i],
                    (i / (rows * columns) % 3 == 0   ? 40
                     : i / (rows * columns) % 3 == 1 ? 120
                                                     : 280),
                    1e-3);
    EXPECT_EQ(velocityAt(grid, 1, 2, 3, 4), glm::vec3(4, 3, 0.25f));
    const WindSummary summary = summaryOf(path);
    EXPECT_EQ(summary.start, "2005-08-28T00:00:00Z");
    EXPECT_TRUE(hasNote(summary, "minus the terrain of the model, HGT"));
    const Result<Crs> crs = Crs::parseMap(summary.crs);
    ASSERT_TRUE(crs) << firstProblem(crs);
    EXPECT_EQ(summary.coordinates, "+proj=merc +lat_ts=0 +lon_0=0 +R=6370000");
    // 80 m above ground at scene z = 700 m: midway between the two lower levels.
    const auto file = readAt(path, {3000, 3000, 300});
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_NEAR(file.value().summary.low.z, 40, 1e-3) << "independent of the height of the origin";
    EXPECT_NEAR(asField(file.value().wind)->velocity(WindPlace({3000, 0, 480}, 400), 0).x, 2, 1e-4);
}

TEST(NetCdfWrfGround, HeightsWithoutTerrainAreAboveSeaLevel) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/wrf.nc";
    {
        WrfWriter wrf(path);
        wrf.addTimes("minutes since 2005-08-28 00:00:00");
        wrf.addLevels(false);
    }
    REQUIRE_NETCDF(path);
    EXPECT_FALSE(gridOf(path).aboveGround);
    EXPECT_NEAR(gridOf(path).heights[1], 640, 1e-2);
    EXPECT_TRUE(hasNote(summaryOf(path), "metres above sea level"));
}

TEST(NetCdfWrfGround, ReadsFilesWithOnlyTenMetreWinds) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/wrf.nc";
    {
        WrfWriter wrf(path);
        wrf.file().attribute("SIMULATION_START_DATE", "2005-08-28_06:00:00");
        wrf.addTimes("");
        wrf.addTenMetres();
    }
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_EQ(grid.points, glm::ivec3(columns, rows, 1));
    EXPECT_EQ(grid.heights, std::vector<float>{10.0f});
    EXPECT_TRUE(grid.aboveGround);
    EXPECT_NEAR(grid.origin.x, 0, 0.5);
    EXPECT_NEAR(grid.origin.y, 0, 0.5);
    EXPECT_EQ(grid.times, (Numbers{0, 3600}));
    EXPECT_EQ(velocityAt(grid, 1, 0, 2, 3), glm::vec3(13, 2, 0));
    EXPECT_EQ(summaryOf(path).start, "2005-08-28T06:00:00Z")
        << "the start of the simulation, because XTIME has no date";
    const GridWind::Grid part = gridOf(path, WindArea{"EPSG:4326", {0, 0}, {0.001, 0.001}});
    EXPECT_EQ(part.points, glm::ivec3(3, 3, 1));
    EXPECT_EQ(velocityAt(part, 1, 0, 2, 2), glm::vec3(12, 2, 0));
}

TEST(NetCdfWrfGround, RefusesArraysWithOtherShapes) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/wrf.nc";
    {
        WrfWriter wrf(path);
        wrf.addTimes("minutes since 2005-08-28 00:00:00");
        wrf.addLevels(true, columns + 2);
    }
    REQUIRE_NETCDF(path);
    EXPECT_EQ(firstProblem(contentOf(path)),
              path + ": V: expected 2 x 3 x 5 x 6 numbers, as U has them, found 2 x 3 x 5 x 5");
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
// Heights of levels: metres, or geopotential of pressure and model levels minus terrain.
#include <tests/windfiles/NetCdfWriting.h>

namespace osgTreeWind {

namespace {

constexpr double gravity = 9.80665;

/// Variations of the file.
struct Levels {
    Numbers at = {1000, 925, 850};
    std::string unit = "hPa", name = "level", standardName;
    std::string geopotential = "z", geopotentialUnit = "m**2 s**-2";
    std::string ground; ///< Its name; empty: none.
};

/// Heights of 120, 800 and 1500 m above sea level, 10 m more for each column and at the second time; terrain
/// of 20 m, 300 m in the last column. u is 1, 2 and 3 from the lowest level up, v the column.
void writeLevels(const std::string& path, const Levels& levels = {}) {
    const bool downward = levels.at.front() < levels.at.back() && levels.unit == "hPa";
    const std::size_t count = levels.at.size();
    NetCdfWriter file(path);
    file.axis("longitude", {1, 2, 3}, "degrees_east")
        .axis("latitude", {50, 51}, "degrees_north")
        .axis("time", {0, 6}, "hours since 2020-01-01");
    NetCdfAttributes standardName;
    if (!levels.standardName.empty())
        standardName.emplace_back("standard_name", levels.standardName);
    file.axis(levels.name, levels.at, levels.unit, standardName);
    constexpr double heights[] = {120, 800, 1500};
    Numbers u, v, z, ground;
    const double scale = levels.geopotentialUnit == "m" ? 1.0 : gravity;
    for (int t = 0; t < 2; ++t) {
        for (std::size_t level = 0; level < count; ++level)
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 3; ++x) {
                    const std::size_t upward = downward ? count - 1 - level : level;
                    u.push_back(static_cast<double>(upward) + 1.0);
                    v.push_back(x);
                    z.push_back(scale * (heights[upward] + 10 * x + 10 * t));
                }
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x)
                ground.push_back(scale * (x == 2 ? 300 : 20));
    }
    const std::vector<std::string> all = {"time", levels.name, "latitude", "longitude"};
    file.array("u", all, metresPerSecond, u)
        .array("v", all, metresPerSecond, v)
        .array("w", all, {{"units", "Pa s**-1"}}, Numbers(u.size(), 0.5));
    if (!levels.geopotential.empty())
        file.array(levels.geopotential, all, {{"units", levels.geopotentialUnit}}, z);
    if (!levels.ground.empty())
        file.array(levels.ground, {"time", "latitude", "longitude"}, {{"units", levels.geopotentialUnit}},
                   ground);
}

float heightAt(const GridWind::Grid& grid, int t, int z, int y, int x) {
    return grid.heights.at(
        static_cast<std::size_t>(((t * grid.points.z + z) * grid.points.y + y) * grid.points.x + x));
}

} // namespace

TEST(NetCdfLevels, PressureLevelsAreAtTheirGeopotentialHeight) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/levels.nc";
    for (const Numbers& at : {Numbers{1000, 925, 850}, Numbers{850, 925, 1000}}) {
        Levels levels;
        levels.at = at;
        writeLevels(path, levels);
        REQUIRE_NETCDF(path);
        const GridWind::Grid grid = gridOf(path);
        EXPECT_FALSE(grid.aboveGround);
        EXPECT_EQ(grid.points, glm::ivec3(3, 2, 3));
        EXPECT_NEAR(heightAt(grid, 0, 0, 0, 0), 120, 1e-3);
        EXPECT_NEAR(heightAt(grid, 1, 2, 1, 2), 1530, 1e-3);
        EXPECT_EQ(velocityAt(grid, 1, 2, 1, 2), glm::vec3(3, 2, 0)) << "change of pressure is ignored";
        EXPECT_FALSE(summaryOf(path).mayIncludeTrees);
        EXPECT_TRUE(hasNote(summaryOf(path), "w is the change of pressure"));
        EXPECT_TRUE(hasNote(summaryOf(path), "metres above sea level"));
        EXPECT_TRUE(GridWind::check(grid).empty());
    }
}

TEST(NetCdfLevels, HeightsMinusTerrainAreAboveGround) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/levels.nc";
    for (const auto& [geopotential, unit, ground] :
         {std::tuple{"z", "m**2 s**-2", "phis"}, {"gh", "gpm", "orog"}, {"zg", "m", "orography"}}) {
        Levels levels;
        levels.geopotential = geopotential;
        levels.geopotentialUnit = unit == std::string("gpm") ? "m" : unit;
        levels.ground = ground;
        writeLevels(path, levels);
        REQUIRE_NETCDF(path);
        const GridWind::Grid grid = gridOf(path);
        EXPECT_TRUE(grid.aboveGround);
        EXPECT_NEAR(heightAt(grid, 0, 0, 0, 1), 110, 1e-3) << geopotential;
        EXPECT_NEAR(heightAt(grid, 1, 1, 0, 0), 790, 1e-3);
        EXPECT_TRUE(hasNote(summaryOf(path), "minus the terrain of the model"));
    }
}

/// The lowest level of the last column is 160 m below the terrain and gets the wind above it.
TEST(NetCdfLevels, LevelsBelowTheTerrainGetTheLowestWindAboveIt) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/levels.nc";
    Levels levels;
    levels.ground = "phis";
    writeLevels(path, levels);
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_NEAR(heightAt(grid, 0, 0, 0, 2), 140 - 300, 1e-3);
    EXPECT_EQ(velocityAt(grid, 0, 0, 0, 2), glm::vec3(2, 2, 0));
    EXPECT_EQ(velocityAt(grid, 0, 0, 0, 1), glm::vec3(1, 1, 0));
    EXPECT_TRUE(hasNote(summaryOf(path), "4 of 36 velocities are below the terrain of the model"));
    EXPECT_TRUE(GridWind::check(grid).empty());
}

TEST(NetCdfLevels, ReadsModelLevels) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/levels.nc";
    Levels levels;
    levels.at = {137, 136, 135};
    levels.name = "hybrid";
    levels.unit = "1";
    writeLevels(path, levels);
    REQUIRE_NETCDF(path);
    EXPECT_NEAR(heightAt(gridOf(path), 0, 2, 0, 0), 1500, 1e-3);
}

TEST(NetCdfLevels, RefusesLevelsWithoutGeopotentialByName) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/levels.nc";
    Levels levels;
    levels.geopotential.clear();
    writeLevels(path, levels);
    REQUIRE_NETCDF(path);
    EXPECT_EQ(firstProblem(contentOf(path)),
              path + ": level: expected heights of these "
                     "pressure levels: an array of geopotential (z, zg or gh) on the "
                     "same dimensions");
    levels.unit = "1";
    levels.name = "hybrid";
    writeLevels(path, levels);
    EXPECT_NE(firstProblem(contentOf(path))
                  .find("hybrid: expected heights of these "
                        "model"),
              std::string::npos);
}

TEST(NetCdfLevels, RefusesGeopotentialThatDoesNotIncrease) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/levels.nc";
    Levels levels;
    levels.at = {925, 1000, 1100};
    writeLevels(path, levels);
    REQUIRE_NETCDF(path);
    EXPECT_NEAR(heightAt(gridOf(path), 0, 0, 0, 0), 120, 1e-3);
    levels.unit = "Pa"; // then the numbers are written in reverse order
    writeLevels(path, levels);
    EXPECT_NE(firstProblem(contentOf(path)).find("z: expected heights that increase upward, found 1500"),
              std::string::npos)
        << firstProblem(contentOf(path));
}

TEST(NetCdfLevels, HeightIsAboveGroundButAltitudeIsNot) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/levels.nc";
    for (const auto& [name, standardName, aboveGround] : {std::tuple{"lev", "height", true},
                                                          {"lev", "altitude", false},
                                                          {"height", "", true},
                                                          {"z", "", false}}) {
        Levels levels;
        levels.at = {10, 50, 120};
        levels.unit = "m";
        levels.name = name;
        levels.standardName = standardName;
        levels.geopotential.clear();
        writeLevels(path, levels);
        REQUIRE_NETCDF(path);
        EXPECT_EQ(gridOf(path).aboveGround, aboveGround) << name << " " << standardName;
        EXPECT_EQ(gridOf(path).heights, (std::vector<float>{10, 50, 120}));
    }
}

/// Names as in GRIB converted by THREDDS, with both kinds of levels in one file.
TEST(NetCdfLevels, PrefersHeightsToPressure) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/thredds.nc";
    NetCdfWriter(path)
        .axis("x", {-1, 0, 1}, "km")
        .axis("y", {0, 1}, "km")
        .axis("isobaric", {100000, 85000}, "Pa")
        .axis("height_above_ground1", {10, 80}, "m", {{"positive", "up"}})
        .array("U-component_of_wind_isobaric", {"isobaric", "y", "x"}, metresPerSecond, Numbers(12, 30))
        .array("V-component_of_wind_isobaric", {"isobaric", "y", "x"}, metresPerSecond, Numbers(12, 30))
        .array("U-component_of_wind_height_above_ground", {"height_above_ground1", "y", "x"}, metresPerSecond,
               numbersFrom(0, 1, 12))
        .array("V-component_of_wind_height_above_ground", {"height_above_ground1", "y", "x"}, metresPerSecond,
               numbersFrom(0, -1, 12));
    REQUIRE_NETCDF(path);
    const GridWind::Grid grid = gridOf(path);
    EXPECT_EQ(grid.points, glm::ivec3(3, 2, 2));
    EXPECT_EQ(grid.origin, glm::dvec3(-1000, 0, 0));
    EXPECT_EQ(grid.heights, (std::vector<float>{10, 80}));
    EXPECT_TRUE(grid.aboveGround);
    EXPECT_EQ(velocityAt(grid, 0, 1, 1, 2), glm::vec3(11, -11, 0));
}

} // namespace osgTreeWind

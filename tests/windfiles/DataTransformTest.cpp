// SPDX-License-Identifier: MIT
// Winds transformed from the CRS of a file, or degrees, to the CRS of a scene.
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/places/RasterFile.h>

#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/windfiles/WindFile.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

namespace {

glm::dvec2 brought(glm::dvec2 place, const char* from, const char* to) {
    EXPECT_TRUE(CrsTransform::between(Crs::parse(from).value(), Crs::parse(to).value()).value().apply(place));
    return place;
}

/// Meridian convergence of a transverse Mercator projection, radians.
double convergence(const glm::dvec2& lonLat, double meridian) {
    return std::atan(std::tan(glm::radians(lonLat.x - meridian)) * std::sin(glm::radians(lonLat.y)));
}

/// Turns a velocity counterclockwise.
glm::dvec2 turned(const glm::dvec2& v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle), v.x * std::sin(angle) + v.y * std::cos(angle)};
}

Result<WindFile> readOn(const std::string& path, const std::string& crs, const glm::dvec2& origin) {
    WindFileOptions options;
    options.crs = crs;
    options.origin = {origin, 0.0};
    options.low = glm::dvec2(-2000.0);
    options.high = glm::dvec2(2000.0);
    return readWindFile(path, options);
}

/// A westerly of 10 m/s in degrees around 11.9 E, 47 N.
std::string westerlyOnDegrees(const TemporaryFolder& folder, double west = 11.0) {
    RasterFile pair;
    pair.columns = 8;
    pair.rows = 8;
    pair.transform = {west, 0.25, 0, 48, 0, -0.25};
    pair.crs = "EPSG:4326";
    pair.value = [](int, int) { return 270.0; };
    (void)pair.write(folder.path() + "/w_ang.tif");
    pair.value = [](int, int) { return 10.0; };
    return pair.write(folder.path() + "/w_vel.tif");
}

} // namespace

/// A cell of a real file read in the next UTM zone: its values turned by both convergences.
TEST(DataTransform, TransformsWindNinjaToTheNextUtmZone) {
    REQUIRE_REAL_DATA(path, "place/20171026T1500_vel.asc");
    const glm::dvec2 cell = glm::dvec2(726299.0, 5208948.0) + 29.150477 * (glm::dvec2(40, 70) + 0.5);
    const auto own = readOn(path, "EPSG:32611", cell);
    ASSERT_TRUE(own) << firstProblem(own);
    const glm::dvec2 there(asField(own.value().wind)->velocity({0, 0, 10}, 0));
    ASSERT_GT(glm::length(there), 0.5);

    const glm::dvec2 lonLat = brought(cell, "EPSG:32611", "EPSG:4326");
    const double turn = convergence(lonLat, -111.0) - convergence(lonLat, -117.0);
    EXPECT_NEAR(glm::degrees(turn), -4.38, 0.02);
    const auto next = readOn(path, "EPSG:32612", brought(cell, "EPSG:32611", "EPSG:32612"));
    ASSERT_TRUE(next) << firstProblem(next);
    const glm::dvec2 here(asField(next.value().wind)->velocity({0, 0, 10}, 0)),
        expected = turned(there, turn);
    EXPECT_NEAR(here.x, expected.x, 2e-3);
    EXPECT_NEAR(here.y, expected.y, 2e-3);
    EXPECT_TRUE(next.value().covers({0, 0}));
    EXPECT_FALSE(next.value().covers({20000, 0}));
}

TEST(DataTransform, TurnsAWesterlyInDegreesByTheConvergence) {
    const TemporaryFolder folder;
    const glm::dvec2 lonLat(11.9, 47.0), place = brought(lonLat, "EPSG:4326", "EPSG:32632");
    const auto file = readOn(westerlyOnDegrees(folder), "EPSG:32632", place);
    ASSERT_TRUE(file) << firstProblem(file);
    const glm::dvec2 wind(asField(file.value().wind)->velocity({0, 0, 10}, 0)),
        expected = turned({10, 0}, convergence(lonLat, 9.0));
    EXPECT_NEAR(wind.x, expected.x, 1e-3);
    EXPECT_NEAR(wind.y, expected.y, 1e-3);
    EXPECT_GT(wind.y, 0.3) << "grid east is south of true east";
}

TEST(DataTransform, LongitudesMayBeShiftedBy360) {
    const TemporaryFolder folder;
    const auto file = readOn(westerlyOnDegrees(folder, 371.0), "EPSG:32632",
                             brought({11.9, 47.0}, "EPSG:4326", "EPSG:32632"));
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_NEAR(glm::length(asField(file.value().wind)->velocity({0, 0, 10}, 0)), 10.0f, 1e-3f);
    EXPECT_TRUE(file.value().covers({0, 0}));
}

TEST(DataTransform, AppliesAProfileIfARoughnessIsGiven) {
    const TemporaryFolder folder;
    WindFileOptions options;
    options.crs = "EPSG:32632";
    options.origin = {brought({11.9, 47.0}, "EPSG:4326", "EPSG:32632"), 800.0};
    const std::string path = westerlyOnDegrees(folder);
    options.roughness = 0.1;
    EXPECT_NE(firstProblem(readWindFile(path, options))
                  .find("height: expected both the height of the data above the ground"),
              std::string::npos);
    options.height = 10.0;
    const auto file = readWindFile(path, options);
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_TRUE(file.value().summary.aboveGround);
    EXPECT_NEAR(glm::length(asField(file.value().wind)->velocity({glm::vec3(0, 0, 41), 40.0f}, 0)), 5.0f,
                1e-3f);
    options.roughness = 0.0;
    EXPECT_NE(firstProblem(readWindFile(path, options)).find("and a roughness"), std::string::npos);
}

TEST(DataTransform, ClampsToTheEdgeFarFromTheData) {
    const TemporaryFolder folder;
    const auto file = readOn(westerlyOnDegrees(folder), "+proj=ortho +lat_0=-47 +lon_0=-168", {0, 0});
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_FALSE(file.value().covers({0, 0}));
    EXPECT_NEAR(glm::length(asField(file.value().wind)->velocity({0, 0, 10}, 0)), 10.0f, 1e-3f);
}

TEST(DataTransform, NamesAnInvalidPrjFile) {
    const TemporaryFolder folder;
    const std::string head = "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n4\n";
    folder.write("a_ang.asc", head);
    folder.write("a_vel.prj", "PROJCS[\"half");
    const std::string problem = firstProblem(readWindFile(folder.write("a_vel.asc", head)));
    EXPECT_NE(problem.find("a_vel.prj: expected a coordinate reference system"), std::string::npos)
        << problem;
}

TEST(DataTransform, DegreesRequireACrs) {
    const TemporaryFolder folder;
    EXPECT_NE(firstProblem(readWindFile(westerlyOnDegrees(folder)))
                  .find("its coordinates are in degrees, WGS 84; expected crs, a projected CRS in metres"),
              std::string::npos);
}

TEST(DataTransform, RefusesACrsThatIsNotInMetres) {
    const TemporaryFolder folder;
    for (const auto& [crs, part] :
         {std::pair("EPSG:4326", "crs: expected a projected system in metres"), {"nonsense", "crs: "}})
        EXPECT_NE(firstProblem(readOn(westerlyOnDegrees(folder), crs, {0, 0})).find(part), std::string::npos)
            << firstProblem(readOn(westerlyOnDegrees(folder), crs, {0, 0}));
}

} // namespace osgTreeWind

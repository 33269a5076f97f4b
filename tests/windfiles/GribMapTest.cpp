// SPDX-License-Identifier: MIT
// Georeference of GRIB grids, north of their components, and windows.
#include <tests/windfiles/GribReading.h>

#include <glm/common.hpp>

#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

/// 31 x 21 points in Lambert projection, 100 km apart, the first at 30 N, 110 W; U is 10 m/s.
grib::Field lambert(int edition, bool relativeToGrid) {
    grib::Field field;
    field.edition = edition;
    field.type = edition == 1 ? 105 : 103;
    field.grid = {
        true, 31, 21, edition == 1 ? -110.0 : 250.0, 30.0, edition == 1 ? 60000.0 : 100000.0, relativeToGrid};
    return field;
}

std::string tenAlongU(const grib::Field& field) {
    return grib::wind(
        field, [](int, int) { return 10.0; }, [](int, int) { return 0.0; });
}

/// Angle of true north to the left of the y axis of the Lambert projection: sin 25° (longitude - 95 W).
double lambertConvergence(const glm::dvec2& place, double radius) {
    return std::atan2(place.x, radius / std::tan(25.0 * degree) - place.y);
}

GridWind::Grid gridOf(const Result<WindContent>& content) {
    EXPECT_TRUE(content) << firstProblem(content);
    return content ? std::get<GridWind::Grid>(content.value().data) : GridWind::Grid();
}

/// The globe in steps of 10 degrees, eastward from Greenwich; U is the column, V the row.
std::string earth() {
    grib::Field field;
    field.grid = {false, 36, 19, 0.0, 90.0, 10.0};
    return grib::wind(
        field, [](int column, int) { return 1.0 * column; }, [](int, int row) { return 1.0 * row; });
}

/// Reads an area and compares each point with the column and row of the globe.
GridWind::Grid windowOfEarth(const WindArea& area) {
    const TemporaryFolder folder;
    WindRequest request;
    request.area = area;
    const GridWind::Grid grid = gridOf(readWindContent(folder.write("a.grib2", earth()), request));
    for (int y = 0; y < grid.points.y; ++y)
        for (int x = 0; x < grid.points.x; ++x) {
            const double longitude = grid.origin.x + grid.cell.x * x,
                         latitude = grid.origin.y + grid.cell.y * y;
            const auto at = 3 * static_cast<std::size_t>(y * grid.points.x + x);
            EXPECT_NEAR(grid.values[at], std::remainder(longitude - 180.0, 360.0) / 10.0 + 18.0, 1e-3)
                << longitude;
            EXPECT_NEAR(grid.values[at + 1], (90.0 - latitude) / 10.0, 1e-3) << latitude;
        }
    return grid;
}

class GribMap : public testing::TestWithParam<int> {};

} // namespace

TEST_P(GribMap, DoesNotTurnGridRelativeWind) {
    const auto file = readGribBytes(tenAlongU(lambert(GetParam(), true)), false);
    ASSERT_TRUE(file) << firstProblem(file);
    const WindSummary& summary = file.value().summary;
    EXPECT_EQ(summary.points, glm::ivec3(31, 21, 1));
    EXPECT_EQ(summary.direction, "components toward x (east), y (north) and up");
    EXPECT_TRUE(summary.notes.empty());
    for (const glm::dvec3& place : {summary.low, summary.high})
        expectNear(asField(file.value().wind)->velocity(glm::vec3(place), 0), {10, 0, 0}, 1e-4f);
}

TEST_P(GribMap, TurnsWindFromTrueNorthByTheConvergence) {
    const std::string bytes = tenAlongU(lambert(GetParam(), false));
    const auto file = readGribBytes(bytes, false), stored = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    ASSERT_TRUE(stored) << firstProblem(stored);
    const WindSummary& summary = file.value().summary;
    EXPECT_EQ(summary.direction, "components toward true east, true north and up");
    for (const glm::dvec2& place :
         {glm::dvec2(summary.low), glm::dvec2(summary.high.x, summary.low.y), glm::dvec2(summary.high)}) {
        const double left = lambertConvergence(place, GetParam() == 1 ? 6371200.0 : 6371229.0);
        EXPECT_GT(std::abs(left), 0.02);
        const WindPlace at(glm::vec3(place, 10));
        expectNear(asField(file.value().wind)->velocity(at, 0), {10 * std::cos(left), 10 * std::sin(left), 0},
                   1e-3f);
        expectNear(asField(stored.value().wind)->velocity(at, 0), {10, 0, 0}, 1e-4f);
    }
    EXPECT_TRUE(hasNote(summary, "they are turned to the grid's y axis, by"));
    EXPECT_TRUE(hasNote(stored.value().summary, "in a forest they are turned"));
}

TEST_P(GribMap, FirstPointIsAtItsLongitudeAndLatitude) {
    const auto file = readGribBytes(tenAlongU(lambert(GetParam(), true)), false);
    ASSERT_TRUE(file) << firstProblem(file);
    const WindSummary& summary = file.value().summary;
    const double n = std::sin(25.0 * degree), radius = GetParam() == 1 ? 6371200.0 : 6371229.0;
    const auto cone = [](double latitude) { return std::tan((45.0 + 0.5 * latitude) * degree); };
    const double rho0 = radius / std::tan(25.0 * degree), rho = rho0 * std::pow(cone(25.0) / cone(30.0), n),
                 angle = n * (-110.0 + 95.0) * degree;
    EXPECT_NEAR(summary.low.x, rho * std::sin(angle), 1.0);
    EXPECT_NEAR(summary.low.y, rho0 - rho * std::cos(angle), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Both, GribMap, testing::Values(1, 2),
                         [](const auto& info) { return "Edition" + std::to_string(info.param); });

/// Polar stereographic, true at 60 N, straight up at 95 W.
TEST(GribMaps, TrueNorthIsTowardThePoleInPolarStereographic) {
    grib::Field field = lambert(2, false);
    field.grid.lambertTemplate = 20;
    const auto file = readGribBytes(tenAlongU(field), false);
    ASSERT_TRUE(file) << firstProblem(file);
    const glm::dvec2 place(file.value().summary.low);
    const glm::dvec2 north = -place / std::hypot(place.x, place.y); // the pole is at 0, 0
    expectNear(asField(file.value().wind)->velocity(glm::vec3(file.value().summary.low), 0),
               {10 * north.y, -10 * north.x, 0}, 1e-3f);
    EXPECT_NEAR(std::atan2(place.x, -place.y) / degree, 250.0 - 265.0, 1e-4);
}

TEST(GribMaps, TrueNorthIsUpInMercator) {
    grib::Field field = lambert(2, false);
    field.grid.lambertTemplate = 10;
    field.grid.longitude = 10.0;
    field.grid.latitude = 50.0;
    const auto file = readGribBytes(tenAlongU(field), false);
    ASSERT_TRUE(file) << firstProblem(file);
    expectNear(asField(file.value().wind)->velocity(glm::vec3(file.value().summary.high), 0), {10, 0, 0},
               1e-3f);
    EXPECT_NEAR(file.value().summary.low.y,
                6371229.0 * std::cos(20.0 * degree) * std::log(std::tan(70.0 * degree)), 1.0);
}

TEST(GribMaps, WindowEqualsTheWholeFile) {
    const GridWind::Grid grid = windowOfEarth({"", {31, 41}, {52, 49}});
    EXPECT_EQ(grid.origin.x, 20.0);
    EXPECT_EQ(grid.points, glm::ivec3(6, 4, 1)) << "one more on either side";
    EXPECT_EQ(grid.origin.y, 30.0);
}

TEST(GribMaps, ReadsAWindowAcrossGreenwich) {
    const GridWind::Grid grid = windowOfEarth({"", {-12, -3}, {12, 3}});
    EXPECT_EQ(grid.origin.x, -30.0);
    EXPECT_EQ(grid.points.x, 7);
}

TEST(GribMaps, ReadsAWindowAcrossTheDateLine) {
    const GridWind::Grid east = windowOfEarth({"", {175, -3}, {186, 3}}),
                         west = windowOfEarth({"", {-185, -3}, {-174, 3}});
    EXPECT_EQ(east.origin.x, 160.0);
    EXPECT_EQ(west.origin.x, -200.0);
    EXPECT_EQ(east.values, west.values);
}

TEST(GribMaps, ReadsAWindowInAnotherCrs) {
    const GridWind::Grid grid = windowOfEarth({"EPSG:32632", {4e5, 5.5e6}, {6e5, 5.6e6}});
    EXPECT_LE(grid.origin.x, 7.0);
    EXPECT_GE(grid.origin.x + grid.cell.x * (grid.points.x - 1), 11.0);
    EXPECT_EQ(grid.points.x, 5);
}

TEST(GribMaps, TurnsAWindowLikeTheWholeFile) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.grib2", tenAlongU(lambert(2, false)));
    const GridWind::Grid whole = gridOf(readWindContent(path, {}));
    WindRequest request;
    const glm::dvec2 place = glm::dvec2(whole.origin) + 100000.0 * glm::dvec2(10, 12);
    request.area = WindArea{"", place, place};
    const GridWind::Grid window = gridOf(readWindContent(path, request));
    EXPECT_LT(window.values.size(), whole.values.size() / 10);
    const auto at = [](const GridWind::Grid& grid, const glm::dvec2& where) {
        const glm::ivec2 index = glm::round((where - glm::dvec2(grid.origin)) / glm::dvec2(grid.cell));
        const auto i = 3 * static_cast<std::size_t>(index.y * grid.points.x + index.x);
        return glm::vec3(grid.values.at(i), grid.values.at(i + 1), grid.values.at(i + 2));
    };
    expectNear(at(window, place), at(whole, place), 1e-5f);
    EXPECT_LT(at(whole, place).y, -0.1f);
}

} // namespace osgTreeWind

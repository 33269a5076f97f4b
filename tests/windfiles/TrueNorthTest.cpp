// SPDX-License-Identifier: MIT
// Winds relative to true north, in Lambert projection around 40 N, 100 W on a sphere of 6371.2 km.
#include <tests/windfiles/NetCdfReading.h>

#include <glm/gtc/constants.hpp>

#include <tests/io/TemporaryFolder.h>

#include <cmath>

namespace osgTreeWind {

namespace {

/// Angle of true north to the left of the y axis: n (longitude - 100 W).
double convergence(const glm::dvec2& place) {
    return std::atan2(place.x, 6371200.0 / std::tan(40.0 * glm::pi<double>() / 180.0) - place.y);
}

/// Reads a changed truenorth.nc: 10 m/s toward east, and as speed and direction 10 m/s from south.
Result<WindFile> readChanged(const std::string& bytes, const glm::dvec2& place) {
    const TemporaryFolder folder;
    return readAt(folder.write("changed.nc", bytes), {place, 0.0});
}

const std::string truenorth = smallNetCdf("truenorth.nc");
const glm::dvec2 corners[] = {{-2e6, -5e5}, {2e6, -5e5}, {-2e6, 5e5}, {2e6, 5e5}};

void expectVelocity(const Result<WindFile>& file, const glm::dvec2& expected) {
    ASSERT_TRUE(file) << firstProblem(file);
    expectNear(asField(file.value().wind)->velocity({}, 0), glm::vec3(expected, 0), 1e-4f);
}

} // namespace

TEST(TrueNorth, TurnsEastwardWindByTheConvergence) {
    REQUIRE_NETCDF(truenorth);
    for (const glm::dvec2& place : corners) {
        const double left = convergence(place);
        EXPECT_GT(std::abs(left), 0.2);
        expectVelocity(readAt(truenorth, {place, 0}), {10 * std::cos(left), 10 * std::sin(left)});
    }
    expectVelocity(readAt(truenorth, {0, 5e5, 0}), {10, 0});
    const WindSummary summary = readAt(truenorth).value().summary;
    EXPECT_EQ(summary.direction, "components toward true east, true north and up");
    EXPECT_TRUE(hasNote(summary, "turned to the grid's y axis, by -15.75 to 15.75 degrees clockwise"));
}

TEST(TrueNorth, TurnsNothingAsStored) {
    REQUIRE_NETCDF(truenorth);
    for (const glm::dvec2& place : corners) {
        const auto file = readAt(truenorth, {place, 0}, true);
        expectVelocity(file, {10, 0});
        EXPECT_TRUE(hasNote(file.value().summary, "in a forest they are turned to the grid's y axis, "
                                                  "by -15.75 to 15.75 degrees clockwise"));
        EXPECT_FALSE(hasNote(file.value().summary, "velocities here"));
    }
}

TEST(TrueNorth, TurnsDirectionFromByTheConvergence) {
    REQUIRE_NETCDF(truenorth);
    const std::string bytes = renamed(fileBytes(truenorth), "eastward_wind", "eastward_what");
    for (const glm::dvec2& place : corners) {
        const double left = convergence(place);
        const auto file = readChanged(bytes, place);
        expectVelocity(file, {-10 * std::sin(left), 10 * std::cos(left)});
        EXPECT_EQ(file.value().summary.direction, "from, degrees clockwise from true north");
    }
}

TEST(TrueNorth, DoesNotTurnWindRelativeToTheGrid) {
    REQUIRE_NETCDF(truenorth);
    const auto file =
        readChanged(withAttribute(fileBytes(truenorth), "GRIB_uvRelativeToGrid", 1), corners[0]);
    expectVelocity(file, {10, 0});
    EXPECT_TRUE(file.value().summary.notes.empty());
    EXPECT_EQ(file.value().summary.direction, "components toward x (east), y (north) and up");
}

TEST(TrueNorth, DoesNotTurnDirectionsOfUnknownNorth) {
    REQUIRE_NETCDF(truenorth);
    const auto file = readChanged(renamed(renamed(fileBytes(truenorth), "eastward_wind", "eastward_what"),
                                          "wind_from_direction", "wind_from_somewhere"),
                                  corners[0]);
    expectVelocity(file, {0, 10});
    EXPECT_EQ(file.value().summary.direction, "from, degrees clockwise from the grid's north");
}

TEST(TrueNorth, TurnsNothingWithoutAProjectionWithANote) {
    REQUIRE_NETCDF(truenorth);
    const auto file = readChanged(renamed(fileBytes(truenorth), "grid_mapping", "gird_mapping"), corners[0]);
    expectVelocity(file, {10, 0});
    EXPECT_TRUE(hasNote(file.value().summary, "gives no projection"));
}

TEST(TrueNorth, PrefersComponentsAlongXAndY) {
    const std::string path = smallNetCdf("gridnorth.nc");
    REQUIRE_NETCDF(path);
    for (const double x : {-2e6, 2e6})
        expectVelocity(readAt(path, {x, 0, 0}), {3, 4});
    EXPECT_TRUE(readAt(path).value().summary.notes.empty());
}

} // namespace osgTreeWind

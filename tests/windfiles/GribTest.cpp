// SPDX-License-Identifier: MIT
// Wind of GRIB, edition 1 and 2: values, levels and times equal those written.
#include <tests/windfiles/GribReading.h>

namespace osgTreeWind {

namespace {

/// Fields on 4 x 3 points from 10 to 11.5 E and 50 to 49 N.
std::string degreesOf(int edition) {
    grib::Field field;
    field.edition = edition;
    field.type = edition == 1 ? 105 : 103;
    return grib::wind(field, eastward, northward);
}

void expectSpot(const WindFile& file, const WindPlace& place, double time, const glm::vec3& expected) {
    expectNear(asField(file.wind)->velocity(place, time), expected, 1e-3f);
}

class GribEditions : public testing::TestWithParam<int> {};

} // namespace

TEST_P(GribEditions, ReadsPointsInDegreesFromTheNorth) {
    const auto file = readGribBytes(degreesOf(GetParam()));
    ASSERT_TRUE(file) << firstProblem(file);
    const WindSummary& summary = file.value().summary;
    EXPECT_EQ(summary.format, "GRIB" + std::to_string(GetParam()));
    EXPECT_EQ(summary.points, glm::ivec3(4, 3, 1));
    EXPECT_EQ(summary.low, glm::dvec3(10, 49, 10));
    EXPECT_EQ(summary.high, glm::dvec3(11.5, 50, 10));
    EXPECT_EQ(summary.start, "2017-06-03T18:00:00Z");
    EXPECT_EQ(summary.unit, "m/s");
    EXPECT_EQ(summary.direction, "components toward true east, true north and up");
    EXPECT_TRUE(summary.times.empty());
    EXPECT_TRUE(summary.notes.empty());
    expectSpot(file.value(), {10, 50, 10}, 0, {1, -0.5, 0});
    expectSpot(file.value(), {11.5, 49, 10}, 0, {24, -12, 0});
    expectSpot(file.value(), {10.25, 49.75, 10}, 0, {6.5, -3.25, 0});
}

TEST_P(GribEditions, WritesTheSharedSmallFile) {
    EXPECT_EQ(fileBytes(smallNetCdf("small.grib" + std::to_string(GetParam()))), degreesOf(GetParam()));
}

TEST_P(GribEditions, CrsCanBeParsed) {
    const auto file = readGribBytes(degreesOf(GetParam()));
    ASSERT_TRUE(file) << firstProblem(file);
    const Result<WindArea> area =
        areaOnMap(file.value().summary.crs, {"EPSG:32632", {5e5, 5.5e6}, {5e5, 5.5e6}});
    ASSERT_TRUE(area) << firstProblem(area);
    EXPECT_NEAR(area.value().low.x, 9.0, 1e-6);
    EXPECT_NEAR(area.value().low.y, 49.65, 0.01);
}

TEST_P(GribEditions, ReadsTimesFromReferenceAndLeadTime) {
    grib::Field field;
    field.edition = GetParam();
    field.type = GetParam() == 1 ? 105 : 103;
    std::string bytes;
    for (const int lead : {6, 0, 3}) {
        field.lead = lead;
        bytes += grib::wind(
            field, [&](int, int) { return 1.0 + lead; }, [](int, int) { return 2.0; });
    }
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(file.value().summary.times, (std::vector<double>{0, 10800, 21600}));
    EXPECT_EQ(file.value().summary.start, "2017-06-03T18:00:00Z");
    expectSpot(file.value(), {10, 50, 10}, 10800, {4, 2, 0});
    expectSpot(file.value(), {10, 50, 10}, 16200, {5.5, 2, 0});
}

TEST_P(GribEditions, UsesTheLatestForecastForEachTime) {
    grib::Field early, late;
    early.edition = late.edition = GetParam();
    early.type = late.type = GetParam() == 1 ? 105 : 103;
    early.hour = 12;
    early.lead = 6;
    const auto of = [](double value) { return [value](int, int) { return value; }; };
    const std::string bytes = grib::wind(late, of(7), of(0)) + grib::wind(early, of(5), of(0));
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10, 50, 10}, 0, {7, 0, 0});
    EXPECT_TRUE(hasNote(file.value().summary, "the latest forecast for each time is used; 1 fields of U"));
}

TEST_P(GribEditions, ReadsHeightsAboveGroundAsLayers) {
    grib::Field field;
    field.edition = GetParam();
    field.type = GetParam() == 1 ? 105 : 103;
    std::string bytes;
    for (const double level : {100.0, 10.0}) {
        field.level = level;
        bytes += grib::wind(
            field, [&](int, int) { return level / 10.0; }, [](int, int) { return 0.0; });
    }
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(file.value().summary.points, glm::ivec3(4, 3, 2));
    for (const float ground : {0.0f, 300.0f}) {
        expectSpot(file.value(), WindPlace(glm::vec3(10, 50, ground + 55), ground), 0, {5.5, 0, 0});
        expectSpot(file.value(), WindPlace(glm::vec3(10, 50, ground + 2), ground), 0, {1, 0, 0});
    }
}

TEST_P(GribEditions, MissingPointsAreCalm) {
    grib::Field field;
    field.edition = GetParam();
    field.type = GetParam() == 1 ? 105 : 103;
    field.missing = [](int column, int row) { return column == 1 && row == 0; };
    const auto file = readGribBytes(grib::wind(field, eastward, northward));
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10.5, 50, 10}, 0, {0, 0, 0});
    expectSpot(file.value(), {11, 50, 10}, 0, {3, -1.5, 0});
    EXPECT_TRUE(hasNote(file.value().summary, "1 of 12 velocities have no data"));
}

TEST_P(GribEditions, SkipsBulletinHeadingAndPadding) {
    const std::string bytes =
        "\1\r\r\n123\r\r\nHTXX01 KWBC 031800\r\r\n" + degreesOf(GetParam()) + std::string(120, '\0');
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10, 50, 10}, 0, {1, -0.5, 0});
}

INSTANTIATE_TEST_SUITE_P(Both, GribEditions, testing::Values(1, 2),
                         [](const auto& info) { return "Edition" + std::to_string(info.param); });

/// small.grib2 through `grib_set -r -s packingType=grid_ccsds`.
TEST(Grib, ReadsCcsdsPacking) {
    const auto file = readGribBytes(fileBytes(smallNetCdf("ccsds.grib2")));
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(file.value().summary.points, glm::ivec3(4, 3, 1));
    expectSpot(file.value(), {10, 50, 10}, 0, {1, -0.5, 0});
    expectSpot(file.value(), {11.5, 49, 10}, 0, {24, -12, 0});
}

TEST(Grib, EcmwfParametersImplyTheirHeight) {
    grib::Field field;
    field.edition = 1;
    field.type = 1;
    field.level = 0;
    std::string bytes;
    for (const auto& [table, number, value] :
         {std::tuple{128, 165, 3.0}, {128, 166, 4.0}, {228, 246, 6.0}, {228, 247, 8.0}}) {
        field.table = table;
        const double speed = value;
        bytes += grib::message(grib::with(field, number, [speed](int, int) { return speed; }));
    }
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(file.value().summary.low.z, 10.0);
    EXPECT_EQ(file.value().summary.high.z, 100.0);
    expectSpot(file.value(), {10, 50, 10}, 0, {3, 4, 0});
    expectSpot(file.value(), {10, 50, 100}, 0, {6, 8, 0});
}

TEST(Grib, ReadsVerticalWind) {
    grib::Field field;
    const std::string bytes =
        degreesOf(2) + grib::message(grib::with(field, 9, [](int, int) { return 0.5; }));
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10, 50, 10}, 0, {1, -0.5, 0.5});
    EXPECT_TRUE(file.value().summary.notes.empty());
}

TEST(Grib, IgnoresChangesOfPressureWithANote) {
    grib::Field field;
    const std::string bytes =
        degreesOf(2) + grib::message(grib::with(field, 8, [](int, int) { return 0.5; }));
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10, 50, 10}, 0, {1, -0.5, 0});
    EXPECT_TRUE(hasNote(file.value().summary, "vertical velocities in Pa/s are ignored"));
}

TEST(Grib, ReadsSpeedAndDirectionFrom) {
    grib::Field field;
    const std::string bytes = grib::message(grib::with(field, 1, [](int, int) { return 10.0; })) +
                              grib::message(grib::with(field, 0, [](int, int) { return 90.0; }));
    const auto file = readGribBytes(bytes);
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10, 50, 10}, 0, {-10, 0, 0});
    EXPECT_EQ(file.value().summary.direction, "from, degrees clockwise from true north");
}

TEST(Grib, IgnoresGustsAndMaxima) {
    grib::Field gust, most;
    gust.number = 22;
    most.product = 8;
    most.value = [](int, int) { return 90.0; };
    const auto file = readGribBytes(grib::message(gust) + grib::message(most) + degreesOf(2));
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10, 50, 10}, 0, {1, -0.5, 0});
    EXPECT_EQ(problemOfGrib(grib::message(most)), "expected fields of wind: U and V, or its speed and "
                                                  "direction; found only fields averaged over a time span");
}

TEST(Grib, UsesASingleLevelWithoutHeightWithANote) {
    grib::Field field;
    field.type = 1;
    field.level = 0;
    const auto file = readGribBytes(grib::wind(field, eastward, northward));
    ASSERT_TRUE(file) << firstProblem(file);
    expectSpot(file.value(), {10, 50, 40}, 0, {1, -0.5, 0});
    EXPECT_TRUE(hasNote(file.value().summary, "the file gives no height for the surface"));
}

} // namespace osgTreeWind

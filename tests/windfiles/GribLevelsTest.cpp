// SPDX-License-Identifier: MIT
// Heights of isobaric and model levels of GRIB above the terrain of the model.
#include <tests/windfiles/GribReading.h>

namespace osgTreeWind {

namespace {

constexpr int isobaric = 100, hybrid = 105, aboveSea = 102, aboveGround = 103, surface = 1, pascal = 100;

std::function<double(int, int)> constant(double value) {
    return [value](int, int) { return value; };
}

grib::Field atLevel(int type, double level) {
    grib::Field field;
    field.type = type;
    field.level = level;
    return field;
}

/// A level with U = `speed` at geopotential height `height`, metres.
std::string level(const grib::Field& field, double speed, double height) {
    grib::Field heights = field;
    heights.category = 3;
    heights.exponent = 0;
    return grib::wind(field, constant(speed), constant(0)) +
           grib::message(grib::with(heights, 5, constant(height)));
}

std::string orography(const std::function<double(int, int)>& height) {
    grib::Field field = atLevel(surface, 0);
    field.category = 3;
    field.exponent = 0;
    return grib::message(grib::with(field, 5, height));
}

/// 1000 hPa at 100 m, 5 m/s; 900 hPa at 1000 m, 15 m/s; the upper one first.
std::string twoLevels() {
    return level(atLevel(isobaric, 900 * pascal), 15, 1000) + level(atLevel(isobaric, 1000 * pascal), 5, 100);
}

void expectSpeed(const Result<WindFile>& file, const WindPlace& place, float speed) {
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_NEAR(asField(file.value().wind)->velocity(place, 0).x, speed, 0.01f) << place.position.z;
}

} // namespace

TEST(GribLevels, HeightsAreAboveTheTerrainOfTheModel) {
    const auto file = readGribBytes(twoLevels() + orography(constant(40)));
    expectSpeed(file, {10, 50, 60}, 5);
    expectSpeed(file, {10, 50, 510}, 10);
    expectSpeed(file, {10, 50, 960}, 15);
    expectSpeed(file, WindPlace(glm::vec3(10, 50, 2510), 2000), 10); // relative to the ground below the place
    EXPECT_TRUE(hasNote(file.value().summary, "heights are above the terrain of the model"));
}

TEST(GribLevels, VariableChoosesLevelsByTheirShortName) {
    std::string bytes = twoLevels();
    for (const double height : {10.0, 100.0})
        bytes += grib::wind(atLevel(aboveGround, height), constant(height / 10.0), constant(0));
    const auto read = [&](const std::vector<std::string>& variable) {
        return readGribBytes(bytes, true, variable);
    };
    const auto all = read({});
    expectSpeed(all, {10, 50, 55}, 5.5f);
    EXPECT_TRUE(hasNote(all.value().summary,
                        "the wind at heights above ground is used; that at isobaric levels is "
                        "ignored; wind.variable chooses another by its short name"));
    expectSpeed(read({"u"}), {10, 50, 550}, 10);
    expectSpeed(read({"10u"}), {10, 50, 55}, 1);
    expectSpeed(read({"100u", "100v"}), {10, 50, 55}, 10);
    EXPECT_TRUE(read({"10u"}).value().summary.notes.empty());
    EXPECT_NE(firstProblem(read({"gust"}))
                  .find("expected a field of wind that wind.variable names: 100u, 100v, 10u, "
                        "10v, u, v, found 'gust'"),
              std::string::npos)
        << firstProblem(read({"gust"}));
}

TEST(GribLevels, LevelsBelowTheTerrainGetTheLowestWindAboveIt) {
    const auto hill = [](int column, int) { return column == 0 ? 400.0 : 0.0; };
    const auto file = readGribBytes(twoLevels() + orography(hill));
    expectSpeed(file, {10, 50, 0}, 15); // 1000 hPa lies 300 m below
    expectSpeed(file, {10, 50, 600}, 15);
    expectSpeed(file, {11, 50, 0}, 5);
    expectSpeed(file, {11, 50, 550}, 10);
}

TEST(GribLevels, HeightsWithoutTerrainAreAboveSeaLevel) {
    const auto file = readGribBytes(twoLevels());
    expectSpeed(file, {10, 50, 550}, 10);
    expectSpeed(file, WindPlace(glm::vec3(10, 50, 550), 500), 10); // independent of the ground below
    EXPECT_TRUE(hasNote(file.value().summary, "does not contain the terrain of the model"));
}

TEST(GribLevels, DividesGeopotentialByGravity) {
    grib::Field field;
    field.edition = 1;
    field.table = 128;
    field.type = 100;
    std::string bytes;
    for (const double pressure : {1000.0, 850.0}) {
        field.level = pressure;
        bytes += grib::wind(field, constant(pressure / 50.0), constant(0));
        grib::Field height = grib::with(field, 129, constant((1500.0 - pressure) * 9.80665));
        height.exponent = -2;
        bytes += grib::message(height);
    }
    const auto file = readGribBytes(bytes);
    expectSpeed(file, {10, 50, 500}, 20); // 1000 hPa
    expectSpeed(file, {10, 50, 650}, 17); // 850 hPa
}

TEST(GribLevels, ReadsHeightsOfEachTime) {
    std::string bytes;
    for (const int lead : {0, 6}) {
        grib::Field low = atLevel(isobaric, 1000 * pascal), high = atLevel(isobaric, 900 * pascal);
        low.lead = high.lead = lead;
        bytes += level(low, 5, 100 + 50 * lead) + level(high, 15, 1000 + 50 * lead);
    }
    const auto file = readGribBytes(bytes + orography(constant(0)));
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_NEAR(asField(file.value().wind)->velocity({10, 50, 550}, 0).x, 10, 0.01);
    EXPECT_NEAR(asField(file.value().wind)->velocity({10, 50, 850}, 21600).x, 10, 0.01);
}

TEST(GribLevels, ReadsModelLevelsInEitherOrder) {
    for (const bool upward : {true, false}) {
        const auto file = readGribBytes(level(atLevel(hybrid, upward ? 1 : 2), 5, 100) +
                                        level(atLevel(hybrid, upward ? 2 : 1), 15, 1000));
        expectSpeed(file, {10, 50, 100}, 5);
        expectSpeed(file, {10, 50, 550}, 10);
    }
}

TEST(GribLevels, SeparatesLevelsThatDoNotIncrease) {
    const auto file = readGribBytes(level(atLevel(isobaric, 1000 * pascal), 5, 100) +
                                    level(atLevel(isobaric, 900 * pascal), 15, 100));
    expectSpeed(file, {10, 50, 50}, 5);
    expectSpeed(file, {10, 50, 200}, 15);
}

TEST(GribLevels, ReadsHeightsAboveSeaLevel) {
    const std::string bytes = grib::wind(atLevel(aboveSea, 500), constant(5), constant(0)) +
                              grib::wind(atLevel(aboveSea, 1500), constant(15), constant(0));
    expectSpeed(readGribBytes(bytes), {10, 50, 1000}, 10);
    expectSpeed(readGribBytes(bytes + orography(constant(400))), {10, 50, 600}, 10);
}

TEST(GribLevels, PrefersHeightsAboveGroundWithANote) {
    const auto file = readGribBytes(twoLevels() + orography(constant(0)) +
                                    grib::wind(atLevel(103, 10), constant(3), constant(0)));
    expectSpeed(file, {10, 50, 900}, 3);
    EXPECT_TRUE(hasNote(file.value().summary,
                        "the wind at heights above ground is used; that at isobaric levels is ignored"));
}

} // namespace osgTreeWind

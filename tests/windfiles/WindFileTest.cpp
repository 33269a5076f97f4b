// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFile.h>

#include <tests/Folders.h>
#include <tests/Near.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/windfiles/Notes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

namespace {

const std::string folder = std::string(OSGTREEWIND_TEST_DATA) + "/wind/";

WindFile readSmall(const std::string& name, const WindFileOptions& options = {}) {
    const Result<WindFile> file = readWindFile(folder + name, options);
    EXPECT_TRUE(file) << firstProblem(file);
    return file ? file.value() : WindFile{};
}

} // namespace

/// The files hold u = 1 + i, v = 0.5 j, w = 0.25 k at point i, j, k of 3 x 2 x 2 from (100, 200, 5), spaced
/// by (10, 20, 5): make_small.py.
class WindFileVtk : public testing::TestWithParam<const char*> {};

TEST_P(WindFileVtk, ContainsTheLinearField) {
    const WindFile file = readSmall(GetParam());
    ASSERT_TRUE(file.wind.field);
    expectNear(asField(file.wind)->velocity({100, 200, 5}, 0), {1, 0, 0});
    expectNear(asField(file.wind)->velocity({120, 220, 10}, 0), {3, 0.5f, 0.25f});
    expectNear(asField(file.wind)->velocity({105, 210, 7.5f}, 0), {1.5f, 0.25f, 0.125f});
    EXPECT_EQ(file.summary.points, glm::ivec3(3, 2, 2));
    EXPECT_EQ(file.summary.low, glm::dvec3(100, 200, 5));
    EXPECT_EQ(file.summary.high, glm::dvec3(120, 220, 10));
    EXPECT_NEAR(file.summary.slowest, 1.0, 1e-6);
    EXPECT_NEAR(file.summary.fastest, std::sqrt(9 + 0.25 + 0.0625), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Small, WindFileVtk,
                         testing::Values("vectors.vtk", "field.vtk", "binary.vtk", "paraview.vtk",
                                         "paraviewbinary.vtk", "cells.vtk", "rectilinear.vtk",
                                         "structured.vtk", "ascii.vti", "base64.vti", "zlib.vti", "raw.vti",
                                         "rawzlib.vti", "bigendian.vti"),
                         [](const auto& info) {
                             std::string name = info.param;
                             name[name.find('.')] = '_';
                             return name;
                         });

TEST(WindFile, ReadsTimeValueOfVtk) {
    for (const char* name : {"paraview.vtk", "paraviewbinary.vtk"})
        EXPECT_EQ(readSmall(name).summary.times, std::vector<double>{42.5}) << name;
    EXPECT_TRUE(readSmall("cells.vtk").summary.times.empty());
}

TEST(WindFile, OriginMovesTheGridIntoTheScene) {
    WindFileOptions options;
    options.origin = {110, 200, 5};
    expectNear(asField(readSmall("vectors.vtk", options).wind)->velocity({0, 0, 5}, 0), {2, 0, 0.25f});
}

TEST(WindFile, ConvertsTheGivenUnitIfTheFileHasNone) {
    WindFileOptions options;
    options.speedUnit = "km/h";
    const WindFile file = readSmall("vectors.vtk", options);
    expectNear(asField(file.wind)->velocity({120, 200, 5}, 0), {3 / 3.6f, 0, 0});
    EXPECT_FALSE(hasNote(file.summary, "is assumed"));
    EXPECT_TRUE(hasNote(readSmall("vectors.vtk").summary, "gives no unit of speed; m/s is assumed"));
}

/// One record of 36 in the unit that the name of its column gives.
WindFile readNamed(const std::string& column, WindFileOptions options = {}) {
    const TemporaryFolder folder;
    options.columns.time = {"time"};
    options.columns.speed = column;
    options.columns.direction = "from";
    const auto file = readWindFile(folder.write("a.csv", "time,from," + column + "\n0,270,36\n"), options);
    EXPECT_TRUE(file) << column << ": " << firstProblem(file);
    return file ? file.value() : WindFile();
}

TEST(WindFile, ReadsTheUnitInTheNameOfAColumn) {
    for (const auto& [column, speed] : {std::pair("wind_speed_10m (km/h)", 10.0),
                                        {"Wind [kn]", 36 * 1852.0 / 3600},
                                        {"ws_mph", 36 * 0.44704},
                                        {"Vitesse (m.s-1)", 36.0},
                                        {"windspeedKmph", 10.0},
                                        {"speed (mi/h)", 36 * 0.44704}}) {
        const WindFile file = readNamed(column);
        expectNear(asField(file.wind)->velocity({}, 0), {speed, 0, 0}, 1e-4f);
        EXPECT_EQ(hasNote(file.summary, "gives the unit of speed"), speed != 36.0) << column;
    }
    EXPECT_TRUE(hasNote(readNamed("speed (avg)").summary,
                        "\"speed (avg)\" gives \"avg\", which is no known unit of speed"));
    WindFileOptions options;
    options.speedUnit = "kn";
    const WindFile file = readNamed("wind (km/h)", options);
    expectNear(asField(file.wind)->velocity({}, 0), {36 * 1852.0 / 3600, 0, 0}, 1e-4f);
    EXPECT_TRUE(hasNote(file.summary, "speed_unit, kn, replaces the unit of the file, km/h"));
}

TEST(WindFile, ReadsTheUnitInARowBelowTheHeader) {
    const TemporaryFolder folder;
    WindFileOptions options;
    options.columns.time = {"time"};
    options.columns.speed = "ws";
    options.columns.direction = "wd";
    const auto file = readWindFile(folder.write("a.csv", "time,ws,wd\ns,km/h,rad\n0,36,0\n"), options);
    ASSERT_TRUE(file) << firstProblem(file);
    expectNear(asField(file.value().wind)->velocity({}, 0), {0, -10, 0}, 1e-4f);
    EXPECT_TRUE(hasNote(file.value().summary, "the column \"ws\" gives the unit of speed, km/h"));
}

TEST(WindFile, RefusesColumnsOfTwoUnits) {
    const TemporaryFolder folder;
    WindFileOptions options;
    options.columns.time = {"time"};
    options.columns.u = "u (km/h)";
    options.columns.v = "v (kn)";
    const auto file = readWindFile(folder.write("a.csv", "time,u (km/h),v (kn)\n0,1,2\n"), options);
    EXPECT_NE(firstProblem(file).find("v (kn): expected the unit of the other columns, km/h, found 'kn'"),
              std::string::npos)
        << firstProblem(file);
}

TEST(WindFile, RefusesAnUnknownUnit) {
    WindFileOptions options;
    options.speedUnit = "furlongs";
    EXPECT_NE(firstProblem(readWindFile(folder + "vectors.vtk", options)).find("expected a unit of speed"),
              std::string::npos);
}

class WindFileEsri : public testing::TestWithParam<const char*> {};

/// South row: speeds 1, 2 and missing, from 270; north row: 4 from north, 5 from east, 6 from south.
TEST_P(WindFileEsri, ReadsThePairFromEitherFile) {
    const WindFile file = readSmall(GetParam());
    expectNear(asField(file.wind)->velocity({105, 205, 0}, 0), {1, 0, 0});
    expectNear(asField(file.wind)->velocity({115, 205, 0}, 0), {2, 0, 0});
    expectNear(asField(file.wind)->velocity({105, 215, 9}, 7), {0, -4, 0});
    expectNear(asField(file.wind)->velocity({115, 215, 0}, 0), {-5, 0, 0});
    expectNear(asField(file.wind)->velocity({125, 215, 0}, 0), {0, 6, 0});
    EXPECT_TRUE(hasNote(file.summary, "1 of 6 velocities have no data"));
    EXPECT_EQ(file.summary.slowest, 1.0) << "missing data do not count as calm";
}

INSTANTIATE_TEST_SUITE_P(Small, WindFileEsri, testing::Values("pair_vel.asc", "pair_ang.asc"),
                         [](const auto& info) { return std::string(info.param).substr(5, 3); });

/// u = 8 + index of the time, v = y / 10, w = z / 100 on y -5, 0, 5 and z 15, 25; every 0.5 s; drifting at 8
/// m/s.
TEST(WindFile, TurbSimDriftsDownwind) {
    const WindFile file = readSmall("small.bts");
    EXPECT_EQ(file.summary.points, glm::ivec3(1, 3, 2));
    expectNear(asField(file.wind)->velocity({0, 5, 25}, 1.0), {10, 0.5f, 0.25f}, 0.01f);
    expectNear(asField(file.wind)->velocity({0, -2.5f, 20}, 0.75), {9.5f, -0.25f, 0.2f}, 0.01f);
    EXPECT_EQ(asField(file.wind)->velocity({0, 0, 20}, 0.6), asField(file.wind)->velocity({4, 0, 20}, 1.1));
}

TEST(WindFile, TurbSimDriftsFromItsPlaneForAnyOrigin) {
    WindFileOptions options;
    options.origin = {-40, 0, 0};
    const WindFile file = readSmall("small.bts", options);
    expectNear(asField(file.wind)->velocity({40, 0, 15}, 0.5), {9, 0, 0.15f}, 0.01f);
}

TEST(WindFile, Toa5StartsAtItsFirstRecordAndSkipsNan) {
    const WindFile file = readSmall("toa5.dat");
    EXPECT_EQ(file.summary.unit, "m/s");
    EXPECT_EQ(file.summary.start, "2020-01-01T00:00:00.5Z");
    EXPECT_EQ(file.summary.times, (std::vector<double>{0.0, 2.0}));
    expectNear(asField(file.wind)->velocity({}, 0.0), {1, 2, 0.5f});
    expectNear(asField(file.wind)->velocity({}, 1.0), {3, 0, 0.375f});
    EXPECT_TRUE(hasNote(file.summary, "1 of 3 records have no wind and are skipped"));
}

TEST(WindFile, CsvWithDefaultNamesNeedsNoColumns) {
    WindFileOptions options;
    options.speedUnit = "km/h";
    const WindFile file = readSmall("table.csv", options);
    expectNear(asField(file.wind)->velocity({}, 0.0), {10, 0, 0});
    expectNear(asField(file.wind)->velocity({}, 10.0), {0, 5, 0});
    EXPECT_EQ(file.summary.direction, "from, degrees clockwise from north");
}

} // namespace osgTreeWind

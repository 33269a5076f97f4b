// SPDX-License-Identifier: MIT
// The one door through which records and fields come in.
#include <tests/Folders.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/windfiles/WindFormatsCases.h>

#include <osgTreeWind/windfiles/WindFile.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

std::string formatOf(const std::string& path) {
    const Result<WindContent> content = readWindContent(path, {});
    return content ? content.value().summary.format : firstProblem(content);
}

class WindFormats : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(WindFormats, AreKnownByTheirBeginningWhateverTheName) {
    const TemporaryFolder folder;
    const std::string bytes = bytesOf({GetParam(), nullptr}), file = std::string(GetParam());
    const std::string expected = formatOf(OSGTREEWIND_TEST_DATA "/wind/" + file);
    EXPECT_EQ(expected.find("no known format"), std::string::npos) << expected;
    EXPECT_EQ(formatOf(folder.write("a", bytes)), expected);
    EXPECT_EQ(formatOf(folder.write("a.csv", bytes)), expected);
    EXPECT_EQ(formatOf(folder.write("a.bts", bytes)), expected);
}

INSTANTIATE_TEST_SUITE_P(Small, WindFormats,
                         testing::Values("vectors.vtk", "zlib.vti", "toa5.dat", "sensor.xml", "small.grib1",
                                         "small.grib2"),
                         [](const auto& info) {
                             std::string name = info.param;
                             name[name.find('.')] = '_';
                             return name;
                         });

TEST(WindFormats, OnlyTheFirstKilobyteTells) {
    const TemporaryFolder folder;
    const std::string sensor = bytesOf({"sensor.xml", nullptr}), far(1024, ' ');
    EXPECT_NE(formatOf(folder.write("a", far + sensor)).find("no known format"), std::string::npos);
    EXPECT_EQ(formatOf(folder.write("a.xml", far + sensor)), "QES-Winds sensor") << "by its name then";
}

TEST(WindFormats, RecordsAreThoseOfAnyFormatThatHoldsOne) {
    const TemporaryFolder folder;
    std::string toa5 = bytesOf({"toa5.dat", nullptr});
    for (std::size_t at = 0; (at = toa5.find("\"m/s\"", at)) != std::string::npos;)
        toa5.replace(at, 5, "\"km/h\"");
    const auto slow = readWindSeries(folder.write("a.dat", toa5), {}),
               fast = readWindSeries(OSGTREEWIND_TEST_DATA "/wind/toa5.dat", {});
    ASSERT_TRUE(slow) << firstProblem(slow);
    ASSERT_TRUE(fast) << firstProblem(fast);
    EXPECT_EQ(slow.value().times, fast.value().times);
    EXPECT_NEAR(3.6 * slow.value().velocities[0].x, fast.value().velocities[0].x, 1e-5);

    WindSeriesColumns columns;
    columns.time = "t";
    columns.u = "u";
    columns.v = "v";
    columns.speedUnit = "km/h";
    const auto table = readWindSeries(folder.write("table.txt", "t,u,v\n0,36,0\n1,0,72\n"), columns);
    ASSERT_TRUE(table) << firstProblem(table) << ": whoever names columns has a table";
    EXPECT_EQ(table.value().velocities[1], glm::vec3(0, 20, 0));

    const std::string grid = OSGTREEWIND_TEST_DATA "/wind/vectors.vtk";
    EXPECT_EQ(firstProblem(readWindSeries(grid, {})),
              grid + ": expected a record at one point, found a grid: VTK legacy STRUCTURED_POINTS");
}

} // namespace osgTreeWind

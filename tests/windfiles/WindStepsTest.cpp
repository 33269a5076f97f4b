// SPDX-License-Identifier: MIT
// Several files of one time each read as one wind.
#include <tests/EnvironmentVariable.h>
#include <tests/Folders.h>
#include <tests/windfiles/NetCdfReading.h>

#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/windfiles/WindSteps.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace osgTreeWind {

namespace {

const std::string data = OSGTREEWIND_TEST_DATA "/wind/";

/// Pairs NAME_vel.asc and NAME_ang.asc of 2 x 1 cells of 10 m from (0, 0).
class Hours : public TemporaryFolder {
public:
    std::string pair(const std::string& name, const std::string& speeds, const std::string& directions,
                     const std::string& corner = "0", const std::string& size = "10") const {
        const std::string head = "ncols 2\nnrows 1\nxllcorner " + corner + "\nyllcorner 0\ncellsize " + size +
                                 "\nNODATA_value -9\n";
        write(name + "_ang.asc", head + directions);
        return write(name + "_vel.asc", head + speeds);
    }
};

WindFile readBoth(const std::string& first, const std::string& second, double from, double to) {
    const auto wind = readWindFiles({first, second}, {from, to});
    EXPECT_TRUE(wind) << firstProblem(wind);
    return wind ? wind.value() : WindFile{};
}

std::string problemOfBoth(const std::string& first, const std::string& second) {
    return firstProblem(readWindFiles({first, second}, {0, 1}));
}

/// wrf_polar.nc, whose layer is 20 m thick, with another geopotential at its top.
std::string withTop(float geopotential) {
    const auto bytesOf = [](const float& number) {
        const char* little = reinterpret_cast<const char*>(&number);
        return std::string(std::reverse_iterator(little + 4), std::reverse_iterator(little));
    };
    return renamed(fileBytes(smallNetCdf("wrf_polar.nc")), bytesOf(196.2f), bytesOf(geopotential));
}

/// A grid of one column and two layers.
WindContent column(float top, const std::string& note) {
    GridWind::Grid grid;
    grid.points = {1, 1, 2};
    grid.heights = {2.0f, top};
    grid.values = {0, 0, 0, top, 0, 0};
    WindContent content;
    content.summary.notes = {"of all", note};
    content.data = grid;
    return content;
}

} // namespace

TEST(WindSteps, IsLinearBetweenTimesAndClampedOutside) {
    const Hours hours;
    const WindFile file =
        readBoth(hours.pair("a", "4 1", "270 180"), hours.pair("b", "8 3", "270 180"), 60, 160);
    ASSERT_TRUE(file.wind.field);
    const auto at = [&](float x, double time) { return asField(file.wind)->velocity({x, 5, 10}, time); };
    for (const auto& [time, u, v] :
         {std::tuple{-1e9, 4, 1}, {60., 4, 1}, {110., 6, 2}, {160., 8, 3}, {1e9, 8, 3}}) {
        expectNear(at(5, time), {u, 0, 0}, 1e-5f);
        expectNear(at(15, time), {0, v, 0}, 1e-5f);
    }
    EXPECT_EQ(file.summary.times, (std::vector<double>{60, 160}));
    EXPECT_NEAR(file.summary.slowest, 1.0, 1e-6);
    EXPECT_NEAR(file.summary.fastest, 8.0, 1e-6);
}

/// Between 350 and 10 degrees the wind turns through north; the mean of the numbers would be south.
TEST(WindSteps, InterpolatesComponentsNotDirections) {
    const Hours hours;
    const WindFile file = readBoth(hours.pair("a", "5 5", "350 270"), hours.pair("b", "5 5", "10 90"), 0, 1);
    ASSERT_TRUE(file.wind.field);
    const float north = 5.0f * std::cos(10.0f * 3.14159265f / 180.0f);
    expectNear(asField(file.wind)->velocity({5, 5, 0}, 0.5), {0, -north, 0}, 1e-5f);
    expectNear(asField(file.wind)->velocity({15, 5, 0}, 0.5), {0, 0, 0}, 1e-5f);
}

TEST(WindSteps, AFileMayBeUsedTwice) {
    const Hours hours;
    const std::string a = hours.pair("a", "4 1", "270 180"), b = hours.pair("b", "8 3", "270 180");
    const auto wind = readWindFiles({a, b, a}, {0, 1, 2});
    ASSERT_TRUE(wind) << firstProblem(wind);
    expectNear(asField(wind.value().wind)->velocity({5, 5, 0}, 1.5), {6, 0, 0}, 1e-5f);
}

TEST(WindSteps, SingleFileIsASteadyWind) {
    const auto wind = readWindFiles({data + "vectors.vtk"}, {7});
    ASSERT_TRUE(wind) << firstProblem(wind);
    expectNear(asField(wind.value().wind)->velocity({110, 220, 5}, 0), {2, 0.5f, 0}, 1e-5f);
}

TEST(WindSteps, UsesTimesOfTheFiles) {
    const TemporaryFolder folder;
    const std::string bytes = fileBytes(data + "paraview.vtk");
    const std::string first = folder.write("a.vtk", renamed(bytes, "42.5", "10.0"));
    const std::string second =
        folder.write("b.vtk", renamed(renamed(bytes, "42.5", "20.0"), "\n1 0 0", "\n9 0 0"));
    const auto wind = readWindFiles({first, second}, {});
    ASSERT_TRUE(wind) << firstProblem(wind);
    EXPECT_EQ(wind.value().summary.times, (std::vector<double>{10, 20}));
    expectNear(asField(wind.value().wind)->velocity({100, 200, 5}, 15), {5, 0, 0}, 1e-5f);

    EXPECT_EQ(firstProblem(readWindFiles({second, first}, {})),
              first + ": expected a time after 20 s, the last time of the previous file, found 10 s");
    const std::string timeless = data + "vectors.vtk";
    EXPECT_EQ(firstProblem(readWindFiles({first, timeless}, {})),
              "times: expected one time for each file, because " + timeless + " contains no time");
    EXPECT_EQ(readBoth(second, first, 0, 1).summary.times, (std::vector<double>{0, 1}))
        << "given times replace those of the files";
}

/// A day with two times, followed by an hour of a forecast.
TEST(WindSteps, OrdersFilesByDate) {
    const auto day = [](const std::string& file) {
        WindContent content = column(10, "made");
        auto& grid = std::get<GridWind::Grid>(content.data);
        content.summary.start = file == "b" ? "2017-10-27T00:00:00Z" : "2017-10-26T00:00:00Z";
        if (file == "a") {
            grid.times = {0, 43200};
            grid.values.insert(grid.values.end(), grid.values.begin(), grid.values.end());
        } else if (file == "high")
            grid.heights.back() = 20;
        else if (file == "seconds") {
            content.summary.start.clear();
            grid.times = {90000};
        }
        return Result<WindContent>(content);
    };
    const auto wind = readWindSteps({"a", "b"}, {}, day);
    ASSERT_TRUE(wind) << firstProblem(wind);
    const auto& grid = std::get<GridWind::Grid>(wind.value().data);
    EXPECT_EQ(grid.times, (std::vector<double>{0, 43200, 86400}));
    EXPECT_EQ(wind.value().summary.start, "2017-10-26T00:00:00Z");
    EXPECT_EQ(grid.heights.size(), 2u) << "the same at all times";
    EXPECT_TRUE(GridWind::check(grid).empty());

    EXPECT_EQ(firstProblem(readWindSteps({"b", "a"}, {}, day)),
              "a: expected a time after 0 s, the last time of the previous file, found -86400 s");
    EXPECT_EQ(firstProblem(readWindSteps({"a", "seconds"}, {}, day)),
              "seconds: expected a date, as in the first file");
    EXPECT_EQ(firstProblem(readWindSteps({"seconds", "b"}, {}, day)),
              "b: expected seconds, as in the first file, found a date");
    EXPECT_EQ(firstProblem(readWindSteps({"a", "b"}, {0, 1}, day)),
              "a: expected a grid at one time, found 2 times");
}

TEST(WindSteps, HeightsMayDifferBetweenFilesOfSeveralTimes) {
    const auto read = [](const std::string& file) {
        WindContent content = column(file == "a" ? 10.0f : 20.0f, "made");
        auto& grid = std::get<GridWind::Grid>(content.data);
        content.summary.start = file == "a" ? "2017-10-26T00:00:00Z" : "2017-10-27T00:00:00Z";
        grid.times = {0, 3600};
        grid.values.insert(grid.values.end(), grid.values.begin(), grid.values.end());
        return Result<WindContent>(content);
    };
    const auto wind = readWindSteps({"a", "b"}, {}, read);
    ASSERT_TRUE(wind) << firstProblem(wind);
    const auto& grid = std::get<GridWind::Grid>(wind.value().data);
    EXPECT_EQ(grid.heights, (std::vector<float>{2, 10, 2, 10, 2, 20, 2, 20}));
    EXPECT_TRUE(GridWind::check(grid).empty());
}

TEST(WindSteps, JoinsSeveralFormats) {
    const WindFile file = readBoth(data + "vectors.vtk", data + "zlib.vti", 0, 10);
    ASSERT_TRUE(file.wind.field);
    expectNear(asField(file.wind)->velocity({110, 220, 10}, 5), {2, 0.5f, 0.25f}, 1e-5f);
}

TEST(WindSteps, CountsMissingDataOfAllFiles) {
    const Hours hours;
    const WindFile file =
        readBoth(hours.pair("a", "4 -9", "270 -9"), hours.pair("b", "8 3", "270 180"), 0, 1);
    EXPECT_TRUE(hasNote(file.summary, "1 of 4 velocities have no data"));
    EXPECT_EQ(std::count(file.summary.notes.begin(), file.summary.notes.end(),
                         "the file gives no unit of speed; m/s is assumed"),
              1);
}

TEST(WindSteps, NamesDifferencesFromTheFirstFile) {
    const Hours hours;
    const std::string a = hours.pair("a", "4 1", "270 180"), b = hours.pair("b", "4 1", "270 180", "3"),
                      c = hours.pair("c", "4 1", "270 180", "0", "11"), d = hours.pair("d", "4 1", "270 180");
    hours.write("d_vel.prj", "EPSG:32612");
    EXPECT_EQ(problemOfBoth(a, b), b + ": expected the first point of " + a + ", 5, 5, 0, found '8, 5, 0'");
    EXPECT_EQ(problemOfBoth(a, c),
              c + ": expected the first point of " + a + ", 5, 5, 0, found '5.5, 5.5, 0'");
    EXPECT_EQ(problemOfBoth(a, d),
              d + ": expected the coordinates of " + a + ", none, found 'WGS 84 / UTM zone 12N'");
    EXPECT_EQ(problemOfBoth(d, a),
              a + ": expected the coordinates of " + d + ", WGS 84 / UTM zone 12N, found nothing");
    EXPECT_EQ(problemOfBoth(a, data + "vectors.vtk"), data +
                                                          "vectors.vtk: expected the points east, north and "
                                                          "up of " +
                                                          a + ", 2, 1, 1, found '3, 2, 2'");
}

TEST(WindSteps, RefusesOtherSpacing) {
    const TemporaryFolder folder;
    const std::string wide =
        folder.write("a.vtk", renamed(fileBytes(data + "vectors.vtk"), "SPACING 10", "SPACING 11"));
    EXPECT_EQ(problemOfBoth(data + "vectors.vtk", wide),
              wide + ": expected the distances between points of " + data +
                  "vectors.vtk, 10, 20, 5, found '11, 20, 5'");
}

class WindStepsRefuse : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(WindStepsRefuse, DataThatAreNotAGridAtOneTime) {
    const auto& [name, found] = GetParam();
    const std::string file = data + name;
    if (file.find(".nc") != std::string::npos)
        REQUIRE_NETCDF(file);
    EXPECT_EQ(problemOfBoth(file, file), file + ": expected a grid at one time, found " + found);
}

INSTANTIATE_TEST_SUITE_P(Small, WindStepsRefuse,
                         testing::Values(std::pair("small.bts", "one that drifts with the wind"),
                                         std::pair("toa5.dat", "a record at one point"),
                                         std::pair("table.csv", "a record at one point"),
                                         std::pair("sensor.xml", "a record at one point"),
                                         std::pair("small.nc", "2 times")),
                         [](const auto& info) {
                             std::string name = info.param.first;
                             name[name.find('.')] = '_';
                             return name;
                         });

TEST(WindSteps, RefusesOtherUnits) {
    const TemporaryFolder folder;
    const std::string path = smallNetCdf("wrf_polar.nc");
    REQUIRE_NETCDF(path);
    const std::string knots = folder.write("kn.nc", renamed(fileBytes(path), "m s-1", "knots"));
    EXPECT_EQ(problemOfBoth(path, knots),
              knots + ": expected the unit of speed of " + path + ", m/s, found 'kn'");
}

TEST(WindSteps, RefusesOtherHeightsOfLayers) {
    const TemporaryFolder folder;
    const std::string path = smallNetCdf("truenorth.nc"); // 10 m above ground
    REQUIRE_NETCDF(path);
    const std::string higher =
        folder.write("a.nc", renamed(fileBytes(path), {"\x41\x20\0\0", 4}, {"\x41\xa0\0\0", 4}));
    EXPECT_EQ(problemOfBoth(path, higher), higher + ": expected the heights of " + path);
}

TEST(WindSteps, HeightsOfPointsMayDiffer) {
    const TemporaryFolder folder;
    const std::string path = smallNetCdf("wrf_polar.nc");
    REQUIRE_NETCDF(path);
    const WindFile file = readBoth(path, folder.write("a.nc", withTop(392.4f)), 0, 3600);
    EXPECT_NEAR(file.summary.low.z, 10.0, 1e-4);
    EXPECT_NEAR(file.summary.high.z, 20.0, 1e-4);
    EXPECT_EQ(file.summary.times.size(), 2u);
}

TEST(WindSteps, NamesTheFileOfInvalidHeights) {
    const TemporaryFolder folder;
    const std::string path = smallNetCdf("wrf_polar.nc");
    REQUIRE_NETCDF(path);
    const std::string bad = folder.write("a.nc", withTop(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(problemOfBoth(path, bad),
              bad + ": heights: expected finite metres, increasing upward, found nan at index 0");
}

TEST(WindSteps, HeightsOfASingleColumnMayDiffer) {
    const auto wind = readWindSteps({"10", "30", "30"}, {0, 1, 2}, [](const std::string& top) {
        return Result<WindContent>(column(std::stof(top), "top"));
    });
    ASSERT_TRUE(wind) << firstProblem(wind);
    const auto field = GridWind::create(std::get<GridWind::Grid>(wind.value().data));
    ASSERT_TRUE(field) << firstProblem(field);
    EXPECT_NEAR(field.value()->velocity({0, 0, 6}, 0).x, 5.0f, 1e-5f);
    EXPECT_NEAR(field.value()->velocity({0, 0, 16}, 1).x, 15.0f, 1e-5f);
}

TEST(WindSteps, NotesOfLaterFilesBeginWithTheFileName) {
    const auto wind = readWindSteps({"a", "b"}, {0, 1}, [](const std::string& name) {
        return Result<WindContent>(column(10, "of " + name));
    });
    ASSERT_TRUE(wind) << firstProblem(wind);
    EXPECT_EQ(wind.value().summary.notes, (std::vector<std::string>{"of all", "of a", "b: of b"}));
}

TEST(WindSteps, NamesAnInvalidFile) {
    const Hours hours;
    const std::string good = hours.pair("a", "4 1", "270 180"), fast = hours.pair("b", "4 201", "270 180"),
                      empty = hours.pair("c", "-9 -9", "-9 -9"), broken = hours.pair("d", "4 x", "270 180");
    EXPECT_EQ(problemOfBoth(good, fast),
              fast + ": expected winds of at most 200 m/s; number 2 of 2 is faster");
    EXPECT_EQ(problemOfBoth(good, empty), empty + ": has no data at any of 2 places and times");
    EXPECT_EQ(problemOfBoth(good, broken), broken + ":7: expected a number, found 'x'");
    EXPECT_EQ(problemOfBoth(good, "absent.asc"), "absent.asc: no such file");
}

TEST(WindSteps, RequiresOneIncreasingTimeForEachFile) {
    const std::string a = data + "vectors.vtk";
    const auto problem = [&](const std::vector<double>& times) {
        return firstProblem(readWindFiles({a, a}, times));
    };
    EXPECT_EQ(problem({0}), "times: expected 2 numbers, one for each file, found 1");
    EXPECT_EQ(problem({3, 3}), "times: expected increasing seconds, found times[1] = 3 after 3");
    EXPECT_EQ(problem({0, std::numeric_limits<double>::quiet_NaN()}),
              "times: expected seconds within 1e15, found times[1] = nan");
    EXPECT_EQ(firstProblem(readWindFiles({}, {})), "files: expected at least one");
}

TEST(WindSteps, RefusesMoreThanTheMemoryLimit) {
    const auto read = [](const std::string&) {
        WindContent content;
        auto& grid = std::get<GridWind::Grid>(content.data);
        grid.points = {100, 10, 1};
        grid.values.resize(3000, 1.0f);
        return Result<WindContent>(content);
    };
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "30k");
    const std::string problem = firstProblem(readWindSteps({"a", "b", "c"}, {0, 1, 2}, read));
    EXPECT_EQ(problem.find("c: all files up to this one need about 36 kB of memory"), 0u) << problem;
}

} // namespace osgTreeWind

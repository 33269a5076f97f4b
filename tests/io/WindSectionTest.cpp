// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/places/RasterFile.h>
#include <tests/windfiles/NetCdfWriting.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/io/ForestFile.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace osgTreeWind {

namespace {

Result<ForestFile> readWith(const std::string& wind, const std::string& origin = "") {
    std::istringstream document("version = 1\n" + origin + "[[tree]]\nposition = [1000, 2000]\n[wind]\n" +
                                wind);
    return readForest(document, {"f.treewind", std::string(OSGTREEWIND_TEST_DATA) + "/wind"});
}

glm::vec3 windOf(const Result<ForestFile>& forest, const glm::vec3& position, double time = 0.0) {
    EXPECT_TRUE(forest) << firstProblem(forest);
    return forest && forest.value().wind.field ? asField(forest.value().wind)->velocity(position, time)
                                               : glm::vec3(-999.0f);
}

} // namespace

TEST(WindSection, FileIsReadInWorldCoordinates) {
    const auto forest =
        readWith("kind = \"file\"\nfile = \"vectors.vtk\"\nbeyond = \"hold\"\n", "origin = [110, 200, 0]\n");
    EXPECT_EQ(windOf(forest, {0, 0, 5}), glm::vec3(2, 0, 0));
    EXPECT_EQ(windOf(forest, {10, 20, 10}), glm::vec3(3, 0.5f, 0.25f));
}

/// A wind from the west at 11.9 E, 47 N, in degrees; the meridian convergence in UTM zone 32 is 2.12 degrees.
TEST(WindSection, ReprojectsWindOfAnotherMap) {
    const TemporaryFolder folder;
    RasterFile pair;
    pair.transform = {11.5, 0.25, 0, 47.5, 0, -0.25};
    pair.crs = "EPSG:4326";
    pair.value = [](int, int) { return 270.0; };
    (void)pair.write(folder.path() + "/w_ang.tif");
    pair.value = [](int column, int) { return 10.0 + column; };
    (void)pair.write(folder.path() + "/w_vel.tif");
    std::istringstream document("version = 1\ncrs = \"EPSG:32632\"\norigin = [720431, 5209254, 800]\n"
                                "[[tree]]\nposition = [720431, 5209254]\n"
                                "[[tree]]\nposition = [760000, 5209254]\n[wind]\nfile = \"w_vel.tif\"\n");
    const auto forest = readForest(document, {"f.treewind", folder.path()});
    const glm::vec3 wind = windOf(forest, {0, 0, 10});
    EXPECT_NEAR(wind.x, 11.1f * std::cos(0.03702f), 0.02f); // between the centres 11.625 and 11.875, 12.125
    EXPECT_NEAR(wind.y / wind.x, std::tan(0.03702f), 2e-4f);
    ASSERT_FALSE(forest.value().notes.empty());
    EXPECT_TRUE(hasPart(forest.value().notes.back(), "1 of 2 trees stand outside the grid of"));
}

TEST(WindSection, DateNeedsFilesWithDates) {
    for (const auto& [wind, part] :
         {std::pair("kind = \"uniform\"\nvelocity = [1, 0, 0]\ndate = 2017-10-26T15:00:00Z\n",
                    "wind.date: expected a wind from files whose times are dates"),
          {"kind = \"calm\"\ndate = \"2017-10-26T15:00Z\"\n",
           "wind.date: expected a wind from files whose times are dates"},
          {"kind = \"calm\"\ndate = 2017-10-26T15:00:00Z\nstart = 5\n",
           "wind.date: give either this or start"},
          {"kind = \"calm\"\ndate = \"noon\"\n",
           "wind.date: expected a date and time, as 2017-10-26T15:00:00Z, found 'noon'"}})
        EXPECT_TRUE(hasPart(firstProblem(readWith(wind)), part));
}

const char* const record =
    "kind = \"series\"\ntimes = [0, 10, 20]\nvelocities = [[2, 0, 0], [6, 0, 0], [2, 0, 0]]\n";

TEST(WindSection, RecordTravelsOverTheForest) {
    for (const char* travel : {"travel = \"mean\"\n", "travel = [4, 0]\n"}) {
        const auto forest = readWith(record + std::string(travel));
        EXPECT_EQ(windOf(forest, {}, 10.0), glm::vec3(6, 0, 0)) << travel;
        EXPECT_EQ(windOf(forest, {40, 99, 0}, 20.0), glm::vec3(6, 0, 0)) << travel;
        EXPECT_EQ(windOf(forest, {-40, 0, 0}, 0.0), glm::vec3(6, 0, 0)) << travel;
        std::ostringstream text;
        ASSERT_TRUE(writeForest(forest.value(), text).empty());
        std::istringstream again(text.str());
        EXPECT_EQ(windOf(readForest(again, {"f.treewind", "."}), {40, 0, 0}, 20.0), glm::vec3(6, 0, 0));
    }
}

TEST(WindSection, TravelNeedsAMovingWind) {
    for (const auto& [wind, part] :
         {std::pair(record + std::string("travel = [0, 0.05]\n"),
                    "wind.travel: expected 0.1 m/s or more, found 0.05"),
          {record + std::string("travel = \"fast\"\n"),
           "wind.travel: expected \"mean\" or [u, v] in m/s, found"},
          {record + std::string("travel = [1, 2, 3]\n"), "wind.travel: "},
          {"kind = \"calm\"\ntravel = \"mean\"\n", "wind.travel: \"mean\" needs a record"}})
        EXPECT_TRUE(hasPart(firstProblem(readWith(wind)), part));
}

TEST(WindSection, OffsetMovesTheFile) {
    const auto forest = readWith("kind = \"file\"\nfile = \"vectors.vtk\"\noffset = [900, 1800, 5]\n",
                                 "origin = [1010, 2000, 0]\n");
    EXPECT_EQ(windOf(forest, {0, 0, 10}), glm::vec3(2, 0, 0));
}

TEST(WindSection, ConvertsTheSpeedUnit) {
    const auto forest =
        readWith("kind = \"file\"\nfile = \"vectors.vtk\"\nspeed_unit = \"km/h\"\nbeyond = \"hold\"\n",
                 "origin = [120, 200, 0]\n");
    EXPECT_FLOAT_EQ(windOf(forest, {0, 0, 5}).x, 3 / 3.6f);
}

TEST(WindSection, VariableNamesTheArrays) {
    const TemporaryFolder folder;
    folder.write("w.vtk",
                 "# vtk DataFile Version 3.0\none point\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n"
                 "POINT_DATA 1\nFIELD f 3\na 1 1 float\n1\nb 1 1 float\n2\nc 3 1 float\n3 4 5\n");
    for (const auto& [variable, velocity] :
         {std::pair("\"c\"", glm::vec3(3, 4, 5)), {"[\"c\"]", {3, 4, 5}}, {"[\"a\", \"b\"]", {1, 2, 0}}}) {
        std::istringstream document(
            "version = 1\n[[tree]]\nposition = [0, 0]\n[wind]\nfile = \"w.vtk\"\nvariable = " +
            std::string(variable));
        const auto forest = readForest(document, {"f.treewind", folder.path()});
        EXPECT_EQ(windOf(forest, {}), velocity) << variable;
        std::ostringstream text;
        ASSERT_TRUE(writeForest(forest.value(), text).empty());
        std::istringstream again(text.str());
        EXPECT_EQ(windOf(readForest(again, {"f.treewind", "."}), {}), velocity) << text.str();
    }
}

TEST(WindSection, ReportsTheLineOfABrokenFile) {
    const auto forest = readWith("kind = \"file\"\nfile = \"small.cdl\"\n");
    EXPECT_TRUE(hasPart(firstProblem(forest), "small.cdl: unknown format of wind data"));
}

TEST(WindSection, RequiresAFile) {
    EXPECT_TRUE(hasPart(firstProblem(readWith("kind = \"file\"\n")), "wind.file"));
}

TEST(WindSection, FilesAreTimeStepsOfOneWind) {
    const TemporaryFolder folder;
    const std::string head = "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    folder.write("1_vel.asc", head + "4\n");
    folder.write("1_ang.asc", head + "270\n");
    folder.write("2_vel.asc", head + "6\n");
    folder.write("2_ang.asc", head + "180\n");
    std::istringstream document("version = 1\n[[tree]]\nposition = [0, 0]\n[wind]\nkind = \"file\"\n"
                                "files = [\"1_vel.asc\", \"2_vel.asc\"]\ntimes = [0, 3600]\n"
                                "speed_unit = \"km/h\"\ntime_scale = 60\n");
    const auto forest = readForest(document, {"f.treewind", folder.path()});
    EXPECT_FLOAT_EQ(windOf(forest, {}, 0).x, 4 / 3.6f);
    const glm::vec3 between = windOf(forest, {}, 45);
    EXPECT_NEAR(between.x, 0.25f * 4 / 3.6f, 1e-5f);
    EXPECT_NEAR(between.y, 0.75f * 6 / 3.6f, 1e-5f);
}

TEST(WindSection, RejectsAFileUnlikeTheFirst) {
    const auto forest =
        readWith("kind = \"file\"\nfiles = [\"vectors.vtk\", \"pair_vel.asc\"]\ntimes = [0, 1]\n");
    EXPECT_TRUE(hasPart(firstProblem(forest), "pair_vel.asc: expected the points"));
}

TEST(WindSection, DateChoosesTheMomentOfARecordInATable) {
    const TemporaryFolder folder;
    folder.write("w.csv", "t,u,v\n2024-02-03 12:00,2,0\n2024-02-03 13:00,8,0\n");
    const auto forest = readForestFile(
        folder.write("a.treewind",
                     "version = 1\n[[tree]]\nposition = [0, 0]\n[wind]\nkind = \"series\"\nfile = \"w.csv\"\n"
                     "date = 2024-02-03T12:30:00Z\ncolumns = { time = \"t\", u = \"u\", v = \"v\" }\n"));
    ASSERT_TRUE(forest) << firstProblem(forest);
    EXPECT_NEAR(asField(forest.value().wind)->velocity({}, 0.0).x, 5.0, 1e-5);
}

TEST(WindSection, NotesOfAFileAreNotesOfTheForest) {
    const auto forest = readWith("file = \"pair_vel.asc\"\n" // `kind` may be omitted
                                 "offset = [890, 1790, 0]\n",
                                 "search = [\"" OSGTREEWIND_TEST_DATA "/wind\"]\n");
    ASSERT_TRUE(forest) << firstProblem(forest);
    ASSERT_FALSE(forest.value().notes.empty());
    EXPECT_TRUE(hasPart(joined(forest.value().notes), "pair_vel.asc: the file gives no unit of speed"));
}

/// A forest in Sydney in the wind of Germany, as ERA5 writes it.
TEST(WindSection, RefusesAWindOfAnotherCountry) {
    const TemporaryFolder folder;
    const Numbers longitudes = numbersFrom(5.0, 0.25, 41), latitudes = numbersFrom(55.0, -0.25, 33);
    const auto five = valuesOver(latitudes, longitudes, [](double, double) { return 5.0; });
    {
        NetCdfWriter(folder.path() + "/era5.nc")
            .axis("longitude", longitudes, "degrees_east")
            .axis("latitude", latitudes, "degrees_north")
            .array("u10", {"latitude", "longitude"}, metresPerSecond, five)
            .array("v10", {"latitude", "longitude"}, metresPerSecond, five);
    }
    const auto readIn = [&](const std::string& keys) {
        std::istringstream input("version = 1\ncrs = \"EPSG:32756\"\n[[tree]]\nposition = [334000, 6252000]\n"
                                 "[wind]\nfile = \"era5.nc\"\n" +
                                 keys);
        return readForest(input, {"test.treewind", folder.path()});
    };
    const std::string problem = firstProblem(readIn(""));
    EXPECT_TRUE(hasPart(problem,
                        "era5.nc, x 5 to 15, y 47 to 55 of WGS 84; the trees stand at x 334000 to 334000, "
                        "y 6252000 to 6252000 of EPSG:32756; "));
    const auto held = readIn("beyond = \"hold\"\n");
    ASSERT_TRUE(held) << firstProblem(held);
    EXPECT_TRUE(hasPart(held.value().notes.back(), "1 of 1 trees stand outside the grid of"));
}

TEST(WindSection, NotesTreesOutsideTheGrid) {
    const std::string file = "file = \"vectors.vtk\"\n"; // x 100 to 120, y 200 to 220; the tree at 1000, 2000
    const auto lastNote = [](const Result<ForestFile>& forest) {
        EXPECT_TRUE(forest) << firstProblem(forest);
        return forest && !forest.value().notes.empty() ? forest.value().notes.back() : std::string();
    };
    const std::string problem = firstProblem(readWith(file));
    EXPECT_TRUE(hasPart(problem, "no tree is inside the grid of"));
    EXPECT_TRUE(
        hasPart(problem, "x 100 to 120, y 200 to 220; the trees stand at x 1000 to 1000, y 2000 to 2000; "));
    EXPECT_TRUE(
        hasPart(firstProblem(readWith(file + "offset = [880, 1780, 0]\nbeyond = \"ebb\"\n")), "wind.beyond"));
    const std::string hold = file + "beyond = \"hold\"\n", note = lastNote(readWith(hold));
    EXPECT_EQ(note.rfind("1 of 1 trees stand outside the grid of ", 0), 0u) << note;
    EXPECT_TRUE(hasPart(note, "vectors.vtk, x 100 to 120, y 200 to 220; they get the wind at its edge"));
    EXPECT_EQ(lastNote(readWith(file + "offset = [880, 1780, 0]\n")).find("outside"), std::string::npos);
    EXPECT_TRUE(hasPart(lastNote(readWith(hold + "offset = [901.0049, 1780, 0]\n")),
                        "x 1001 to 1021, y 1980 to 2000;"));
    EXPECT_EQ(
        lastNote(readWith(file + "offset = [880, 1780, 0]\n", "origin = [900, 1900, 0]\n")).find("outside"),
        std::string::npos);
}

TEST(WindSection, RecordAtOnePointCoversAllTrees) {
    const auto forest = readWith("file = \"table.csv\"\n");
    ASSERT_TRUE(forest) << firstProblem(forest);
    for (const std::string& note : forest.value().notes)
        EXPECT_EQ(note.find("outside"), std::string::npos) << note;
}

TEST(WindSection, FilesWithKeysOfOtherKindsNeedAKind) {
    for (const char* wind : {"file = \"table.csv\"\ncolumns = { time = \"time\" }\n",
                             "file = \"values.txt\"\npoints = [2, 2]\ncell = [1, 1]\n"})
        EXPECT_TRUE(hasPart(firstProblem(readWith(wind)), "wind.kind"));
}

TEST(WindSection, GustsVaryAroundTheMean) {
    const auto forest = readWith("kind = \"gusts\"\nspeed = 36\nunit = \"km/h\"\ndirection_from = 270\n"
                                 "intensity = 0.1\nlength_scale = 30\n");
    const WindFieldPtr wind = asField(forest.value().wind);
    glm::vec3 sum(0.0f);
    for (int i = 0; i < 4000; ++i)
        sum += wind->velocity({0, 0, 5}, 2.0 * i);
    EXPECT_NEAR(sum.x / 4000, 10.0f, 0.2f);
    EXPECT_NEAR(sum.y / 4000, 0.0f, 0.2f);
    EXPECT_NE(wind->velocity({0, 0, 5}, 0.0), wind->velocity({0, 0, 5}, 1.0));
}

TEST(WindSection, GustsUseTheSeedOfTheForest) {
    const std::string gusts = "kind = \"gusts\"\nvelocity = [10, 0, 0]\n";
    const glm::vec3 one = windOf(readWith(gusts), {}), two = windOf(readWith(gusts, "seed = 2\n"), {});
    EXPECT_NE(one, two);
    EXPECT_EQ(two, windOf(readWith(gusts + "seed = 2\n"), {}));
}

TEST(WindSection, GustsWithAProfileVanishAtTheGround) {
    const auto forest = readWith("kind = \"gusts\"\nvelocity = [10, 0, 0]\nheight = 10\nroughness = 0.5\n");
    EXPECT_EQ(windOf(forest, {0, 0, 0.1f}), glm::vec3(0.0f));
}

TEST(WindSection, AnyFieldCanHaveGusts) {
    const std::string file =
        "kind = \"file\"\nfile = \"pair_vel.asc\"\noffset = [900, 1800, 0]\nbeyond = \"hold\"\n";
    const std::string grid = "kind = \"grid\"\npoints = [2, 1]\ncell = [9, 9]\nvalues = [3, 0, 0, 4, 1, 0]\n";
    const std::string keys = "intensity = 0.3\nlength_scale = 25\n";
    for (const std::string& wind : {file, grid, record + std::string()}) {
        const auto steady = readWith(wind), gusty = readWith(wind + keys, "seed = 5\n");
        EXPECT_NE(windOf(steady, {1, 2, 9}, 3.0), windOf(gusty, {1, 2, 9}, 3.0)) << wind;
        EXPECT_EQ(windOf(steady, {1, 2, 9}, 3.0), windOf(readWith(wind + "intensity = 0\n"), {1, 2, 9}, 3.0));
        std::ostringstream text;
        ASSERT_TRUE(writeForest(gusty.value(), text).empty());
        std::istringstream again(text.str());
        const auto back = readForest(again, {"f.treewind", "."});
        EXPECT_EQ(windOf(back, {1, 2, 9}, 3.0), windOf(gusty, {1, 2, 9}, 3.0)) << text.str();
        EXPECT_EQ(back.value().wind.gusts.lengthScale, 25.0);
        EXPECT_EQ(back.value().wind.gusts.seed, 5u) << "that of the forest";
    }
    const auto known = readWith(grid + keys + "deviations = [1, 2]\n");
    ASSERT_TRUE(known) << firstProblem(known);
    EXPECT_NE(windOf(known, {1, 2, 9}, 3.0), windOf(readWith(grid + keys), {1, 2, 9}, 3.0));
    ASSERT_FALSE(known.value().notes.empty());
    EXPECT_TRUE(hasPart(known.value().notes.back(), "gusts have the strength of the turbulence"));
    EXPECT_TRUE(hasPart(firstProblem(readWith(grid + "deviations = [1]\n")),
                        "wind.deviations: expected one number for each point and time, found 1"));
    EXPECT_TRUE(hasPart(firstProblem(readWith(grid + "deviations = [1, -1]\n")), "wind.deviations: "));
    EXPECT_TRUE(hasPart(firstProblem(readWith(grid + "intensity = -0.1\n")),
                        "f.treewind:9:13: wind.intensity: expected a finite number in [0, 1], found -0.1"));
    EXPECT_TRUE(hasPart(firstProblem(readWith(file + "intensity = 1.5\n")), "wind.intensity: expected"));
    EXPECT_TRUE(hasPart(firstProblem(readWith(file + "length_scale = 0\n")), "wind.length_scale: expected"));
    EXPECT_TRUE(hasPart(firstProblem(readWith("kind = \"calm\"\nintensity = 0.2\n")), "wind.intensity"));
}

} // namespace osgTreeWind

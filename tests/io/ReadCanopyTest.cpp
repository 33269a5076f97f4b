// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/windfiles/NetCdfWriting.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/ForestStream.h>
#include <osgTreeWind/io/TiledForest.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace osgTreeWind {

namespace {

const char* const wood = "[[scatter]]\ncount = 900\narea = [0, 0, 120, 120]\nspecies = [\"beech\"]\n"
                         "height = [14, 16]\ncrown_width = [6, 7]\n";
const char* const park = "[[scatter]]\ncount = 100\narea = [0, 0, 400, 400]\nspacing = 20\n"
                         "species = [\"beech\"]\nheight = [14, 16]\ncrown_width = [6, 7]\n";
const char* const savanna = "[[scatter]]\ncount = 1500\narea = [200, 0, 1400, 1200]\nspacing = 20\n"
                            "species = [\"beech\"]\nheight = [14, 16]\ncrown_width = [6, 7]\n";
const char* const uniform = "kind = \"uniform\"\nvelocity = [8, 0, 0]\n";

Result<ForestFile> read(const std::string& trees, const std::string& wind, const std::string& head = "",
                        const std::string& folder = OSGTREEWIND_TEST_DATA "/wind") {
    std::istringstream document("version = 1\n" + head + trees +
                                (wind.empty() ? std::string() : "[wind]\n" + wind));
    return readForest(document, {"f.treewind", folder});
}

std::string fileWind(const std::string& name) {
    return "file = \"" + name + "\"\nbeyond = \"hold\"\n";
}

CanopySource sourceOf(const Result<ForestFile>& forest) {
    EXPECT_TRUE(forest) << firstProblem(forest);
    return forest ? forest.value().canopy.source : CanopySource::Given;
}

std::size_t notesOn(const ForestFile& forest, const std::string& part) {
    return static_cast<std::size_t>(
        std::count_if(forest.notes.begin(), forest.notes.end(),
                      [&](const std::string& note) { return hasPart(note, part); }));
}

} // namespace

/// Winds whose source cannot know the trees; files in tests/data/wind.
TEST(ReadCanopyTest, AClosedWoodChangesAWindThatKnowsNoTrees) {
    for (const char* wind : {uniform, "kind = \"gusts\"\nvelocity = [8, 0, 0]\n",
                             "kind = \"series\"\ntimes = [0, 10]\nvelocities = [[2, 0, 0], [6, 0, 0]]\n"}) {
        EXPECT_EQ(sourceOf(read(wood, wind)), CanopySource::Forest) << wind;
        EXPECT_EQ(sourceOf(read(park, wind)), CanopySource::None) << wind;
    }
}

/// All formats of files in turn, with the same trees.
TEST(ReadCanopyTest, FilesOfFlowModelsMayKnowTheTrees) {
    REQUIRE_NETCDF(smallNetCdf("small.nc"));
    for (const char* name : {"pair_vel.asc", "small.bts", "toa5.dat", "sensor.xml", "table.csv",
                             "wrf_lambert.nc", "truenorth.nc"})
        EXPECT_EQ(sourceOf(read(wood, fileWind(name))), CanopySource::Forest) << name;
    for (const char* name : {"small.grib1", "small.grib2"})
        EXPECT_EQ(sourceOf(read(wood, fileWind(name), "crs = \"EPSG:32632\"\n")), CanopySource::Forest)
            << name;
    for (const char* name : {"vectors.vtk", "binary.vtk", "ascii.vti", "small.nc"})
        EXPECT_EQ(sourceOf(read(wood, fileWind(name))), CanopySource::None) << name;
}

TEST(ReadCanopyTest, AWindThatMayKnowTheTreesStays) {
    for (const std::string wind :
         {"", "kind = \"calm\"\n", "file = \"vectors.vtk\"\nbeyond = \"hold\"\n",
          "kind = \"grid\"\norigin = [0, 0, 0]\npoints = [1, 1]\ncell = [1, 1]\nvalues = [8, 0, 0]\n",
          "kind = \"forest_wind\"\nwidth = 1\nlength = 1\nvalues = [8, 0, 0]\n"})
        EXPECT_EQ(sourceOf(read(wood, wind)), CanopySource::None) << wind;
}

TEST(ReadCanopyTest, TheKeyOverridesTheDecision) {
    EXPECT_EQ(sourceOf(read(wood, std::string(uniform) + "canopy = \"none\"\n")), CanopySource::None);
    EXPECT_EQ(sourceOf(read(wood, std::string(uniform) + "canopy = \"given\"\n")), CanopySource::Given);
    EXPECT_EQ(sourceOf(read(wood, std::string(uniform) + "canopy = \"auto\"\n")), CanopySource::Forest);
    EXPECT_EQ(sourceOf(read(park, std::string(uniform) + "canopy = \"forest\"\n")), CanopySource::Forest);
    EXPECT_EQ(sourceOf(read(wood, "canopy = \"auto\"\nkind = \"calm\"\n")), CanopySource::None);
}

TEST(ReadCanopyTest, TheLawsOfTheThesisKeepTheirWind) {
    for (const char* law : {"thesis", "thesis-smooth"})
        EXPECT_EQ(sourceOf(read(wood, uniform, "motion.law = \"" + std::string(law) + "\"\n")),
                  CanopySource::None);
}

TEST(ReadCanopyTest, OneNoteNamesTheDecisionAndTheKey) {
    EXPECT_EQ(notesOn(read(wood, uniform).value(), "wind.canopy = \"forest\""), 1u);
    EXPECT_EQ(notesOn(read(std::string(wood) + savanna, uniform).value(), "wind.canopy = \"none\""), 1u);
    EXPECT_EQ(notesOn(read(park, uniform).value(), "canopy"), 0u);
    EXPECT_EQ(notesOn(read(wood, std::string(uniform) + "canopy = \"forest\"\n").value(), "canopy"), 0u);
    EXPECT_EQ(notesOn(read("[[tree]]\nposition = [0, 0]\n", uniform).value(), "canopy"), 0u);
}

/// The decision is written, so that trees that are added or removed do not change it.
TEST(ReadCanopyTest, WritersWriteTheDecision) {
    for (const auto& [trees, source, line] : {std::tuple(wood, CanopySource::Forest, "canopy = \"forest\"\n"),
                                              {park, CanopySource::None, "canopy = \"none\"\n"}}) {
        auto forest = read(trees, uniform);
        ASSERT_TRUE(forest) << firstProblem(forest);
        forest.value().trees.resize(1);
        std::ostringstream text;
        ASSERT_TRUE(writeForest(forest.value(), text).empty());
        EXPECT_TRUE(hasPart(text.str(), line));
        std::istringstream again(text.str());
        EXPECT_EQ(sourceOf(readForest(again, {"f.treewind", ""})), source);
    }
}

/// A stream decides as a file does, `tile` writes it, and a world without the key, as 1.0 wrote it, decides
/// by the summary of its crowns.
TEST(ReadCanopyTest, WorldsDecideAsForests) {
    for (const auto& [trees, source] : {std::pair(wood, CanopySource::Forest), {park, CanopySource::None}}) {
        const TemporaryFolder folder;
        folder.write("f.treewind", "version = 1\n" + std::string(trees) + "[wind]\n" + uniform);
        const auto stream = ForestStream::read(folder.path() + "/f.treewind", {folder.path()});
        ASSERT_TRUE(stream) << firstProblem(stream);
        EXPECT_EQ(stream.value().file().canopy.source, source);
        ASSERT_TRUE(writeTiledForest(stream.value(), folder.path() + "/world"));
        const std::string file = folder.path() + "/world/world.treewind";
        EXPECT_EQ(sourceOf(readForestFile(file)), source);

        std::string text = (std::ostringstream() << std::ifstream(file).rdbuf()).str();
        const std::string key =
            source == CanopySource::Forest ? "canopy = \"forest\"\n" : "canopy = \"none\"\n";
        ASSERT_TRUE(hasPart(text, key));
        folder.write("world/world.treewind", text.erase(text.find(key), key.size()));
        EXPECT_EQ(sourceOf(readForestFile(file)), source);
    }
}

} // namespace osgTreeWind

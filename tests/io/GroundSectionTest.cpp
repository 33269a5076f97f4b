// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>
#include <tests/places/GeoJson.h>
#include <tests/places/RasterFile.h>

#include <osgTreeWind/forest/StandOnGround.h>
#include <osgTreeWind/places/FunctionGround.h>
#include <osgTreeWind/places/RasterGround.h>

namespace osgTreeWind {

namespace {

ForestFile forestIn(const std::string& folder, const std::string& text) {
    std::istringstream input("version = 1\n" + text);
    const auto forest = readForest(input, {"test.treewind", folder});
    for (const Diagnostic& problem : forest.problems())
        ADD_FAILURE() << problem.text();
    return forest ? forest.value() : ForestFile();
}

const std::string ground = "[ground]\nfile = \"a.tif\"\n";
const std::string thin = "trunk_diameter = 0.002\n"; // the foot is hardly lower than the trunk's centre

/// A raster of 100 m x 100 m that rises eastward by 0.5 m per metre.
RasterFile slope() {
    RasterFile file;
    file.columns = file.rows = 100;
    file.transform = {0, 1, 0, 100, 0, -1};
    file.value = [](int column, int) { return 1000.0 + 0.5 * (column + 0.5); };
    return file;
}

} // namespace

TEST(GroundSection, PlacesOnlyTreesWithoutAHeight) {
    const TemporaryFolder folder;
    slope().write(folder.path() + "/a.tif");
    folder.write("a.csv", "x,y,z\n50,50,1026\n50,50,\n");
    const ForestFile forest = forestIn(
        folder.path(), "[[tree]]\nposition = [20, 50]\n" + thin + "[[tree]]\nposition = [20, 50, 3]\n" +
                           thin + "[[scatter]]\ncount = 5\narea = [10, 10, 90, 90]\n" + thin +
                           "[[inventory]]\nfile = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", z = \"z\" }\n"
                           "[[inventory]]\nfile = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\" }\n" +
                           ground);
    ASSERT_EQ(forest.trees.size(), 11u);
    ASSERT_TRUE(forest.ground);
    EXPECT_NEAR(forest.trees[0].position.z, 1010.0, 0.01);
    EXPECT_EQ(forest.trees[1].position.z, 3.0);
    for (std::size_t i = 2; i < 7; ++i)
        EXPECT_NEAR(forest.trees[i].position.z, 1000.0 + 0.5 * forest.trees[i].position.x, 0.01);
    EXPECT_EQ(forest.trees[7].position.z, 1026.0);
    EXPECT_NEAR(forest.trees[8].position.z, 1025.0, 0.5);
    EXPECT_NEAR(forest.trees[9].position.z, 1025.0, 0.5);
    EXPECT_EQ(forest.origin, glm::dvec3(0.0)) << "the trees are near it";
}

/// As in the landscape files of LANDFIRE: elevation, slope, aspect, ...
TEST(GroundSection, ReadsOneBandOfSeveral) {
    const TemporaryFolder folder;
    RasterFile file = slope();
    file.bands = 3;
    file.bandStep = 100.0;
    file.names = {"US Slope", "US Elevation (m)", "US Aspect"};
    file.write(folder.path() + "/a.tif");
    const std::string tree = "[[tree]]\nposition = [20, 50]\n" + thin;
    const auto height = [&](const std::string& key) {
        return forestIn(folder.path(), tree + ground + key).trees.at(0).position.z;
    };
    EXPECT_NEAR(height(""), 1110.0, 0.01) << "the only one whose name contains elevation";
    EXPECT_NEAR(height("band = \"US Aspect\"\n"), 1210.0, 0.01);
    EXPECT_NEAR(height("band = 1\n"), 1010.0, 0.01);
    for (const char* band : {"4", "\"Height\""}) {
        std::istringstream input("version = 1\n" + tree + ground + "band = " + band + "\n");
        const auto forest = readForest(input, {"test.treewind", folder.path()});
        EXPECT_TRUE(hasPart(firstProblem(forest), "among its 3; gdalinfo lists them"));
    }
}

TEST(GroundSection, FootIsAtTheLowestPointOfTheTrunk) {
    const TemporaryFolder folder;
    slope().write(folder.path() + "/a.tif");
    const ForestFile forest =
        forestIn(folder.path(),
                 "[[tree]]\nposition = [20, 50]\ntrunk_diameter = 0.8\nheight = 15\n"
                 "[[tree]]\nposition = [20, 50]\nheight = 15\n[[tree]]\nposition = [20, 50]\nheight = 30\n" +
                     ground);
    ASSERT_EQ(forest.trees.size(), 3u);
    EXPECT_NEAR(forest.trees[0].position.z, 1010.0 - 0.5 * 0.4, 1e-3);
    const double sunk = 1010.0 - forest.trees[1].position.z;
    EXPECT_GT(sunk, 0.02) << "the diameter is that of the shape";
    EXPECT_NEAR(1010.0 - forest.trees[2].position.z, 2.0 * sunk, 0.02);
}

TEST(GroundSection, NoneMeansFlat) {
    const ForestFile forest = forestIn("/", "[[tree]]\nposition = [2, 3]\n[ground]\nnone = true\n");
    EXPECT_FALSE(forest.ground);
    EXPECT_EQ(forest.trees.at(0).position, glm::dvec3(2, 3, 0));
}

TEST(GroundSection, GeometryWithAHeightKeepsIt) {
    const TemporaryFolder folder;
    slope().write(folder.path() + "/a.tif");
    folder.write("a.geojson",
                 geoJson(point("20, 50, 1012") + "," + point("20, 50"), "urn:ogc:def:crs:EPSG::25832"));
    const ForestFile forest =
        inventoryOf(folder.path(), "file = \"a.geojson\"\n" + ground + "crs = \"EPSG:25832\"\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_EQ(forest.trees[0].position.z, 1012.0);
    EXPECT_NEAR(forest.trees[1].position.z, 1010.0, 0.5);
}

TEST(GroundSection, SetsTheCrsOfTheForestUnlessItHasOne) {
    const TemporaryFolder folder;
    RasterFile file = slope();
    file.crs = "EPSG:25832";
    file.write(folder.path() + "/a.tif");
    const std::string tree = "[[tree]]\nposition = [20, 50]\n";
    ForestFile forest = forestIn(folder.path(), tree + ground);
    EXPECT_EQ(forest.crs, "EPSG:25832");
    EXPECT_TRUE(forest.crsFromInventory);
    forest = forestIn(folder.path(), "crs = \"EPSG:25832\"\n" + tree + ground);
    EXPECT_FALSE(forest.crsFromInventory);
    // An inventory in degrees sets the CRS first, and the ground uses it.
    file.transform = {500000, 1, 0, 5538680, 0, -1};
    file.write(folder.path() + "/a.tif");
    folder.write("b.geojson", geoJson(point("9.0005, 50.0")));
    forest = inventoryOf(folder.path(), "file = \"b.geojson\"\n" + ground);
    EXPECT_EQ(forest.crs, "EPSG:32632");
    ASSERT_EQ(forest.trees.size(), 1u);
    EXPECT_NEAR(forest.trees[0].position.z, 1000.0 + 0.5 * 35.8, 0.5);
    // With the latitude first, only the exchanged place is on the ground.
    folder.write("b.geojson", geoJson(point("50.0, 9.0005")));
    const auto exchanged = readInventoryOf(folder.path(), "file = \"b.geojson\"\n" + ground);
    ASSERT_FALSE(exchanged);
    EXPECT_TRUE(hasPart(exchanged.problems().front().message,
                        "; if their latitude stands first, set inventory.axis_order = \"yx\""))
        << exchanged.problems().front().text();
}

TEST(GroundSection, ReadsBackAfterWriting) {
    const TemporaryFolder folder;
    slope().write(folder.path() + "/a.tif");
    const ForestFile forest =
        forestIn(folder.path(), "crs = \"EPSG:25832\"\n[scatter]\ncount = 9\narea = [10, 10, 90, 90]\n" +
                                    ground + "crs = \"EPSG:25832\"\n");
    std::ostringstream output;
    for (const Diagnostic& problem : writeForest(forest, output))
        ADD_FAILURE() << problem.text();
    std::istringstream input(output.str());
    const auto back = readForest(input, {"back", "/"});
    ASSERT_TRUE(back) << back.problems().front().text() << output.str();
    const auto rasters = std::dynamic_pointer_cast<const RasterGround>(back.value().ground);
    ASSERT_TRUE(rasters);
    EXPECT_EQ(rasters->source().files, std::vector<std::string>{folder.path() + "/a.tif"});
    EXPECT_EQ(rasters->source().crs, "EPSG:25832");
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_EQ(back.value().trees[i].position, forest.trees[i].position)
            << "must not be placed on the ground again";
}

TEST(GroundSection, CallableCannotBeWritten) {
    ForestFile forest;
    forest.species.emplace_back().name = "oak";
    forest.ground = std::make_shared<FunctionGround>([](double x, double) { return x; });
    std::ostringstream output;
    const Diagnostics problems = writeForest(forest, output);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_TRUE(isProblem(problems.front().text(), "ground", "not a callable"));
}

TEST(StandOnGround, SupportsCallableGrounds) {
    ForestFile forest;
    forest.species.emplace_back().name = "oak";
    forest.trees.resize(3);
    forest.trees[1].position = {10, 0, 5};
    forest.trees[2].position = {-10, 0, 5};
    forest.trees[2].name = "7b";
    EXPECT_TRUE(standOnGround(forest, {0, 1, 2}).empty()) << "there is no ground yet";
    forest.ground =
        std::make_shared<FunctionGround>([](double x, double) { return x < -1 ? std::nan("") : 3.0; });
    const Diagnostics problems = standOnGround(forest, {0, 1, 2});
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_TRUE(isProblem(problems.front().text(), "ground",
                          "1 of 3 trees, first tree[2] (id \"7b\") at (-10, 0): the ground has a hole"));
    EXPECT_EQ(forest.trees[1].position.z, 3.0);
    EXPECT_EQ(forest.trees[2].position.z, 5.0);
}

TEST(GroundSection, PlacesScatteredTreesOnTheModelOfMissoula) {
    REQUIRE_REAL_DATA(path, "place/dem.tif");
    const ForestFile forest =
        forestIn("/", "[scatter]\ncount = 500\narea = [726400, 5209000, 729400, 5213800]\n" + thin +
                          "[ground]\nfile = \"" + path + "\"\n");
    ASSERT_EQ(forest.trees.size(), 500u);
    EXPECT_EQ(forest.crs, "EPSG:32611");
    for (const TreePlacement& tree : forest.trees)
        EXPECT_NEAR(tree.position.z, forest.ground->height(glm::dvec2(tree.position)).value(), 0.01);
    EXPECT_GT(forest.origin.z, 900.0) << "the origin is at the lowest tree";
}

} // namespace osgTreeWind

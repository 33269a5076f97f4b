// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>
#include <tests/places/GeoJson.h>
#include <tests/places/RasterFile.h>

namespace osgTreeWind {

namespace {

const std::string onGround = "[ground]\nfile = \"a.tif\"\n", heights = "columns = { height = \"h\" }\n";

/// Three trees 20 m, 25 m and 30 m high, 10 m apart, on a ground at 310 m that rises eastward by 0.05 m per
/// metre.
class InventoryHeights : public testing::Test {
protected:
    static double ground(std::size_t tree) { return 310.0 + 0.05 * 10.0 * static_cast<double>(tree + 1); }
    static double height(std::size_t tree) { return 20.0 + 5.0 * static_cast<double>(tree); }

    InventoryHeights() {
        RasterFile file;
        file.columns = file.rows = 100;
        file.transform = {565000, 1, 0, 5934100, 0, -1};
        file.value = [](int column, int) { return 310.0 + 0.05 * (column + 0.5); };
        file.crs = "EPSG:25832";
        file.write(folder.path() + "/a.tif");
    }
    /// Writes a map file of the trees. @param z of each tree as JSON.
    void write(const std::vector<std::string>& z) {
        std::string features;
        for (std::size_t i = 0; i < z.size(); ++i)
            features += (i ? "," : "") + point(std::to_string(565010 + 10 * i) + ", 5934050, " + z[i],
                                               "\"h\": " + std::to_string(height(i)));
        folder.write("a.geojson", geoJson(features, utm));
    }
    Result<ForestFile> read(const std::string& lines) {
        return readInventoryOf(folder.path(), "file = \"a.geojson\"\n" + lines);
    }
    /// Expects the trees with their heights on the ground.
    void expectOnGround(const std::string& lines) {
        SCOPED_TRACE(lines);
        const auto forest = read(lines + onGround);
        ASSERT_TRUE(forest) << forest.problems().front().text();
        ASSERT_EQ(forest.value().trees.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(forest.value().trees[i].position.z, ground(i), 0.05);
            EXPECT_NEAR(forest.value().trees[i].size.height, height(i), 0.01);
            EXPECT_FALSE(forest.value().trees[i].estimated.height);
        }
    }
    /// The z of each tree with something added to the ground.
    static std::vector<std::string> above(const std::function<double(std::size_t tree)>& added) {
        std::vector<std::string> z;
        for (std::size_t i = 0; i < 3; ++i)
            z.push_back(std::to_string(ground(i) + added(i)));
        return z;
    }

    const TemporaryFolder folder;
};

} // namespace

TEST_F(InventoryHeights, TheZOfFeetIsKeptAndItsDistanceNoted) {
    write(above([](std::size_t tree) { return tree == 0 ? -2.0 : 0.5; }));
    const auto forest = read(heights + onGround);
    ASSERT_TRUE(forest) << forest.problems().front().text();
    EXPECT_NEAR(forest.value().trees[0].position.z, ground(0) - 2.0, 1e-6);
    EXPECT_TRUE(hasPart(notesOf(forest.value()),
                        "a.geojson: the z of 3 trees is off the ground by 0.5 m in the "
                        "median and 2 m at most"));
}

TEST_F(InventoryHeights, MostTreesFarOffTheGroundAreAProblem) {
    write({"0", "0", "0"});
    EXPECT_TRUE(
        hasPart(firstProblem(read(heights + onGround)),
                "a.geojson: the z of 3 of 3 trees is far off the ground, by 311 m in the median and 311.5 m "
                "at most; set inventory.z = \"ignore\" if it does not count, \"height\" if it is the height "
                "of the tree, or \"top\" if it is that of its top"));
    expectOnGround(heights + "z = \"ignore\"\n");
    EXPECT_TRUE(read(heights)) << "without a ground";
    // Half of the trees, or not a tenth of their height: no problem
    write(above([](std::size_t tree) { return tree == 0 ? 4.0 : 0.0; }));
    EXPECT_TRUE(read(heights + onGround));
    write(above([](std::size_t) { return 2.9; }));
    EXPECT_TRUE(read(heights + onGround));
    write(above([](std::size_t tree) { return 0.099 * height(tree) + (tree == 0 ? 3.0 : 0.0); }));
    EXPECT_TRUE(read(heights + onGround));
    write(above([](std::size_t tree) { return 0.101 * height(tree) + (tree == 0 ? 3.0 : 0.5); }));
    EXPECT_FALSE(read(heights + onGround));
}

TEST_F(InventoryHeights, ZMayBeTheHeightOfTheTree) {
    write({"20", "25", "30"});
    expectOnGround("z = \"height\"\n");
    const auto forest = read("z = \"height\"\n");
    EXPECT_EQ(forest.value().trees[2].size.height, 30.0f);
    EXPECT_EQ(forest.value().trees[2].position.z, 0.0);
    write({"20", "0", "-9999"});
    const auto some = read("z = \"height\"\n" + onGround);
    EXPECT_EQ(some.value().trees[0].size.height, 20.0f);
    EXPECT_TRUE(some.value().trees[1].estimated.height);
    EXPECT_TRUE(some.value().trees[2].estimated.height);
    write({"20", "200", "300"});
    EXPECT_TRUE(hasPart(notesOf(read("z = \"height\"\n" + onGround).value()),
                        "expected a z in (0, 116] metres, found 200"));
}

TEST_F(InventoryHeights, ZMayBeThatOfTheTop) {
    write(above([](std::size_t tree) { return height(tree); }));
    EXPECT_FALSE(read(heights + onGround));
    expectOnGround("z = \"top\"\n");
    expectOnGround(heights + "z = \"top\"\n");
    const auto forest = read(heights + "z = \"top\"\n"); // without a ground
    ASSERT_TRUE(forest);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(forest.value().trees[i].position.z, ground(i), 1e-4);
    EXPECT_TRUE(isProblem(firstProblem(read("z = \"top\"\n")), "test.treewind:6:5: inventory.z",
                          "\"top\" needs a ground or columns.height"));
    EXPECT_TRUE(hasPart(firstProblem(read("z = \"crown\"\n")), "inventory.z: expected \"foot\""));
}

TEST_F(InventoryHeights, NodataIsNoZ) {
    for (const char* nodata : {"-9999", "-9999.0", "-999.9", "-32768", "-3.4028235e38", "NaN"}) {
        SCOPED_TRACE(nodata);
        write({nodata, nodata, nodata});
        expectOnGround(heights);
        EXPECT_TRUE(
            hasPart(notesOf(read(heights).value()), "a z of -9999 or similar does not count: 3 trees"));
    }
    folder.write("a.csv", "x,y,z\n565010,5934050,-9999\n565020,5934050,NA\n565030,5934050,312\n");
    const ForestFile forest = inventoryOf(
        folder.path(), "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", z = \"z\" }\n" + onGround,
        "crs = \"EPSG:25832\"");
    ASSERT_EQ(forest.trees.size(), 3u);
    EXPECT_NEAR(forest.trees[0].position.z, ground(0), 0.05);
    EXPECT_NEAR(forest.trees[1].position.z, ground(1), 0.05);
    EXPECT_EQ(forest.trees[2].position.z, 312.0);
}

} // namespace osgTreeWind

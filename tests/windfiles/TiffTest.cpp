// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/places/RasterFile.h>

#include <osgTreeWind/windfiles/WindFile.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

namespace osgTreeWind {

namespace {

/// A pair of 3 x 2 cells of 10 m: a westerly of 1 to 6 m/s, row by row from the north-west.
struct TiffPair : testing::Test {
    TemporaryFolder folder;
    RasterFile speed, direction;

    TiffPair() {
        speed.columns = direction.columns = 3;
        speed.rows = direction.rows = 2;
        speed.transform = direction.transform = {500000, 10, 0, 5100020, 0, -10};
        speed.crs = direction.crs = "EPSG:32611";
        speed.value = [](int column, int row) { return 1.0 + column + 3.0 * row; };
        direction.value = [](int, int) { return 270.0; };
    }
    Result<WindFile> read() const {
        direction.write(folder.path() + "/a_ang.tif");
        WindFileOptions options;
        options.origin = {500005, 5100005, 0}; // the centre of the south-western cell
        return readWindFile(speed.write(folder.path() + "/a_vel.tif"), options);
    }
    std::string problem() const { return firstProblem(read()); }
};

} // namespace

TEST_F(TiffPair, ReadsRowsFromTheSouth) {
    const auto file = read();
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(file.value().summary.format, "GeoTIFF speed and direction");
    EXPECT_EQ(file.value().summary.crs, "EPSG:32611");
    EXPECT_EQ(file.value().summary.coordinates, "WGS 84 / UTM zone 11N");
    EXPECT_EQ(file.value().summary.points, glm::ivec3(3, 2, 1));
    EXPECT_NEAR(asField(file.value().wind)->velocity({0, 0, 10}, 0).x, 4.0f, 1e-5f);
    EXPECT_NEAR(asField(file.value().wind)->velocity({20, 10, 10}, 0).x, 3.0f, 1e-5f);
    EXPECT_NEAR(asField(file.value().wind)->velocity({20, 10, 10}, 0).y, 0.0f, 1e-5f);
}

TEST_F(TiffPair, ReadsTheUnit) {
    speed.unit = "kts";
    const auto file = read();
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(file.value().summary.unit, "kn");
    EXPECT_NEAR(asField(file.value().wind)->velocity({0, 0, 10}, 0).x, 4.0f * 1852.0f / 3600.0f, 1e-5f);
    speed.unit = "furlong";
    EXPECT_NE(problem().find("found 'furlong'; speed_unit replaces it"), std::string::npos) << problem();
}

TEST_F(TiffPair, MissingCellsAreCalm) {
    speed.nodata = 4.0;
    const auto file = read();
    ASSERT_TRUE(file) << firstProblem(file);
    EXPECT_EQ(asField(file.value().wind)->velocity({0, 0, 10}, 0).x, 0.0f);
}

TEST_F(TiffPair, RefusesInvalidPairsByName) {
    const auto refused = [&](const std::string& part) {
        EXPECT_NE(problem().find(part), std::string::npos) << problem();
        speed.transform = direction.transform;
        speed.bands = 1;
    };
    speed.transform[1] = 12;
    refused("a_vel.tif: expected square cells, found 12 x 10");
    speed.transform[2] = 1;
    refused("a_vel.tif: expected rows from the north southward, not turned");
    speed.transform[5] = 10;
    refused("a_vel.tif: expected rows from the north southward");
    speed.bands = 2;
    refused("a_vel.tif: expected one band, found 2");
    speed.transform[0] += 10;
    refused("expected the same cells in both files of the pair");
    direction.crs = "EPSG:32612";
    refused("expected the same map in both files of the pair");
    direction.crs = "EPSG:32611";
    direction.value = [](int, int) { return 1000.0; };
    refused("direction of -360 to 360 degrees, found 4 and 1000 in row 2, column 1");
}

TEST_F(TiffPair, RefusesDamage) {
    ASSERT_TRUE(read());
    const std::string path = folder.path() + "/a_vel.tif";
    std::size_t bad = 0;
    for (std::uintmax_t size = std::filesystem::file_size(path) - 1; size > 0; size = size * 2 / 3) {
        std::filesystem::resize_file(path, size);
        const auto file = readWindFile(path);
        if (!file && file.problems().front().file == path)
            ++bad;
    }
    EXPECT_GE(bad, 10u);
    std::filesystem::remove(folder.path() + "/a_ang.tif");
    (void)speed.write(path);
    EXPECT_NE(firstProblem(readWindFile(path)).find("a_ang.tif: no such file"), std::string::npos);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/places/GeoJson.h>
#include <tests/places/RasterFile.h>

#include <osgTreeWind/places/RasterGround.h>

#include <cmath>
#include <thread>

namespace osgTreeWind {

namespace {

std::optional<Crs> crsOrNone(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(Crs::parse(text).value());
}

std::shared_ptr<const RasterGround> opened(const RasterGround::Source& source, const std::string& map = "") {
    const auto ground = RasterGround::open(source, crsOrNone(map));
    for (const Diagnostic& problem : ground.problems())
        ADD_FAILURE() << problem.text();
    return ground ? ground.value() : nullptr;
}

} // namespace

TEST(RasterGround, WithoutAnyCrsCoordinatesAreUnchanged) {
    const TemporaryFolder folder;
    const auto ground = opened({{RasterFile{}.write(folder.path() + "/a.tif")}, ""});
    ASSERT_TRUE(ground);
    EXPECT_FALSE(ground->map());
    EXPECT_EQ(ground->area().low, glm::dvec2(0, 0));
    EXPECT_EQ(ground->area().high, glm::dvec2(4, 4));
    EXPECT_EQ(ground->area().cell, 1.0);
    EXPECT_NEAR(ground->height({1.0, 3.5}).value(), 100.5, 1e-4);
}

TEST(RasterGround, FirstTileWithAHeightCounts) {
    const TemporaryFolder folder;
    RasterFile first, second;
    first.value = [](int column, int) { return column == 3 ? -1.0 : 1.0; };
    first.nodata = -1.0;
    second.value = [](int, int) { return 2.0; };
    second.transform[0] = 2; // overlaps the first by two cells
    const auto ground =
        opened({{first.write(folder.path() + "/1.tif"), second.write(folder.path() + "/2.tif")}, ""});
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->height({2.5, 2}).value(), 1.0);
    EXPECT_EQ(ground->height({3.5, 2}).value(), 2.0) << "a hole of the first";
    EXPECT_EQ(ground->height({5.5, 2}).value(), 2.0);
    EXPECT_FALSE(ground->height({6.5, 2}));
    EXPECT_EQ(ground->area().high, glm::dvec2(6, 4));
}

TEST(RasterGround, WorldCrsIsThatOfTheFileOrItsUtmZone) {
    const TemporaryFolder folder;
    RasterFile file;
    file.crs = "EPSG:25832";
    EXPECT_EQ(opened({{file.write(folder.path() + "/a.tif")}, ""})->map()->text(), "EPSG:25832");
    file.crs = "EPSG:4326";
    file.transform = {8.999, 0.001, 0, 50.002, 0, -0.001};
    const auto ground = opened({{file.write(folder.path() + "/b.tif")}, ""});
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->map()->text(), "EPSG:32632");
    const glm::dvec2 centre(500000.0, 5538630.7); // 9 E, 50 N, by cs2cs
    EXPECT_NEAR(ground->height(centre).value(), 115.5, 0.01);
    EXPECT_NEAR(ground->area().cell, 71.7, 0.1) << "the shorter side, a thousandth of a degree east";
    EXPECT_EQ(opened({{folder.path() + "/b.tif"}, ""}, "EPSG:25831")->map()->text(), "EPSG:25831");
}

TEST(RasterGround, LongitudesMayStartAtZero) {
    const TemporaryFolder folder;
    RasterFile file;
    file.crs = "EPSG:4326";
    file.transform = {243.0, 0.01, 0, 46.04, 0, -0.01}; // 117 W
    const auto ground = opened({{file.write(folder.path() + "/a.tif")}, ""}, "EPSG:32611");
    ASSERT_TRUE(ground);
    EXPECT_TRUE(ground->height({501500.0, 5096000.0}));
}

TEST(RasterGround, StatedCrsOverridesTheFiles) {
    const TemporaryFolder folder;
    RasterFile file;
    file.crs = "EPSG:25831";
    const std::string path = file.write(folder.path() + "/a.tif");
    const auto ground = opened({{path}, "EPSG:25832"}, "EPSG:25832");
    ASSERT_TRUE(ground);
    EXPECT_NEAR(ground->height({1.0, 3.5}).value(), 100.5, 1e-4);
    file.crs = "";
    EXPECT_TRUE(opened({{file.write(folder.path() + "/b.tif")}, "EPSG:25832"}, "EPSG:25832")->height({1, 1}));
}

TEST(RasterGround, RequiresACrsIfTheForestHasOne) {
    const TemporaryFolder folder;
    const std::string path = RasterFile{}.write(folder.path() + "/a.tif");
    const auto ground = RasterGround::open({{path}, ""}, crsOrNone("EPSG:25832"));
    ASSERT_FALSE(ground);
    EXPECT_EQ(ground.problems().front().text(),
              path + ": it has no coordinate reference system; expected ground.crs to state it");
}

/// Compares a real elevation model with its reprojection to degrees by gdalwarp.
TEST(RasterGround, ReprojectedModelOfMissoulaIsTheSameGround) {
    REQUIRE_REAL_DATA(path, "place/dem.tif");
    REQUIRE_PROGRAM("gdalwarp");
    const TemporaryFolder folder;
    const std::string warped = folder.path() + "/degrees.tif";
    ASSERT_EQ(std::system(("gdalwarp -q -t_srs EPSG:4326 -r bilinear -et 0 -ot Float32 -tr 0.0001 0.0001 " +
                           path + ' ' + warped)
                              .c_str()),
              0);
    const auto ground = opened({{path}, ""}), onDegrees = opened({{warped}, ""}, "EPSG:32611");
    ASSERT_TRUE(ground && onDegrees);
    double sum = 0.0, largest = 0.0;
    int count = 0;
    for (double x = 726500; x < 729300; x += 97)
        for (double y = 5209100; y < 5213700; y += 89, ++count) {
            const double difference =
                std::abs(ground->height({x, y}).value() - onDegrees->height({x, y}).value());
            sum += difference;
            largest = std::max(largest, difference);
        }
    std::cout << "mean " << sum / count << " m, largest " << largest << " m at " << count << " places\n";
    EXPECT_LT(sum / count, 0.05);
    EXPECT_LT(largest, 2.0); // between slopes, over cells of 8 m by 11 m
}

TEST(RasterGround, IsThreadSafe) {
    const TemporaryFolder folder;
    RasterFile file;
    file.crs = "EPSG:4326";
    file.transform = {8.999, 0.001, 0, 50.002, 0, -0.001};
    const auto ground = opened({{file.write(folder.path() + "/a.tif")}, ""});
    const double expected = ground->height({500010.0, 5538630.0}).value();
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int n = 0; n < 1000; ++n)
                EXPECT_EQ(ground->height({500010.0, 5538630.0}), expected);
        });
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace osgTreeWind

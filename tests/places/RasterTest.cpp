// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/Folders.h>
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/places/GeoJson.h>
#include <tests/places/RasterFile.h>

#include <osgTreeWind/places/Raster.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace osgTreeWind {

namespace {

Raster opened(const std::string& path) {
    auto raster = Raster::open(path);
    for (const Diagnostic& problem : raster.problems())
        ADD_FAILURE() << problem.text();
    return std::move(raster.value());
}

Raster opened(const RasterFile& file) {
    const TemporaryFolder folder;
    return opened(file.write(folder.path() + "/a.tif"));
}

void expectNear(const std::optional<double>& height, double expected, double tolerance = 1e-4) {
    ASSERT_TRUE(height);
    EXPECT_NEAR(*height, expected, tolerance);
}

} // namespace

TEST(Raster, HeightsAreBilinearAndConstantAtTheBorder) {
    const Raster raster = opened(RasterFile{});
    expectNear(raster.height({0.5, 3.5}), 100.0);
    expectNear(raster.height({1.0, 3.5}), 100.5);
    expectNear(raster.height({1.25, 3.0}), 100.75 + 5.0);
    expectNear(raster.height({3.5, 0.5}), 133.0);
    expectNear(raster.height({0.0, 4.0}), 100.0);
    expectNear(raster.height({4.0, 0.0}), 133.0);
    expectNear(raster.height({0.0, 2.0}), 115.0);
    for (const glm::dvec2& beyond :
         {glm::dvec2(-0.01, 2), {4.01, 2}, {2, -0.01}, {2, 4.01}, {1e300, 2}, {NAN, 2}})
        EXPECT_FALSE(raster.height(beyond)) << beyond.x << ", " << beyond.y;
}

TEST(Raster, HasNoHeightWhereAContributingCellHasNone) {
    for (const double none : {-9999.0, std::nan("")}) {
        RasterFile file;
        file.value = [&](int column, int row) { return column == 1 && row == 1 ? none : 7.0; };
        if (!std::isnan(none))
            file.nodata = none;
        const Raster raster = opened(file);
        EXPECT_FALSE(raster.height({1.5, 2.5}));
        EXPECT_FALSE(raster.height({0.51, 2.5}));
        EXPECT_FALSE(raster.height({2.49, 1.51}));
        expectNear(raster.height({0.5, 2.5}), 7.0); // at a cell's centre, the hole has no weight
        expectNear(raster.height({2.5, 1.5}), 7.0);
        expectNear(raster.height({3.0, 1.0}), 7.0);
    }
}

TEST(Raster, RejectsFormatsThatCrashOnDamagedFiles) {
    const TemporaryFolder folder;
    GDALAllRegister();
    if (!GDALGetDriverByName("netCDF"))
        GTEST_SKIP() << "this GDAL writes no NetCDF";
    const auto raster = Raster::open(RasterFile{}.write(folder.path() + "/a.nc", "netCDF"));
    ASSERT_FALSE(raster);
    EXPECT_NE(raster.problems().front().message.find("expected a format of docs/treewind.md, found netCDF"),
              std::string::npos)
        << raster.problems().front().text();
    const auto grib = Raster::open(OSGTREEWIND_TEST_DATA "/wind/small.grib2");
    ASSERT_FALSE(grib);
    EXPECT_NE(grib.problems().front().message.find("expected a format of docs/treewind.md, found GRIB"),
              std::string::npos)
        << grib.problems().front().text();
}

TEST(Raster, SupportsASingleColumn) {
    RasterFile file;
    file.columns = 1;
    const Raster raster = opened(file);
    expectNear(raster.height({0.0, 3.5}), 100.0);
    expectNear(raster.height({1.0, 3.0}), 105.0);
    EXPECT_FALSE(raster.height({1.1, 3.0}));
    file.rows = 1;
    expectNear(opened(file).height({0.9, 3.1}), 100.0);
}

TEST(Raster, ConvertsUnitScaleAndOffsetToMetres) {
    RasterFile file;
    file.unit = "ft";
    expectNear(opened(file).height({0.5, 3.5}), 30.48);
    file.unit = "US survey foot";
    expectNear(opened(file).height({0.5, 3.5}), 100.0 * 1200.0 / 3937.0);
    file.unit = "yd"; // known to UDUNITS
    expectNear(opened(file).height({0.5, 3.5}), 91.44);
    file.unit = "metre";
    expectNear(opened(file).height({0.5, 3.5}), 100.0);
    file.unit = "";
    file.type = GDT_Int16;
    file.nodata = 101.0; // a stored value, before scale and offset
    file.scale = 0.1;
    file.offset = 1000.0;
    const Raster scaled = opened(file);
    expectNear(scaled.height({0.5, 3.5}), 1010.0);
    EXPECT_FALSE(scaled.height({1.5, 3.5}));
    file.unit = "ft";
    expectNear(opened(file).height({0.5, 3.5}), 1010.0 * 0.3048);
    file = RasterFile{};
    file.crs = "EPSG:2263+6360"; // New York's map with heights in feet of the US survey
    expectNear(opened(file).height({0.5, 3.5}), 100.0 * 1200.0 / 3937.0);
}

TEST(Raster, SupportsRotation) {
    RasterFile file;
    const double c = 2.0 * std::cos(0.5), s = 2.0 * std::sin(0.5); // cells of 2 m, half a radian
    file.transform = {1000, c, s, 2000, s, -c};
    const Raster raster = opened(file);
    const auto place = [&](double column, double row) {
        return glm::dvec2(1000 + column * c + row * s, 2000 + column * s - row * c);
    };
    expectNear(raster.height(place(0.5, 0.5)), 100.0);
    expectNear(raster.height(place(2.25, 1.5)), 100.0 + 1.75 + 10.0);
    EXPECT_FALSE(raster.height(place(-0.1, 2)));
}

TEST(Raster, VrtOfTilesHasNoSeams) {
    REQUIRE_PROGRAM("gdalbuildvrt");
    const TemporaryFolder folder;
    RasterFile west, east;
    east.transform[0] = 4;
    east.value = [](int column, int row) { return 104.0 + column + 10.0 * row; };
    west.write(folder.path() + "/west.tif");
    east.write(folder.path() + "/east.tif");
    ASSERT_EQ(std::system(("cd " + folder.path() + " && gdalbuildvrt -q all.vrt west.tif east.tif").c_str()),
              0);
    const Raster raster = opened(folder.path() + "/all.vrt");
    expectNear(raster.height({4.0, 3.5}), 103.5);
    expectNear(raster.height({7.5, 3.5}), 107.0);
}

TEST(Raster, ReadsEsriAsciiGrids) {
    const TemporaryFolder folder;
    const Raster raster =
        opened(folder.write("a.asc", "ncols 2\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 5\n"
                                     "NODATA_value -9999\n1 2\n3 -9999\n"));
    expectNear(raster.height({12.5, 27.5}), 1.0);
    expectNear(raster.height({12.5, 22.5}), 3.0);
    EXPECT_FALSE(raster.height({13, 23}));
    EXPECT_FALSE(raster.crs());
}

TEST(Raster, ReadsCompressedTiles) {
    const TemporaryFolder folder;
    RasterFile file;
    file.columns = 700;
    file.rows = 500;
    file.value = [](int column, int row) { return column * row % 997; };
    file.transform[3] = file.rows;
    const Raster raster = opened(file.write(folder.path() + "/a.tif", "GTiff", true));
    for (int i = 0; i < 500; ++i) {
        const int column = i * 131 % 700, row = i * 59 % 500;
        expectNear(raster.height({column + 0.5, 499.5 - row}), file.value(column, row));
    }
}

/// Compares with gdallocationinfo, an independent program.
TEST(Raster, ModelOfMissoulaMatchesGdalLocationInfo) {
    REQUIRE_REAL_DATA(path, "place/dem.tif");
    REQUIRE_PROGRAM("gdallocationinfo");
    const Raster raster = opened(path);
    ASSERT_EQ(raster.columns(), 37);
    ASSERT_EQ(raster.rows(), 58);
    const TemporaryFolder folder;
    std::ostringstream places;
    for (int i = 0; i < 58 * 37; ++i)
        places << i % 37 << ' ' << i / 37 << '\n';
    folder.write("in", places.str());
    ASSERT_EQ(std::system(("gdallocationinfo -valonly " + path + " < " + folder.path() + "/in > " +
                           folder.path() + "/out")
                              .c_str()),
              0);
    std::vector<double> cells(58 * 37);
    std::ifstream out(folder.path() + "/out");
    for (double& cell : cells)
        out >> cell;
    ASSERT_TRUE(out);
    const auto cell = [&](int column, int row) { return cells[static_cast<std::size_t>(row * 37 + column)]; };
    for (int row = 0; row < 58; ++row)
        for (int column = 0; column < 37; ++column) {
            const glm::dvec2 centre(726299.0 + 85.0 * (column + 0.5), 5213878.0 - 85.0 * (row + 0.5));
            expectNear(raster.height(centre), cell(column, row), 0.1);
            if (column == 36 || row == 57)
                continue;
            const double u = 0.3, v = 0.8; // between four centres
            expectNear(raster.height(centre + 85.0 * glm::dvec2(u, -v)),
                       (1 - u) * (1 - v) * cell(column, row) + u * (1 - v) * cell(column + 1, row) +
                           (1 - u) * v * cell(column, row + 1) + u * v * cell(column + 1, row + 1),
                       0.1);
        }
}

namespace {

std::string vrtOf(const std::string& source, const std::string& band = "") {
    return "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><GeoTransform>0,1,0,2,0,-1</GeoTransform>"
           "<VRTRasterBand dataType=\"Float32\" band=\"1\"" +
           band + ">" + source + "</VRTRasterBand></VRTDataset>";
}

std::string sourceOf(const std::string& name) {
    return "<SimpleSource><SourceFilename relativeToVRT=\"1\">" + name +
           "</SourceFilename><SourceBand>1</SourceBand></SimpleSource>";
}

} // namespace

TEST(Raster, VrtMayOnlyMosaicFiles) {
    const TemporaryFolder folder;
    (void)RasterFile().write(folder.path() + "/a.tif");
    const auto problemOf = [&](const std::string& text) {
        return firstProblem(Raster::open(folder.write("a.vrt", text))).substr(folder.path().size() + 1);
    };
    EXPECT_TRUE(Raster::open(folder.write("a.vrt", vrtOf(sourceOf("a.tif")))));
    const std::string secret = folder.write("secret", "16 bytes of text");
    EXPECT_EQ(
        problemOf(vrtOf("<SourceFilename>" + secret + "</SourceFilename>", " subClass=\"VRTRawRasterBand\"")),
        "a.vrt: expected a VRT that combines files, found one with \"VRTRawRasterBand\"");
    EXPECT_EQ(problemOf(vrtOf(sourceOf("a.tif"), " subClass=\"VRTDerivedRasterBand\"")),
              "a.vrt: expected a VRT that combines files, found one with \"VRTDerivedRasterBand\"");
    EXPECT_EQ(problemOf(vrtOf(sourceOf("secret"))),
              "a.vrt: its source \"secret\" has a format that is not supported for ground");
    for (const char* const name :
         {"/vsicurl/http://localhost/a.tif", "http://localhost/a.tif", "/vsimem/a.tif", "no.tif"})
        EXPECT_EQ(problemOf(vrtOf("<SimpleSource><SourceFilename>" + std::string(name) +
                                  "</SourceFilename></SimpleSource>")),
                  "a.vrt: its source \"" + std::string(name) + "\" is not a file");
    folder.write("b.vrt", vrtOf(sourceOf("secret")));
    EXPECT_EQ(problemOf(vrtOf(sourceOf("b.vrt"))),
              "a.vrt: its source \"secret\" has a format that is not supported for ground");
    EXPECT_EQ(problemOf(vrtOf(sourceOf("a.vrt"))), "a.vrt: its source \"a.vrt\" is a VRT nested too deeply");
}

TEST(Raster, RespectsTheMemoryLimit) {
    const TemporaryFolder folder;
    const std::string vrt = folder.write(
        "a.vrt",
        "<VRTDataset rasterXSize='20000' rasterYSize='19000'><GeoTransform>0,1,0,0,0,-1</GeoTransform>"
        "<VRTRasterBand dataType='Float32' band='1'/></VRTDataset>");
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "1G");
    EXPECT_EQ(firstProblem(Raster::open(vrt)),
              vrt + ": its 20000 x 19000 cells need about 1.52 GB of memory; the limit is 1 GB "
                    "(set another with OSGTREEWIND_MAX_MEMORY)");
}

} // namespace osgTreeWind

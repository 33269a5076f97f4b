// SPDX-License-Identifier: MIT
// Recognition of formats, for records and fields.
#include <tests/EnvironmentVariable.h>
#include <tests/Folders.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/windfiles/WindFormatsCases.h>

#include <osgTreeWind/windfiles/WindFile.h>

#include <gtest/gtest.h>

#include <zlib.h>

#include <fstream>

namespace osgTreeWind {

namespace {

std::string formatOf(const std::string& path) {
    const Result<WindContent> content = readWindContent(path, {});
    return content ? content.value().summary.format : firstProblem(content);
}

class WindFormats : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(WindFormats, AreRecognisedByContentWithAnyName) {
    const TemporaryFolder folder;
    const std::string bytes = bytesOf({GetParam(), nullptr}), file = std::string(GetParam());
    const std::string expected = formatOf(OSGTREEWIND_TEST_DATA "/wind/" + file);
    EXPECT_EQ(expected.find("unknown format"), std::string::npos) << expected;
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

TEST(WindFormats, AreRecognisedByTheFirstKilobyteOnly) {
    const TemporaryFolder folder;
    const std::string sensor = bytesOf({"sensor.xml", nullptr}), far(1024, ' ');
    EXPECT_NE(formatOf(folder.write("a", far + sensor)).find("unknown format"), std::string::npos);
    EXPECT_EQ(formatOf(folder.write("a.xml", far + sensor)), "QES-Winds sensor") << "recognised by its name";
}

TEST(WindFormats, ReadsRecordsOfAllFormats) {
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
    columns.time = {"t"};
    columns.u = "u";
    columns.v = "v";
    columns.speedUnit = "km/h";
    const auto table = readWindSeries(folder.write("table.txt", "t,u,v\n0,36,0\n1,0,72\n"), columns);
    ASSERT_TRUE(table) << firstProblem(table) << ": named columns imply a table";
    EXPECT_EQ(table.value().velocities[1], glm::vec3(0, 20, 0));

    const std::string grid = OSGTREEWIND_TEST_DATA "/wind/vectors.vtk";
    EXPECT_NE(firstProblem(readWindSeries(folder.write("fast.txt", "t,u,v\n0,3,0\n1,600,600\n"), columns))
                  .find("expected winds of at most 200 m/s; number 2 of 2 is faster"),
              std::string::npos);
    EXPECT_EQ(firstProblem(readWindSeries(grid, {})),
              grid + ": expected a record at one point, found a grid: VTK legacy STRUCTURED_POINTS");
}

TEST(WindFormats, RefusesToUnpackMoreThanTheMemoryLimit) {
    const std::uint32_t size = 3 * 4 * 1000 * 1000;
    std::string packed(compressBound(size), '\0');
    uLongf length = packed.size();
    const std::string zeros(size, '\0');
    ASSERT_EQ(compress(reinterpret_cast<Bytef*>(&packed[0]), &length,
                       reinterpret_cast<const Bytef*>(zeros.data()), size),
              Z_OK);
    const std::uint32_t head[] = {1, size, 0, static_cast<std::uint32_t>(length)};
    const std::string file =
        "<VTKFile type='ImageData' compressor='vtkZLibDataCompressor'><ImageData WholeExtent='0 999 0 999 0 "
        "0'>"
        "<Piece Extent='0 999 0 999 0 0'><PointData><DataArray type='Float32' NumberOfComponents='3' "
        "format='appended' offset='0'/></PointData></Piece></ImageData><AppendedData encoding='raw'>_" +
        std::string(reinterpret_cast<const char*>(head), sizeof head) + packed.substr(0, length);
    EXPECT_EQ(firstProblem(readVtkXml(file, "f")), "");
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "20M");
    EXPECT_NE(firstProblem(readVtkXml(file, "f")).find("the unpacked data need about 24 MB of memory"),
              std::string::npos)
        << firstProblem(readVtkXml(file, "f"));
}

TEST(WindFormats, RefusesFilesLargerThanTheMemoryLimit) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.vtk", "# vtk DataFile Version 3.0\n");
    constexpr std::streamoff size = std::streamoff(1) << 31;
    std::ofstream(file, std::ios::binary | std::ios::in).seekp(size - 1).put('x'); // sparse
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "1G");
    EXPECT_EQ(formatOf(file).find(file + ": its bytes need about 2.15 GB of memory"), 0u) << formatOf(file);
}

TEST(WindFormats, VtkMayHaveUnevenLevelsAndAxesOfOnePoint) {
    const std::string head = "# vtk DataFile Version 3.0\na\nASCII\n";
    const auto rectilinear =
        readVtkLegacy(head + "DATASET RECTILINEAR_GRID\nDIMENSIONS 2 1 3\nX_COORDINATES 2 float\n0 10\n"
                             "Y_COORDINATES 1 float\n5\nZ_COORDINATES 3 float\n2 10 40\nPOINT_DATA 6\n"
                             "VECTORS w float\n1 0 0 1 0 0 2 0 0 2 0 0 3 0 0 3 0 0\n",
                      "f");
    ASSERT_TRUE(rectilinear) << firstProblem(rectilinear);
    const auto& grid = std::get<GridWind::Grid>(rectilinear.value().data);
    EXPECT_EQ(grid.heights, (std::vector<float>{2, 10, 40}));
    EXPECT_TRUE(GridWind::check(grid).empty());
    const auto flat =
        readVtkLegacy(head + "DATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\nORIGIN 0 0 3\nSPACING 10 10 0\n"
                             "POINT_DATA 4\nVECTORS w float\n1 0 0 1 0 0 1 0 0 1 0 0\n",
                      "f");
    EXPECT_TRUE(flat) << firstProblem(flat);
    const auto none =
        readVtkLegacy(head + "DATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\nORIGIN 0 0 3\nSPACING 10 0 0\n"
                             "POINT_DATA 4\nVECTORS w float\n1 0 0 1 0 0 1 0 0 1 0 0\n",
                      "f");
    EXPECT_NE(firstProblem(none).find("expected metres above 0 between points"), std::string::npos)
        << firstProblem(none);
}

/// Half of the sum of the variances, which are 1, 0.8^2 and 0.5^2 of that along the wind.
TEST(WindFormats, VtkMayContainTurbulentKineticEnergy) {
    const std::vector<float> expected = {0.0f, 2.0f};
    const auto expectEnergy = [&](const Result<WindContent>& read) {
        ASSERT_TRUE(read) << firstProblem(read);
        const auto& grid = std::get<GridWind::Grid>(read.value().data);
        ASSERT_EQ(grid.deviations.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(grid.deviations[i], expected[i], 1e-5f);
        EXPECT_EQ(grid.values, (std::vector<float>{1, 0, 0, 2, 0, 0}));
    };
    const std::string legacy = "# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\n"
                               "DIMENSIONS 2 1 1\nORIGIN 0 0 3\nSPACING 10 1 1\nPOINT_DATA 2\n";
    expectEnergy(
        readVtkLegacy(legacy + "FIELD attributes 2\nk 1 2 float\n0 3.78\nU 3 2 float\n1 0 0 2 0 0\n", "f"));
    expectEnergy(readVtkLegacy(
        legacy + "SCALARS TKE double 1\nLOOKUP_TABLE default\nnan 3.78\nVECTORS U float\n1 0 0 2 0 0\n",
        "f"));
    const auto xml = [](const std::string& energy) {
        return readVtkXml(
            "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 1 0 0 0 0\"><Piece Extent=\"0 1 0 0 "
            "0 0\"><PointData><DataArray type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\">1 0 0 2 0 "
            "0</DataArray><DataArray type=\"Float32\" Name=\"k\">" +
                energy + "</DataArray></PointData></Piece></ImageData></VTKFile>",
            "f");
    };
    expectEnergy(xml("0 3.78"));
    EXPECT_NE(firstProblem(xml("3.78")).find("k: expected a number, found nothing"), std::string::npos)
        << firstProblem(xml("3.78"));
}

} // namespace osgTreeWind

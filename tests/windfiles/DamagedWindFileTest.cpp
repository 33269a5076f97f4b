// SPDX-License-Identifier: MIT
#include <tests/windfiles/WindFormatsCases.h>

#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/windfiles/WindFile.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

/// Expects a problem or a grid with as many numbers as points.
void expectConsistent(const Result<WindContent>& content, const std::string& what) {
    if (!content) {
        ASSERT_FALSE(content.problems().empty()) << what;
        for (const Diagnostic& problem : content.problems()) {
            EXPECT_FALSE(problem.message.empty()) << what;
            EXPECT_EQ(problem.file, "damaged") << what << ": " << problem.text();
        }
        return;
    }
    if (const auto* grid = std::get_if<GridWind::Grid>(&content.value().data)) {
        const double steps = grid->times.empty() ? 1.0 : static_cast<double>(grid->times.size());
        ASSERT_EQ(static_cast<double>(grid->values.size()),
                  3.0 * grid->points.x * grid->points.y * grid->points.z * steps)
            << what;
    }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

} // namespace

class DamagedWindFile : public testing::TestWithParam<FormatCase> {};

void PrintTo(const FormatCase& format, std::ostream* out) {
    *out << format.file;
}

TEST_P(DamagedWindFile, TruncatedFileIsReadCompletelyOrRefused) {
    const std::string whole = bytesOf(GetParam());
    ASSERT_TRUE(GetParam().read(whole, "damaged"));
    for (std::size_t length = 0; length < whole.size(); ++length)
        expectConsistent(GetParam().read(whole.substr(0, length), "damaged"),
                         "cut at " + std::to_string(length));
}

TEST_P(DamagedWindFile, HalfAFileIsAProblem) {
    const std::string whole = bytesOf(GetParam());
    const auto content = GetParam().read(whole.substr(0, whole.size() / 2), "damaged");
    ASSERT_FALSE(content);
    EXPECT_FALSE(content.problems().front().line == 0 && content.problems().front().key.empty())
        << "no line or byte in: " << firstProblem(content);
}

INSTANTIATE_TEST_SUITE_P(Small, DamagedWindFile, testing::ValuesIn(formatCases()), [](const auto& info) {
    std::string name = info.param.file;
    name[name.find('.')] = '_';
    return name;
});

namespace {

/// A change to a small file and the expected problem.
struct Damage {
    const char* name;
    const char* file;
    const char* from;
    const char* to;
    const char* problem;
};

void PrintTo(const Damage& damage, std::ostream* out) {
    *out << damage.name;
}

const FormatCase& caseOf(std::string_view file) {
    for (const FormatCase& format : formatCases())
        if (format.file == file)
            return format;
    ADD_FAILURE() << file;
    return formatCases().front();
}

} // namespace

class DamagedWindFileSays : public testing::TestWithParam<Damage> {};

TEST_P(DamagedWindFileSays, WhereAndWhat) {
    const Damage& damage = GetParam();
    const FormatCase& format = caseOf(damage.file);
    EXPECT_EQ(firstProblem(format.read(replaced(bytesOf(format), damage.from, damage.to), "f")),
              damage.problem);
}

INSTANTIATE_TEST_SUITE_P(
    Small, DamagedWindFileSays,
    testing::Values(
        Damage{"EsriHuge", "pair_vel.asc", "ncols 3\nnrows 2", "ncols 50000\nnrows 20000",
               "f:6: the file is too short for 50000 x 20000 cells"},
        Damage{"EsriWord", "pair_vel.asc", "5 6", "5 six", "f:7: expected a number, found 'six'"},
        Damage{"EsriExtra", "pair_vel.asc", "1 2", "1 2 3",
               "f:8: expected the end after 6 cells, found '-999'"},
        Damage{"EsriNoCellSize", "pair_vel.asc", "cellsize 10\n", "", "f:5: expected cellsize in the header"},
        Damage{"EsriKey", "pair_vel.asc", "cellsize", "dx",
               "f:5: expected a key of an ESRI ASCII grid, found 'dx'"},
        Damage{"VtkHuge", "vectors.vtk", "DIMENSIONS 3 2 2\nORIGIN 100 200 5\nSPACING 10 20 5\nPOINT_DATA 12",
               "DIMENSIONS 1000 1000 1000\nORIGIN 100 200 5\nSPACING 10 20 5\nPOINT_DATA 1000000000",
               "f:10: the file ends before the 1000000000 numbers of this array"},
        Damage{"VtkCount", "vectors.vtk", "POINT_DATA 12", "POINT_DATA 13",
               "f:8: expected 12 as in DIMENSIONS, found 13"},
        Damage{"VtkNoVectors", "vectors.vtk", "VECTORS", "WECTORS",
               "f:12: expected a section of STRUCTURED_POINTS with VECTORS or FIELD data, found 'WECTORS'"},
        Damage{"VtkOtherGrid", "vectors.vtk", "STRUCTURED_POINTS", "POLYDATA",
               "f:4: expected STRUCTURED_POINTS, or evenly spaced points as RECTILINEAR_GRID or "
               "STRUCTURED_GRID, "
               "found 'POLYDATA'"},
        Damage{"VtkTime", "paraview.vtk", "42.5", "1e16",
               "f:7: expected a TimeValue within 1e15 s, found 1e+16"},
        Damage{"VtkTexts", "paraview.vtk", "solver 1 2", "solver 1 20000",
               "f:54: the file ends before the 20000 texts of this array"},
        Damage{"VtkUneven", "rectilinear.vtk", "100 110 120", "100 111 120",
               "f:7: expected points evenly spaced along x, 10 m apart from 100 on; number 2 is at 111"},
        Damage{"VtkCoordinates", "rectilinear.vtk", "Y_COORDINATES 2 float\n200 220\n", "",
               "f:10: expected the coordinates of the points before the data"},
        Damage{"VtkTurned", "structured.vtk", "100 220 5", "101 220 5",
               "f:18: expected points evenly spaced along x, 10 m apart from 100 on; number 4 is at 101"},
        Damage{"VtkCells", "cells.vtk", "CELL_DATA 12", "CELL_DATA 36",
               "f:8: expected 12 as in DIMENSIONS, found 36"},
        Damage{"VtkBinaryType", "binary.vtk", "wind float", "wind bytes",
               "f:12: expected a VTK type of number, found 'BYTES'"},
        Damage{"VtiHuge", "raw.vti",
               "WholeExtent=\"0 2 0 1 0 1\" Origin=\"100 200 5\" Spacing=\"10 20 5\">\n<Piece "
               "Extent=\"0 2 0 1 0 1\"",
               "WholeExtent=\"0 999 0 999 0 999\">\n<Piece Extent=\"0 999 0 999 0 999\"",
               "f:7:2: wind: expected 12000000000 bytes of data, found 144"},
        Damage{"VtiPiece", "ascii.vti", "<Piece Extent=\"0 2", "<Piece Extent=\"0 1",
               "f:4:2: Extent: expected whole numbers, first before last, the same as WholeExtent"},
        Damage{"VtiNumber", "ascii.vti", "1 0 0\n", "1 x 0\n", "f:7:79: wind: expected a number, found 'x'"},
        Damage{"VtiZlib", "zlib.vti", "eJ", "eK", "f:7:2: wind: compressed block 1 is damaged"},
        Damage{"VtiCompressor", "zlib.vti", "ZLib", "LZ4",
               "f:2:2: compressor: expected  or vtkZLibDataCompressor, found 'vtkLZ4DataCompressor'"},
        Damage{"Toa5Unit", "toa5.dat", "\"m/s\"", "\"V\"", "f:3: Uy: expected V as before, found 'm/s'"},
        Damage{"Toa5Number", "toa5.dat", ",5,-2", ",5,x", "f:7: Uy: expected a number, found 'x'"},
        Damage{"Toa5Column", "toa5.dat", "\"Uz\"", "\"w\"",
               "f:2: Uz: no such column for w; the header has TIMESTAMP, RECORD, Ux, Uy, w"}),
    [](const auto& info) { return info.param.name; });

TEST(DamagedWindFile, RefusesTurbSimThatClaimsAMillionTimes) {
    std::string bytes = bytesOf(caseOf("small.bts"));
    bytes[16] = 0x10;
    EXPECT_EQ(
        firstProblem(readTurbSim(bytes, "f")),
        "f: byte 243: expected 44040435 bytes for 3 x 2 points, 1 tower points and 1048580 times, found 243");
}

TEST(DamagedWindFile, RefusesOtherTurbSimIdentifiers) {
    std::string bytes = bytesOf(caseOf("small.bts"));
    bytes[0] = 9;
    EXPECT_EQ(firstProblem(readTurbSim(bytes, "f")),
              "f: byte 0: expected 7 or 8, the identifier of a TurbSim file");
}

TEST(DamagedWindFile, RefusesAMismatchedPair) {
    const TemporaryFolder folder;
    folder.write("a_vel.asc", bytesOf(caseOf("pair_vel.asc")));
    folder.write("a_ang.asc", replaced(bytesOf(caseOf("pair_ang.asc")), "XLLCENTER 105", "XLLCENTER 115"));
    EXPECT_EQ(firstProblem(readWindFile(folder.path() + "/a_vel.asc")),
              folder.path() + "/a_vel.asc: expected the same cells in both files of the pair");
}

TEST(DamagedWindFile, NamesTheMissingFileOfAPair) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a_vel.asc", bytesOf(caseOf("pair_vel.asc")));
    EXPECT_EQ(firstProblem(readWindFile(file)), folder.path() + "/a_ang.asc: no such file");
}

TEST(DamagedWindFile, RefusesExcessiveSpeed) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("a.vtk", replaced(bytesOf(caseOf("vectors.vtk")), "3 0 0", "300 0 0"));
    EXPECT_EQ(firstProblem(readWindFile(file)),
              file + ": expected winds of at most 200 m/s; number 3 of 12 is faster");
}

TEST(DamagedWindFile, RefusesUnknownFormatsEmptyFilesAndFolders) {
    const TemporaryFolder folder;
    EXPECT_NE(firstProblem(readWindFile(folder.write("a.txt", "hello"))).find("unknown format"),
              std::string::npos);
    EXPECT_NE(firstProblem(readWindFile(folder.write("b.vtk", ""))).find("empty"), std::string::npos);
    EXPECT_NE(firstProblem(readWindFile(folder.path())).find("not a regular file"), std::string::npos);
    EXPECT_NE(firstProblem(readWindFile(folder.path() + "/absent.vtk")).find("no such file"),
              std::string::npos);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>
#include <tests/places/RasterFile.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

using Make = void (*)(const std::string& path);

/// An invalid ground, or invalid keys for it.
struct BadGround {
    const char* name;
    Make make;           ///< Writes the raster; null: no raster.
    std::string message; ///< Part of the expected message.
    std::string lines = "file = \"a.tif\"\n";
    std::string tree = "position = [2, 2]\n";
    std::string head = "";
};

std::ostream& operator<<(std::ostream& out, const BadGround& bad) {
    return out << bad.name;
}

void goodRaster(const std::string& path) {
    RasterFile{}.write(path);
}
void ofCrs(const std::string& path) {
    RasterFile file;
    file.crs = "EPSG:25832";
    file.write(path);
}
void text(const std::string& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
}
/// Writes a large raster, and then its bytes as changed by `spoil`.
void spoilt(const std::string& path, bool tiles, std::size_t (*spoil)(std::string&)) {
    RasterFile file;
    file.columns = file.rows = 300;
    file.value = [](int column, int row) { return column * 7919 % 1009 + row; };
    file.write(path, "GTiff", tiles);
    std::ifstream input(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(input), {}};
    bytes.resize(spoil(bytes));
    text(path, bytes);
}
void withHole(const std::string& path) {
    RasterFile file;
    file.nodata = 111.0;
    file.write(path);
}
void ofBands(const std::string& path) {
    RasterFile file;
    file.bands = 3;
    file.write(path);
}
template <int Unit>
void ofUnit(const std::string& path) {
    RasterFile file;
    file.unit = Unit == 0 ? "hectare" : "degree Celsius";
    file.write(path);
}
void ofPalette(const std::string& path) {
    RasterFile file;
    file.type = GDT_Byte;
    file.isPalette = true;
    file.write(path);
}
void complex(const std::string& path) {
    RasterFile file;
    file.type = GDT_CFloat32;
    file.write(path);
}
void undeclared(const std::string& path) {
    RasterFile file;
    file.value = [](int column, int) { return column == 3 ? -32768.0 : 5.0; };
    file.write(path);
}
void infinite(const std::string& path) {
    RasterFile file;
    file.value = [](int, int) { return std::numeric_limits<double>::infinity(); };
    file.write(path);
}
void scaledAway(const std::string& path) {
    RasterFile file;
    file.scale = 1e30;
    file.write(path);
}
void flat(const std::string& path) {
    RasterFile file;
    file.transform = {0, 0, 0, 4, 0, 0};
    file.write(path);
}
void metresAsDegrees(const std::string& path) {
    RasterFile file;
    file.crs = "EPSG:4326";
    file.transform = {565000, 1, 0, 5934000, 0, -1};
    file.write(path);
}
void elsewhere(const std::string& path) {
    RasterFile file;
    file.crs = "EPSG:4326";
    file.transform = {9, 0.1, 0, 50, 0, -0.1};
    file.write(path);
}
void portableGreymap(const std::string& path) {
    text(path, "P5\n2 2\n255\nabcd");
}
void vrt(const std::string& path, const std::string& source, const std::string& size = "\"4\"") {
    text(path,
         "<VRTDataset rasterXSize=" + size + " rasterYSize=" + size +
             "><GeoTransform>0,1,0,4,0,-1</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\">" +
             source + "</VRTRasterBand></VRTDataset>");
}

const std::string cannotOpen = "a.tif: cannot be read";
const std::string cannotRead = "a.tif: reading failed";

const BadGround badGrounds[] = {
    // The file
    {"Absent", nullptr, "test.treewind:6:8: ground.file: no file \"a.tif\" in "},
    {"Empty", [](const std::string& path) { text(path, ""); }, cannotOpen},
    {"OfText", [](const std::string& path) { text(path, "heights, all of them\n"); }, cannotOpen},
    {"OfZeros", [](const std::string& path) { text(path, std::string(5000, '\0')); }, cannotOpen},
    {"HeadCut",
     [](const std::string& path) { spoilt(path, false, [](std::string&) -> std::size_t { return 6; }); },
     cannotOpen},
    {"CellsCut",
     [](const std::string& path) {
         spoilt(path, false, [](std::string& bytes) { return bytes.size() / 2; });
     },
     cannotRead},
    {"TilesBroken",
     [](const std::string& path) {
         spoilt(path, true, [](std::string& bytes) {
             std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 3), bytes.end(), 'x');
             return bytes.size();
         });
     },
     cannotRead},
    {"GridOfTextCut",
     [](const std::string& path) {
         text(path, "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4");
     },
     cannotRead},
    {"GridOfWords",
     [](const std::string& path) {
         text(path, "ncols many\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
     },
     cannotOpen},
    {"VrtOfNothing", [](const std::string& path) { text(path, "<VRTDataset"); }, cannotOpen},
    {"VrtOfAFileAbsent",
     [](const std::string& path) {
         vrt(path, "<SimpleSource><SourceFilename relativeToVRT=\"1\">no.tif</SourceFilename>"
                   "<SourceBand>1</SourceBand></SimpleSource>");
     },
     "a.tif: its source \"no.tif\" is not a file"},
    {"VrtHuge", [](const std::string& path) { vrt(path, "", "\"2000000000\""); },
     "a.tif: expected at most 400000000 cells, found 2000000000 x 2000000000"},
    {"VrtOfNegativeSize", [](const std::string& path) { vrt(path, "", "\"-4\""); }, cannotOpen},
    // What is in it
    {"Bands", ofBands, "a.tif: expected one band of heights, found 3"},
    {"Palette", ofPalette, "a.tif: expected heights, found colours of a palette"},
    {"Complex", complex, "a.tif: expected heights, found complex numbers"},
    {"Areas", ofUnit<0>, "a.tif: expected heights in metres or feet, found the unit \"hectare\""},
    {"Temperatures", ofUnit<1>, "a.tif: expected heights in metres or feet, found the unit"},
    {"NodataUndeclared", undeclared,
     "a.tif: expected heights in [-12000, 30000] metres, found -32768 in column 3, row 0"},
    {"Infinite", infinite, "a.tif: expected heights in [-12000, 30000] metres, found inf"},
    {"ScaledAway", scaledAway, "a.tif: expected heights in [-12000, 30000] metres"},
    {"OfAFormatThatIsNotRead", portableGreymap, "a.tif: expected a format of docs/treewind.md, found PNM"},
    {"CellsWithoutExtent", flat, "a.tif: its cells have no extent"},
    // Where it is
    {"WithoutCrs", goodRaster,
     "a.tif: it has no coordinate reference system; expected ground.crs to state it", "file = \"a.tif\"\n",
     "position = [2, 2]\n", "crs = \"EPSG:25832\""},
    {"CrsUnknown", goodRaster,
     "test.treewind:7:7: ground.crs: expected a coordinate reference system that PROJ knows",
     "file = \"a.tif\"\ncrs = \"EPSG:1\"\n"},
    {"CrsNotAText", goodRaster, "ground.crs: expected a text in quotes, found 25832",
     "file = \"a.tif\"\ncrs = 25832\n"},
    {"MetresAsDegrees", metresAsDegrees,
     "a.tif: its coordinates are not valid in WGS 84; expected ground.crs to state their system"},
    {"SecondWithoutCrs", ofCrs,
     "a.tif: expected no coordinate reference system, since the files before it have none",
     "file = [\"good.tif\", \"a.tif\"]\n"},
    // Trees
    {"TreeBeyondTheEdge", goodRaster,
     "test.treewind:7:8: ground.file: no ground below 1 of 1 trees, first tree[0] (id \"ash\") at (4.5, 2): "
     "the ground extends over x 0 to 4, y 0 to 4",
     "file = \"a.tif\"\n", "position = [4.5, 2]\nid = \"ash\"\n"},
    {"TreeOverAHole", withHole,
     "no ground below 1 of 1 trees, first tree[0] at (1.5, 2.5): the ground has a hole there",
     "file = \"a.tif\"\n", "position = [1.5, 2.5]\n"},
    {"TreesElsewhere", elsewhere, "no ground below 1 of 1 trees, first tree[0] at (2, 2)"},
    // The section
    {"NoFile", nullptr, "ground.file: missing", ""},
    {"NoFiles", nullptr, "ground.file: expected at least one file", "file = []\n"},
    {"FileNotAText", nullptr, "ground.file: expected a text in quotes, found 7", "file = 7\n"},
    {"NoneAndAFile", goodRaster, "ground.none: cannot be combined with file or crs",
     "none = true\nfile = \"a.tif\"\n"},
    {"NoneNotABoolean", nullptr, "ground.none: expected true or false", "none = 1\n"},
    {"KeyUnknown", goodRaster, "ground.fiel: unknown key", "file = \"a.tif\"\nfiel = 1\n"},
};

class BadGroundTest : public testing::TestWithParam<BadGround> {};

} // namespace

TEST_P(BadGroundTest, GivesOneErrorAndNoOutput) {
    const BadGround& bad = GetParam();
    const TemporaryFolder folder;
    goodRaster(folder.path() + "/good.tif");
    if (bad.make)
        bad.make(folder.path() + "/a.tif");
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::istringstream input("version = 1\n" + bad.head + "\n[[tree]]\n" + bad.tree + "[ground]\n" +
                             bad.lines);
    const auto forest = readForest(input, {"test.treewind", folder.path()});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    ASSERT_FALSE(forest);
    EXPECT_EQ(forest.problems().size(), 1u);
    const std::string text = forest.problems().front().text();
    EXPECT_TRUE(hasPart(text, bad.message));
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(All, BadGroundTest, testing::ValuesIn(badGrounds),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace osgTreeWind

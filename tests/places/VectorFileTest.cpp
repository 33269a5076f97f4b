// SPDX-License-Identifier: MIT
#include <tests/places/GeoJson.h>

#include <osgTreeWind/places/VectorFile.h>

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

namespace osgTreeWind {

namespace {

VectorFile openedVectors(const std::string& path, const std::string& layer = "") {
    auto file = VectorFile::open(path);
    EXPECT_TRUE(file) << file.problems().front().text();
    const Diagnostics problems = file.value().chooseLayer(layer);
    EXPECT_TRUE(problems.empty()) << problems.front().text();
    return std::move(file.value());
}

/// The remaining features, one per line: "feature 0 (1, 2, 3) oak".
std::string remainingFeatures(VectorFile& file) {
    std::string text;
    auto found = file.next();
    for (; found && found.value(); found = file.next()) {
        const auto place = file.place();
        text += file.feature();
        if (place)
            text += " (" + std::to_string(place.value().position.x) + ", " +
                    std::to_string(place.value().position.y) + ", " +
                    std::to_string(place.value().position.z) + ')';
        else
            text += ' ' + place.problems().front().message;
        for (std::size_t i = 0; i < file.columns().size(); ++i)
            text += ' ' + file.text(i);
        text += '\n';
    }
    EXPECT_TRUE(found) << found.problems().front().text();
    return text;
}

const std::string two = geoJson(point("9.5, 50.25, 3", R"("kind": "oak", "h": 1.5)") + "," +
                                point("9.25, 50.5, 0", R"("kind": "elm", "h": null)"));

/// Converts `two` to another format, and expects its first feature.
void expectTheFirstOfTwo(const TemporaryFolder& folder, const std::string& name) {
    SCOPED_TRACE(name);
    folder.write("two.geojson", two);
    convert(folder, "two.geojson", name, name == "a.fgb" ? "-lco SPATIAL_INDEX=NO" : ""); // keeps the order
    const std::string path = folder.path() + '/' + name;
    EXPECT_TRUE(VectorFile::isSupported(path));
    VectorFile file = openedVectors(path);
    const auto kind = std::find(file.columns().begin(), file.columns().end(), "kind");
    ASSERT_NE(kind, file.columns().end());
    ASSERT_TRUE(file.next().value());
    EXPECT_EQ(file.text(static_cast<std::size_t>(kind - file.columns().begin())), "oak");
    if (!file.hasGeometry())
        return;
    const auto place = file.place();
    ASSERT_TRUE(place) << place.problems().front().text();
    EXPECT_NEAR(place.value().position.x, 9.5, 1e-6);
    EXPECT_NEAR(place.value().position.y, 50.25, 1e-6);
}

} // namespace

TEST(VectorFile, ReadsFeaturesInOrder) {
    const TemporaryFolder folder;
    VectorFile file = openedVectors(folder.write("two.geojson", two));
    EXPECT_EQ(file.columns(), (std::vector<std::string>{"kind", "h"}));
    ASSERT_TRUE(file.crs());
    EXPECT_TRUE(file.crs()->isDegrees());
    EXPECT_TRUE(file.hasGeometry());
    const std::string expected = "feature 0 (9.500000, 50.250000, 3.000000) oak 1.5\n"
                                 "feature 1 (9.250000, 50.500000, 0.000000) elm \n";
    EXPECT_EQ(remainingFeatures(file), expected);
    file.rewind();
    EXPECT_EQ(remainingFeatures(file), expected);
}

TEST(VectorFile, NumbersAreNotRounded) {
    const TemporaryFolder folder;
    VectorFile file = openedVectors(folder.write(
        "a.geojson", geoJson(point("1, 2", "\"h\": 0.1234567890123456789, \"n\": 9007199254740993"))));
    ASSERT_TRUE(file.next().value());
    EXPECT_EQ(file.number(0), 0.1234567890123456789);
    EXPECT_EQ(file.text(1), "9007199254740993");
}

TEST(VectorFile, DetectsFormatsByContentOrExtension) {
    REQUIRE_PROGRAM("ogr2ogr");
    const TemporaryFolder folder;
    for (const char* name :
         {"a.gpkg", "a.fgb", "a.shp", "a.gml", "a.geojsonl", "a.tab", "a.sqlite", "a.xlsx", "a.ods"})
        expectTheFirstOfTwo(folder, name);
    std::filesystem::copy_file(folder.path() + "/a.gpkg", folder.path() + "/trees");
    EXPECT_TRUE(VectorFile::isSupported(folder.path() + "/trees"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/a.gfs")) << "reading must not write files";
}

TEST(VectorFile, ReadsColumnsOfKml) {
    REQUIRE_PROGRAM("ogr2ogr");
    if (std::system("ogrinfo --formats | grep -q LIBKML") != 0)
        GTEST_SKIP() << "GDAL has no driver LIBKML, so KML has no columns but Name and Description";
    expectTheFirstOfTwo(TemporaryFolder(), "a.kml");
}

TEST(VectorFile, DoesNotSupportTextTables) {
    const TemporaryFolder folder;
    EXPECT_FALSE(VectorFile::isSupported(folder.write("a.csv", "x,y\n1,2\n")));
    EXPECT_FALSE(VectorFile::isSupported(folder.write("a.txt", "x,y\n1,2\n")));
    EXPECT_FALSE(VectorFile::isSupported(folder.write("a.tab", "x\ty\n1\t2\n")));
    EXPECT_FALSE(VectorFile::isSupported(folder.write("a", "")));
}

TEST(VectorFile, RequiresALayerNameIfThereAreSeveral) {
    REQUIRE_PROGRAM("ogr2ogr");
    const TemporaryFolder folder;
    folder.write("two.geojson", two);
    convert(folder, "two.geojson", "a.gpkg", "-nln trees");
    convert(folder, "two.geojson", "a.gpkg", "-update -nln shrubs");
    auto result = VectorFile::open(folder.path() + "/a.gpkg");
    ASSERT_TRUE(result);
    VectorFile& file = result.value();
    EXPECT_EQ(file.layers(), (std::vector<std::string>{"trees", "shrubs"}));
    EXPECT_EQ(
        file.chooseLayer("").front().message,
        "expected layer to name one of its 2 layers, of which \"trees\" is the first; ogrinfo lists them");
    EXPECT_EQ(file.chooseLayer("tree").front().message,
              "no layer \"tree\" among its 2 layers, of which \"trees\" is the first; ogrinfo lists them");
    ASSERT_TRUE(file.chooseLayer("shrubs").empty());
    ASSERT_TRUE(file.next().value());
    EXPECT_EQ(file.feature(), "layer \"shrubs\", feature 1");
}

TEST(VectorFile, OutlineGivesItsCentroidAndWidth) {
    const TemporaryFolder folder;
    // An L of three squares of 2 m (centroid 5/3 m from the corner); a rectangle of 27 m2 with a hole.
    VectorFile file = openedVectors(folder.write(
        "a.geojson",
        geoJson(
            feature(
                R"({"type": "Polygon", "coordinates": [[[10,20],[14,20],[14,22],[12,22],[12,24],[10,24],[10,20]]]})") +
                "," +
                feature(
                    R"({"type": "MultiPolygon", "coordinates": [[[[0,0],[9,0],[9,3],[0,3],[0,0]],[[4,1],[5,1],[5,2],[4,2],[4,1]]]]})"),
            "urn:ogc:def:crs:EPSG::25832")));
    ASSERT_TRUE(file.next().value());
    VectorPlace place = file.place().value();
    EXPECT_NEAR(place.position.x, 10.0 + 5.0 / 3.0, 1e-9);
    EXPECT_NEAR(place.position.y, 20.0 + 5.0 / 3.0, 1e-9);
    EXPECT_NEAR(*place.width, 2.0 * std::sqrt(12.0 / glm::pi<double>()), 1e-9);
    ASSERT_TRUE(file.next().value());
    place = file.place().value();
    EXPECT_NEAR(place.position.x, 4.5, 1e-9);
    EXPECT_NEAR(*place.width, 2.0 * std::sqrt(26.0 / glm::pi<double>()), 1e-9);
}

/// The bytes of this table are Latin-1, and neither it nor a file beside it says so.
TEST(VectorFile, TextsOfUnknownEncodingAreReadAsWindows1252) {
    const TemporaryFolder folder;
    folder.write("a.geojson",
                 geoJson(point("9, 50", "\"Baumart\": \"H\u00e4ngebirke\", \"ID\": \"Stra\u00dfe-1\"") + "," +
                         point("9, 50", "\"Baumart\": \"Rotbuche\", \"ID\": \"\"") + "," +
                         point("9, 50", "\"Baumart\": \"S\u00e4uleneiche\", \"ID\": \"3\"")));
    convert(folder, "a.geojson", "a.shp", "-lco ENCODING=ISO-8859-1");
    std::filesystem::remove(folder.path() + "/a.cpg");
    {
        std::fstream table(folder.path() + "/a.dbf", std::ios::in | std::ios::out | std::ios::binary);
        table.seekp(29); // the code page
        table.put('\0');
    }
    VectorFile file = openedVectors(folder.path() + "/a.shp");
    EXPECT_EQ(remainingFeatures(file),
              "feature 0 (9.000000, 50.000000, 0.000000) H\xc3\xa4ngebirke Stra\xc3\x9f"
              "e-1\n"
              "feature 1 (9.000000, 50.000000, 0.000000) Rotbuche \n"
              "feature 2 (9.000000, 50.000000, 0.000000) S\xc3\xa4uleneiche 3\n");
    const std::string note = "is no UTF-8 and is read as Windows-1252";
    EXPECT_EQ(file.warnings(),
              std::vector<std::string>{note + "; a .cpg file beside it would name another encoding"});
    folder.write("a.cpg", "ISO-8859-2");
    VectorFile stated = openedVectors(folder.path() + "/a.shp");
    EXPECT_NE(remainingFeatures(stated).find("S\xc3\xa4uleneiche"), std::string::npos);
    EXPECT_TRUE(stated.warnings().empty());

    VectorFile json =
        openedVectors(folder.write("b.geojson", geoJson(point("9, 50", "\"H\xf6he\": 5, \"n\": \"\x80\""))));
    EXPECT_EQ(json.columns(), (std::vector<std::string>{"H\xc3\xb6he", "n"}));
    ASSERT_TRUE(json.next().value());
    EXPECT_EQ(json.text(1), "\xe2\x82\xac");
    EXPECT_EQ(json.warnings(), std::vector<std::string>{note});
}

TEST(VectorFile, ThreadsMayReadFilesConcurrently) {
    const TemporaryFolder folder;
    std::string features;
    for (int i = 0; i < 500; ++i)
        features += (i ? "," : "") + point(std::to_string(i) + ", 1");
    const std::string path = folder.write("a.geojson", geoJson(features));
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&] {
            VectorFile file = openedVectors(path);
            int count = 0;
            while (file.next().value())
                ++count;
            EXPECT_EQ(count, 500);
        });
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace osgTreeWind

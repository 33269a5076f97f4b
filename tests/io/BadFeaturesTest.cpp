// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>
#include <tests/places/GeoJson.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

/// An invalid file of features, or invalid keys for it.
struct BadFeatures {
    const char* name;
    std::string file, content; ///< Without content, the file is made from valid trees.
    std::string lines;         ///< Lines of [inventory].
    std::string message;       ///< Part of the expected message.
    std::string head = "";     ///< First lines of the document.
};

std::ostream& operator<<(std::ostream& out, const BadFeatures& bad) {
    return out << bad.name;
}

const std::string goodFeatures =
    geoJson(point("565000, 5934000", R"("h": 5)") + "," + point("565009, 5934000", R"("h": 7)"), utm);

std::string shape(const std::string& type, const std::string& coordinates) {
    return geoJson(feature("{\"type\": \"" + type + "\", \"coordinates\": " + coordinates + "}"), utm);
}
std::string city(const std::string& rest) {
    return R"({"type": "CityJSON", "version": "1.1", "vertices": [[1,2,3]])" + rest + "}";
}
std::string cityTree(const std::string& geometry) {
    return city(R"(, "CityObjects": {"t": {"type": "SolitaryVegetationObject", "geometry": )" + geometry +
                "}}");
}

const std::string columnH = "columns = { height = \"h\" }\n";

const BadFeatures badFeatures[] = {
    // The file
    {"GeoJsonCut", "a.geojson", goodFeatures.substr(0, goodFeatures.size() - 40), "",
     "a.geojson: cannot be read: "},
    {"GeoJsonEmpty", "a.geojson", "", "", "a.geojson: cannot be read: "},
    {"GeoJsonOfNothing", "a.geojson", "{}", "", "a.geojson: cannot be read: "},
    {"GeoJsonIsBinary", "a.geojson", std::string("\0\1\2\3", 4), "", "a.geojson: cannot be read: "},
    {"GeoPackageOfText", "a.gpkg", "not a database", "", "a.gpkg: cannot be read: "},
    {"GeoPackageCut", "a.gpkg", "", "", "a.gpkg: "},
    {"FlatGeobufCut", "a.fgb", "", "", "a.fgb: "},
    {"ShapefileCut", "a.shp", "", "", "a.shp: "},
    {"GmlCut", "a.gml",
     "<?xml version=\"1.0\"?><ogr:FeatureCollection "
     "xmlns:gml=\"http://www.opengis.net/gml\"><gml:featureMember><a><gml:Po",
     "", "a.gml: "},
    {"OsmCut", "a.osm",
     "<?xml version=\"1.0\"?><osm version=\"0.6\"><node id=\"1\" lat=\"1\" lon=\"2\"><tag k=\"natural\" "
     "v=\"tree\"/></node><no",
     "", "reading failed: XML parsing of OSM"},
    {"PbfOfText", "a.osm.pbf", "not a protocol buffer", "", "a.osm.pbf: cannot be read: "},
    {"CityJsonCut", "a.json", R"({"type": "CityJSON", "vertices": [[1,2)", "", "a.json: cannot be read: "},
    {"CityJsonWithoutObjects", "a.json", city(""), "", "expected CityObjects"},
    {"CityJsonWithoutTrees", "a.json", city(R"(, "CityObjects": {})"), "", "the inventory has no trees"},
    {"CityJsonCrs", "a.json", city(R"(, "metadata": {"referenceSystem": "moon"}, "CityObjects": {})"), "",
     "expected a coordinate reference system that PROJ knows"},
    {"CityJsonVertexAbsent", "a.json", cityTree(R"([{"type": "MultiPoint", "boundaries": [7]}])"), "",
     "feature 0: it has no geometry"},
    {"CityJsonWithoutGeometry", "a.json", cityTree("[]"), "", "feature 0: it has no geometry"},
    {"LayerEmpty", "a.geojson", geoJson(""), "", "a.geojson: the inventory has no trees"},
    // The layer
    {"LayerUnknown", "a.geojson", goodFeatures, "layer = \"bushes\"\n",
     "no layer \"bushes\"; its only layer is \"a\""},
    {"LayerOfATable", "a.csv", "x,y\n1,2\n", "layer = \"a\"\n" + xy,
     "inventory.layer: applies only to a file with layers"},
    {"DelimiterOfFeatures", "a.geojson", goodFeatures, "delimiter = \";\"\n",
     "inventory.delimiter: applies only to a CSV table"},
    {"FilterOfATable", "a.csv", "x,y\n1,2\n", "filter = \"x > 1\"\n" + xy, "the inventory has no trees"},
    {"FilterBroken", "a.geojson", goodFeatures, "filter = \"h >\"\n",
     "inventory.filter: at character 4: expected an expression of SQL, found nothing"},
    {"FilterOfAColumnAbsent", "a.geojson", goodFeatures, "filter = \"tall > 3\"\n",
     "inventory.filter: at character 1: no column \"tall\" in "},
    {"FilterOfAGeoPackage", "b.gpkg", "", "filter = \"tall > 3\"\n", "tall"},
    {"FilterOfTheDatabase", "b.gpkg", "", "filter = \"h > (SELECT 1)\"\n", "inventory.filter: at character "},
    {"FilterLeavesNone", "a.geojson", goodFeatures, "filter = \"h > 100\"\n", "the inventory has no trees"},
    // Columns
    {"ColumnAbsent", "a.geojson", goodFeatures, "columns = { height = \"tall\" }\n",
     "inventory.columns.height: no column \"tall\" in "},
    {"ColumnYAbsent", "a.geojson", goodFeatures, "columns = { x = \"h\" }\n", "inventory.columns.y: missing"},
    {"NoGeometry", "a.dbf", "", columnH, "inventory.columns.x: missing"},
    // Systems
    {"CrsUnknown", "a.geojson", goodFeatures, "crs = \"EPSG:1\"\n",
     "inventory.crs: expected a coordinate reference system that PROJ knows"},
    {"CrsOfTheForestUnknown", "a.geojson", goodFeatures, "",
     "test.treewind:2:7: crs: expected a coordinate reference system", "crs = \"Mars 2000\""},
    {"CrsOfTheForestOnDegrees", "a.geojson", goodFeatures, "",
     "crs: expected a projected system in metres, found WGS 84, which uses degrees", "crs = \"EPSG:4326\""},
    {"CrsOfTheForestInFeet", "a.geojson", goodFeatures, "",
     "crs: expected a projected system in metres, found NAD83 / New York Long Island (ftUS) in US survey "
     "foot",
     "crs = \"EPSG:2263\""},
    {"CrsNotAText", "a.geojson", goodFeatures, "crs = 25832\n",
     "inventory.crs: expected a text in quotes, found 25832"},
    {"CrsAndUnits", "a.csv", "x,y\n9,50\n", "crs = \"EPSG:4326\"\nunits = { x = \"ft\" }\n" + xy,
     "inventory.units: expected no units for x and y"},
    {"LatitudeTooLarge", "a.geojson", geoJson(point("9, 95")), "",
     "inventory.file: its places are no longitudes and latitudes; if their latitude stands first, set",
     "crs = \"EPSG:25832\""},
    {"LongitudeTooLarge", "a.geojson", geoJson(point("400, 95")), "",
     "feature 0: the place (400, 95) cannot be transformed to the crs of the forest", "crs = \"EPSG:25832\""},
    {"MetresTakenForDegrees", "a.geojson", geoJson(point("565000, 5934000")), "",
     "inventory.file: its coordinates are not valid in WGS 84; expected crs to state their system"},
    {"TooFarApart", "a.geojson", geoJson(point("9, 50") + "," + point("19, 50")), "",
     "more than 100 km from the origin"},
    // Features
    {"GeometryNull", "a.geojson", geoJson(feature("null"), utm), "", "feature 0: it has no geometry"},
    {"GeometryEmpty", "a.geojson", shape("Point", "[]"), "", "feature 0: it has no geometry"},
    {"PolygonEmpty", "a.geojson", shape("Polygon", "[]"), "", "feature 0: it has no geometry"},
    {"Line", "a.geojson", shape("LineString", "[[1,2],[3,4]]"), "",
     "feature 0: expected a point or the outline of a crown, found LINESTRING"},
    {"TwoPoints", "a.geojson", shape("MultiPoint", "[[1,2],[3,4]]"), "",
     "feature 0: expected a point or the outline of a crown, found MULTIPOINT"},
    {"CoordinateNaN", "a.geojson", shape("Point", "[NaN, 5]"), "", "feature 0"},
    {"CoordinateInfinite", "a.geojson", shape("Point", "[Infinity, 5]"), "", "feature 0"},
    {"CoordinateBeyondDouble", "a.geojson", shape("Point", "[1e400, 5]"), "", "a.geojson"}, // words of GDAL
    {"CoordinateHuge", "a.geojson", shape("Point", "[1e12, 5]"), "",
     "feature 0: expected coordinates in [-100000000, 100000000] metres"},
    {"OutlineNaN", "a.geojson", shape("Polygon", "[[[0,0],[9,0],[NaN,9],[0,0]]]"), "", "feature 0"},
};

class BadFeaturesTest : public testing::TestWithParam<BadFeatures> {};

/// Writes valid trees in the format of `file`; if the name of the test contains "Cut", truncated.
void make(const TemporaryFolder& folder, const BadFeatures& bad) {
    folder.write("good.geojson", goodFeatures);
    const std::string path = folder.path() + '/' + bad.file;
    if (bad.file == "a.dbf") {
        convert(folder, "good.geojson", "a.shp");
        std::filesystem::remove(folder.path() + "/a.shp");
        return;
    }
    convert(folder, "good.geojson", bad.file);
    if (std::string(bad.name).find("Cut") != std::string::npos)
        std::filesystem::resize_file(path, std::filesystem::file_size(path) * 2 / 3);
}

} // namespace

TEST_P(BadFeaturesTest, GiveOneErrorAndNoOutput) {
    const BadFeatures& bad = GetParam();
    const TemporaryFolder folder;
    if (bad.content.empty() && bad.file != "a.geojson") {
        REQUIRE_PROGRAM("ogr2ogr");
        make(folder, bad);
    } else
        folder.write(bad.file, bad.content);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const auto forest = readInventoryOf(folder.path(), "file = \"" + bad.file + "\"\n" + bad.lines, bad.head);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    ASSERT_FALSE(forest);
    EXPECT_EQ(forest.problems().size(), 1u);
    const std::string text = forest.problems().front().text();
    EXPECT_TRUE(hasPart(text, bad.message));
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(All, BadFeaturesTest, testing::ValuesIn(badFeatures),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace osgTreeWind

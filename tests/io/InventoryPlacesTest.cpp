// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>
#include <tests/places/GeoJson.h>

namespace osgTreeWind {

namespace {

/// Transforms places with the independent program cs2cs. @param places as "x y" lines.
std::vector<glm::dvec2> cs2cs(const std::string& from, const std::string& to, const std::string& places) {
    const TemporaryFolder folder;
    folder.write("in", places);
    const std::string command =
        "cs2cs -f %.6f '" + from + "' '" + to + "' " + folder.path() + "/in > " + folder.path() + "/out";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream out(folder.path() + "/out");
    std::vector<glm::dvec2> transformed;
    glm::dvec3 place;
    while (out >> place.x >> place.y >> place.z)
        transformed.emplace_back(place.x, place.y);
    return transformed;
}

void expectAllAt(const ForestDescription& forest, const std::vector<glm::dvec2>& places, double tolerance) {
    ASSERT_EQ(forest.trees.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        expectAt(forest.trees[i], places[i].x, places[i].y, tolerance);
}

} // namespace

TEST(InventoryCrs, TreesOfCuestaMatchCs2cs) {
    REQUIRE_REAL_DATA(file, "place/cuesta_trees.geojson");
    REQUIRE_PROGRAM("cs2cs");
    const ForestFile forest = inventoryOf(
        "", "file = \"" + file + "\"\ncolumns = { id = \"tree_id\", species = \"scientific_name\" }\n");
    std::ifstream text(file);
    std::string places; // latitude first, the axis order of EPSG:4326
    for (std::string line, key = "\"coordinates\": ["; std::getline(text, line);)
        if (const std::size_t at = line.find(key); at != std::string::npos) {
            const std::string x = line.substr(at + key.size(), line.find(',', at) - at - key.size());
            places +=
                line.substr(line.find(',', at) + 1, line.find(']', at) - line.find(',', at) - 1) + x + '\n';
        }
    ASSERT_EQ(forest.trees.size(), 99u);
    EXPECT_EQ(forest.crs, "EPSG:32610");
    EXPECT_TRUE(forest.crsFromInventory);
    EXPECT_EQ(forest.trees[0].name, "46");
    expectAllAt(forest, cs2cs("EPSG:4326", "EPSG:32610", places), 0.001);
    // On another map with another datum.
    const ForestFile state = inventoryOf("", "file = \"" + file + "\"\n", "crs = \"EPSG:26943\"");
    EXPECT_FALSE(state.crsFromInventory);
    expectAllAt(state, cs2cs("EPSG:4326", "EPSG:26943", places), 0.1);
}

TEST(InventoryCrs, TablesInDegreesAreStatedOrDetectedByColumnNames) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n9.0,0.0\n9.0,0.0001\n");
    folder.write("b.csv", "Longitude,LAT\n9.0,0.0\n9.0,0.0001\n");
    for (const std::string& lines :
         {"file = \"a.csv\"\ncrs = \"EPSG:4326\"\n" + xy,
          std::string("file = \"b.csv\"\ncolumns = { x = \"Longitude\", y = \"LAT\" }\n")}) {
        const ForestFile forest = inventoryOf(folder.path(), lines);
        EXPECT_EQ(forest.crs, "EPSG:32632");
        ASSERT_EQ(forest.trees.size(), 2u);
        expectAt(forest.trees[0], 500000.0, 0.0);
        expectAt(forest.trees[1], 500000.0, 11.053, 0.01);
        EXPECT_EQ(forest.origin, glm::dvec3(500000, 6, 0)) << "the centre, as without a crs";
    }
}

TEST(InventoryCrs, WithoutACrsCoordinatesAreUnchanged) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n9.0,0.5\n");
    const ForestFile forest = inventoryOf(folder.path(), "file = \"a.csv\"\n" + xy);
    EXPECT_EQ(forest.crs, "");
    EXPECT_FALSE(forest.crsFromInventory);
    EXPECT_EQ(forest.trees[0].position, glm::dvec3(9.0, 0.5, 0.0));
    const ForestFile known = inventoryOf(folder.path(), "file = \"a.csv\"\n" + xy, "crs = \"EPSG:25832\"");
    EXPECT_EQ(known.trees[0].position, glm::dvec3(9.0, 0.5, 0.0));
    EXPECT_EQ(known.crs, "EPSG:25832");
}

TEST(InventoryCrs, FirstProjectedMapIsUsedForTheForest) {
    const TemporaryFolder folder;
    folder.write("a.geojson", geoJson(point("565000.25, 5934000.5"), "urn:ogc:def:crs:EPSG::25832"));
    std::istringstream input("version = 1\n[[inventory]]\nfile = \"a.geojson\"\n[[inventory]]\n"
                             "file = \"b.csv\"\ncrs = \"EPSG:25831\"\n" +
                             xy);
    folder.write("b.csv", "x,y\n960000,5950000\n");
    const auto forest = readForest(input, {"test.treewind", folder.path()});
    ASSERT_TRUE(forest) << forest.problems().front().text();
    EXPECT_EQ(forest.value().crs, "EPSG:25832");
    EXPECT_TRUE(forest.value().crsFromInventory);
    EXPECT_EQ(forest.value().trees[0].position, glm::dvec3(565000.25, 5934000.5, 0.0)) << "unchanged";
    if (hasProgram("cs2cs")) {
        const glm::dvec2 expected = cs2cs("EPSG:25831", "EPSG:25832", "960000 5950000\n").front();
        expectAt(forest.value().trees[1], expected.x, expected.y);
    }
}

/// The state plane of New York is in US survey feet.
TEST(InventoryCrs, ReprojectsMapsInFeet) {
    REQUIRE_PROGRAM("cs2cs");
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n985000,200000\n985100,200000\n");
    const std::string lines = "file = \"a.csv\"\ncrs = \"EPSG:2263\"\n" + xy;
    const std::string places = "985000 200000\n985100 200000\n";
    const ForestFile forest = inventoryOf(folder.path(), lines);
    EXPECT_EQ(forest.crs, "EPSG:32618");
    expectAllAt(forest, cs2cs("EPSG:2263", "EPSG:32618", places), 0.001);
    EXPECT_NEAR(forest.trees[1].position.x - forest.trees[0].position.x, 30.48, 0.02);
    expectAllAt(inventoryOf(folder.path(), lines, "crs = \"EPSG:6347\""),
                cs2cs("EPSG:2263", "EPSG:6347", places), 0.001);
}

/// In GML, EPSG:4326 has the latitude first, and EPSG:2193 (New Zealand) the northing.
TEST(InventoryCrs, IgnoresTheAxisOrderOfTheAuthority) {
    const TemporaryFolder folder;
    const auto gml = [](const std::string& crs, const std::string& place) {
        return "<?xml version=\"1.0\"?>\n<ogr:FeatureCollection xmlns:ogr=\"http://ogr.maptools.org/\" "
               "xmlns:gml=\"http://www.opengis.net/gml/3.2\" gml:id=\"a\"><ogr:featureMember><ogr:trees "
               "gml:id=\"t.0\"><ogr:geometryProperty><gml:Point srsName=\"urn:ogc:def:crs:EPSG::" +
               crs + "\" gml:id=\"g\"><gml:pos>" + place +
               "</gml:pos></gml:Point></ogr:geometryProperty><ogr:h>7</ogr:h></ogr:trees></ogr:featureMember>"
               "</ogr:FeatureCollection>\n";
    };
    folder.write("a.gml", gml("4326", "0.0001 9.0"));
    ForestFile forest = inventoryOf(folder.path(), "file = \"a.gml\"\ncolumns = { height = \"h\" }\n");
    ASSERT_EQ(forest.trees.size(), 1u);
    EXPECT_EQ(forest.crs, "EPSG:32632");
    expectAt(forest.trees[0], 500000.0, 11.053, 0.01);
    EXPECT_EQ(forest.trees[0].size.height, 7.0f);
    folder.write("b.gml", gml("2193", "5427000 1748000"));
    forest = inventoryOf(folder.path(), "file = \"b.gml\"\n");
    ASSERT_EQ(forest.trees.size(), 1u);
    EXPECT_EQ(forest.crs, "EPSG:2193");
    expectAt(forest.trees[0], 1748000.0, 5427000.0);
}

/// The layer's geometry has another CRS.
TEST(InventoryCrs, ColumnNamesImplyDegreesForAnyGeometry) {
    const TemporaryFolder folder;
    folder.write("a.geojson", geoJson(point("565000, 5934000", R"("lon": 9.0, "lat": 0.0)"),
                                      "urn:ogc:def:crs:EPSG::25832"));
    const ForestFile forest =
        inventoryOf(folder.path(), "file = \"a.geojson\"\ncolumns = { x = \"lon\", y = \"lat\" }\n");
    EXPECT_EQ(forest.crs, "EPSG:32632");
    expectAt(forest.trees[0], 500000.0, 0.0);
}

TEST(InventoryCrs, StatedCrsOverridesTheFile) {
    const TemporaryFolder folder;
    folder.write("a.geojson", geoJson(point("565000, 5934000"))); // not in degrees as GeoJSON requires
    const ForestFile forest = inventoryOf(folder.path(), "file = \"a.geojson\"\ncrs = \"EPSG:25832\"\n");
    EXPECT_EQ(forest.crs, "EPSG:25832");
    expectAt(forest.trees[0], 565000.0, 5934000.0);
}

TEST(InventoryPlaces, ThatTheirCrsCannotHaveAreAProblem) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n33391200,5820000\n33391210,5820000\n"); // with the number of the zone
    const auto forest = readInventoryOf(
        folder.path(), "file = \"a.csv\"\ncrs = \"EPSG:25833\"\ncolumns = { x = \"x\", y = \"y\" }\n");
    EXPECT_TRUE(hasPart(firstProblem(forest),
                        "inventory.crs: the place 33391200, 5820000 is not in ETRS89 / UTM zone "
                        "33N"))
        << firstProblem(forest);
}

TEST(InventoryPlaces, WithoutACrsAreInMetresWithANote) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n6016267,2111000\n");
    const std::string keys = "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\" }\n";
    EXPECT_TRUE(hasPart(notesOf(inventoryOf(folder.path(), keys)),
                        "no crs is known, and places are taken as metres"));
    folder.write("a.csv", "x,y\n67,20\n");
    EXPECT_FALSE(hasPart(notesOf(inventoryOf(folder.path(), keys)), "no crs"));
}

TEST(InventoryPlaces, AFileWithoutColumnsSaysWhichItHas) {
    const TemporaryFolder folder;
    folder.write("a.csv", "treeID,Z\n1,20\n");
    EXPECT_TRUE(hasPart(firstProblem(readInventoryOf(folder.path(), "file = \"a.csv\"\n")),
                        "inventory.columns: missing; the file has treeID, Z"));
}

} // namespace osgTreeWind

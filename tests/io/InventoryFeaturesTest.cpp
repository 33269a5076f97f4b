// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>
#include <tests/places/GeoJson.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <filesystem>

namespace osgTreeWind {

namespace {

const std::string trees = geoJson(
    point("565000, 5934000, 0", R"("nr": "a 1", "kind": "oak", "h": 12.5, "d": 40, "girth": null)") + "," +
        point("565010, 5934000, 0",
              R"("nr": "a 2", "kind": "Picea abies", "h": null, "d": null, "girth": 157.0796)") +
        "," +
        point("565020, 5934000, 3.5", R"("nr": "a 3", "kind": "moon tree", "h": 9, "d": 10, "girth": 5)"),
    utm);
const std::string featureColumns =
    "columns = { id = \"nr\", species = \"kind\", height = \"h\", trunk_diameter = \"d\", "
    "circumference = \"girth\" }\n"
    "units = { trunk_diameter = \"cm\", circumference = \"cm\" }\n";

void expectThreeTrees(const ForestFile& forest) {
    ASSERT_EQ(forest.trees.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        expectAt(forest.trees[i], 565000.0 + 10.0 * static_cast<double>(i), 5934000.0);
        EXPECT_EQ(forest.trees[i].name, "a " + std::to_string(i + 1));
    }
    const auto species = [&](std::size_t i) { return forest.species[forest.trees[i].species].name; };
    EXPECT_EQ(species(0) + ", " + species(1) + ", " + species(2), "oak, Norway spruce, beech");
    EXPECT_FLOAT_EQ(forest.trees[0].size.height, 12.5f);
    EXPECT_TRUE(forest.trees[1].estimated.height);
    EXPECT_FLOAT_EQ(forest.trees[0].size.trunkDiameter, 0.4f);
    EXPECT_NEAR(forest.trees[1].size.trunkDiameter, 0.5f, 1e-6f) << "from its girth";
    EXPECT_FLOAT_EQ(forest.trees[2].size.trunkDiameter, 0.1f) << "the diameter has precedence over the girth";
    EXPECT_TRUE(hasPart(notesOf(forest), "1 trees of unknown species are read as \"beech\": moon tree (1)"));
    EXPECT_TRUE(hasPart(notesOf(forest),
                        "the z of places is taken as the height of feet, 0 to 3.5 m, without a "
                        "ground to compare; inventory.z sets another meaning"));
}

} // namespace

TEST(InventoryFeatures, AllFormatsGiveTheSameTrees) {
    const TemporaryFolder folder;
    folder.write("a.geojson", trees);
    const ForestFile first = inventoryOf(folder.path(), "file = \"a.geojson\"\n" + featureColumns);
    expectThreeTrees(first);
    EXPECT_EQ(first.trees[2].position.z, 3.5);
    REQUIRE_PROGRAM("ogr2ogr");
    for (const char* name : {"b.gpkg", "b.fgb", "b.shp", "b.gml"}) {
        SCOPED_TRACE(name);
        convert(folder, "a.geojson", name,
                name == std::string("b.fgb") ? "-lco SPATIAL_INDEX=NO" : ""); // keeps the order
        const ForestFile forest =
            inventoryOf(folder.path(), "file = \"" + std::string(name) + "\"\n" + featureColumns);
        expectThreeTrees(forest);
        ASSERT_FALSE(HasFailure());
        EXPECT_EQ(forest.trees[0].heading, first.trees[0].heading);
        EXPECT_EQ(forest.trees[2].seed, first.trees[2].seed);
    }
}

TEST(InventoryFeatures, SelectsALayerAndFilters) {
    REQUIRE_PROGRAM("ogr2ogr");
    const TemporaryFolder folder;
    folder.write("a.geojson", trees);
    convert(folder, "a.geojson", "a.gpkg", "-nln standing");
    convert(folder, "a.geojson", "a.gpkg", "-update -nln felled");
    for (const std::string file : {"file = \"a.gpkg\"\nlayer = \"standing\"\n", "file = \"a.geojson\"\n"}) {
        const ForestFile forest =
            inventoryOf(folder.path(), file + "filter = \"h >= 9 AND kind <> 'oak'\"\n" + featureColumns);
        ASSERT_EQ(forest.trees.size(), 1u);
        EXPECT_EQ(forest.trees[0].name, "a 3");
    }
}

/// International feet, US survey feet and inches.
TEST(InventoryFeatures, ConvertsUnitsOfColumns) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h,d,g,c\n1000,0,100,10,,30\n0,0,,,100,\n");
    const ForestFile forest = inventoryOf(
        folder.path(),
        "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\", trunk_diameter = \"d\", "
        "circumference = \"g\", crown_width = \"c\" }\nunits = { x = \"us-ft\", height = \"us-ft\", "
        "trunk_diameter = \"in\", circumference = \"in\", crown_width = \"ft\" }\n");
    EXPECT_NEAR(forest.trees[0].position.x, 304.8006096, 1e-6);
    EXPECT_NEAR(forest.trees[0].size.height, 30.48006f, 1e-5f);
    EXPECT_NEAR(forest.trees[0].size.trunkDiameter, 0.254f, 1e-6f);
    EXPECT_NEAR(forest.trees[0].size.crownWidth, 9.144f, 1e-5f);
    EXPECT_NEAR(forest.trees[1].size.trunkDiameter, 2.54f / glm::pi<float>(), 1e-6f);
}

/// A crown of 8 m east-west and 6 m north-south at 60 degrees north, in degrees.
TEST(InventoryFeatures, OutlinesGiveCrownWidthsInMetres) {
    const TemporaryFolder folder;
    folder.write(
        "a.geojson",
        geoJson(feature(R"({"type": "Polygon", "coordinates": [[[8.9999283,59.9999731],[9.0000717,59.9999731],
[9.0000717,60.0000269],[8.9999283,60.0000269],[8.9999283,59.9999731]]]})",
                        R"("w": null)")));
    const ForestFile forest = inventoryOf(folder.path(), "file = \"a.geojson\"\n");
    ASSERT_EQ(forest.trees.size(), 1u);
    expectAt(forest.trees[0], 500000.0, 6651411.19, 0.01);          // pyproj: EPSG:4326 to EPSG:32632
    const float width = 2.0f * std::sqrt(48.0f / glm::pi<float>()); // of the circle of the same area
    EXPECT_NEAR(forest.trees[0].size.crownWidth, width, 0.02f);
    const std::string column = "file = \"a.geojson\"\ncolumns = { crown_width = \"w\" }\n";
    EXPECT_NEAR(inventoryOf(folder.path(), column).trees[0].size.crownWidth, width, 0.02f);
    folder.write("a.geojson",
                 geoJson(feature(R"({"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,9],[0,0]]]})",
                                 R"("w": 5)"),
                         utm));
    EXPECT_EQ(inventoryOf(folder.path(), column).trees[0].size.crownWidth, 5.0f)
        << "the column has precedence";
}

TEST(InventoryFeatures, ShapefilesWithoutAProjectionAreInMetres) {
    REQUIRE_PROGRAM("ogr2ogr");
    const TemporaryFolder folder;
    folder.write("a.geojson", trees);
    convert(folder, "a.geojson", "a.shp");
    std::filesystem::remove(folder.path() + "/a.prj");
    ForestFile forest = inventoryOf(folder.path(), "file = \"a.shp\"\n" + featureColumns);
    expectThreeTrees(forest);
    EXPECT_EQ(forest.crs, "");
    forest = inventoryOf(folder.path(), "file = \"a.shp\"\ncrs = \"EPSG:25832\"\n" + featureColumns);
    expectThreeTrees(forest);
    EXPECT_EQ(forest.crs, "EPSG:25832");
}

/// Compares the campus as outlines without a .prj with the campus as a table.
TEST(InventoryFeatures, ShapefileOfTheCampusEqualsItsTable) {
    REQUIRE_REAL_DATA(shapes, "utah_campus/EngQuad_AlEqTreeCleaned.shp");
    REQUIRE_REAL_DATA(table, "utah_campus/utah_campus_trees.csv");
    const ForestFile outlines =
        inventoryOf("", "file = \"" + shapes +
                            "\"\ncolumns = { species = \"AESciName\", height = \"H\", "
                            "trunk_diameter = \"dbh\" }\n");
    const ForestFile points =
        inventoryOf("", "file = \"" + table +
                            "\"\ncolumns = { x = \"x\", y = \"y\", species = \"AESciName\", "
                            "height = \"H\", trunk_diameter = \"dbh\", crown_width = \"crown_d\" }\n");
    ASSERT_EQ(outlines.trees.size(), 1233u);
    ASSERT_EQ(points.trees.size(), 1233u);
    EXPECT_EQ(outlines.crs, "");
    EXPECT_EQ(outlines.origin, points.origin);
    // The outlines are regular polygons of 20 corners.
    const float polygon = std::sqrt(20.0f / glm::two_pi<float>() * std::sin(glm::two_pi<float>() / 20.0f));
    for (std::size_t i = 0; i < 1233; ++i) {
        const TreePlacement &a = outlines.trees[i], &b = points.trees[i];
        EXPECT_LT(glm::distance(a.position, b.position), 0.01) << i;
        EXPECT_EQ(a.species, b.species) << i;
        EXPECT_EQ(a.size.height, b.size.height) << i;
        EXPECT_EQ(a.size.trunkDiameter, b.size.trunkDiameter) << i;
        EXPECT_NEAR(a.size.crownWidth, polygon * b.size.crownWidth, 0.001f) << i;
    }
}

TEST(InventoryFeatures, OpenStreetMapNeedsNoColumns) {
    const TemporaryFolder folder;
    folder.write("a.osm", R"(<?xml version="1.0"?><osm version="0.6">
<node id="11" version="1" lat="0.0" lon="9.0"><tag k="natural" v="tree"/><tag k="species" v="Quercus robur"/>
<tag k="height" v="12 m"/><tag k="circumference" v="1.5707963"/><tag k="diameter_crown" v="20 ft"/></node>
<node id="12" version="1" lat="0.0" lon="9.001"><tag k="natural" v="tree"/><tag k="genus" v="Fagus"/>
<tag k="species" v="Mystery nova"/></node>
<node id="13" version="1" lat="0.0" lon="9.002"><tag k="natural" v="peak"/></node>
<node id="14" version="1" lat="0.0" lon="9.003"/></osm>)");
    folder.write(
        "a.geojson",
        geoJson(point("9.0, 0.0", R"("@id": "node/11", "natural": "tree", "species": "Quercus robur",
"height": "12 m", "circumference": "1.5707963", "diameter_crown": "20 ft")") +
                "," +
                point("9.001, 0.0",
                      R"("@id": "node/12", "natural": "tree", "species": "Mystery nova", "genus": "Fagus")") +
                "," + point("9.002, 0.0", R"("@id": "node/13", "natural": "peak")")));
    for (const std::string name : {"a.osm", "a.geojson"}) {
        SCOPED_TRACE(name);
        const ForestFile forest = inventoryOf(folder.path(), "file = \"" + name + "\"\n");
        ASSERT_EQ(forest.trees.size(), 2u);
        const TreePlacement& oak = forest.trees[0];
        expectAt(oak, 500000.0, 0.0);
        EXPECT_EQ(oak.name, name == "a.osm" ? "11" : "node/11");
        EXPECT_EQ(forest.species[oak.species].name, "oak");
        EXPECT_EQ(oak.size.height, 12.0f);
        EXPECT_NEAR(oak.size.trunkDiameter, 0.5f, 1e-6f);
        EXPECT_NEAR(oak.size.crownWidth, 6.096f, 1e-5f);
        EXPECT_EQ(forest.species[forest.trees[1].species].name, "beech");
        ASSERT_EQ(forest.notes.size(), 1u);
        EXPECT_TRUE(hasPart(forest.notes[0], "height of 1 trees"));
    }
}

TEST(InventoryFeatures, OpenStreetMapNamesSpeciesInSeveralWays) {
    const TemporaryFolder folder;
    const std::vector<std::pair<std::string, std::string>> tagsAndSpecies = {
        {R"("leaf_type": "needleleaved")", "conifer"},
        {R"("leaf_type": "broadleaved")", "broadleaf"},
        {R"("leaf_type": "mixed")", "broadleaf"},
        {R"("species": "Mystery nova", "leaf_type": "needleleaved")", "conifer"},
        {R"("species": "river birch", "leaf_type": "needleleaved")", "silver birch"},
        {R"("genus": "Picea", "leaf_type": "broadleaved")", "Norway spruce"},
        {R"("species": "Quercus robur;Fagus sylvatica")", "oak"},
        {R"("species": "Mystery nova; Fagus sylvatica")", "beech"},
        {R"("species": "Mystery nova;Mystery vetus", "genus": "Tilia")", "linden"}};
    std::string features;
    for (const auto& [tags, species] : tagsAndSpecies)
        features += (features.empty() ? "" : ",") +
                    point("9.0, 0.0", R"("@id": "node/1", "natural": "tree", )" + tags);
    folder.write("a.geojson", geoJson(features));
    const auto read = [&](const std::string& lines) {
        std::istringstream input("version = 1\n[inventory]\nfile = \"a.geojson\"\n" + lines);
        return readForest(input, {"test.treewind", folder.path()}).value();
    };
    const ForestFile forest = read("");
    ASSERT_EQ(forest.trees.size(), tagsAndSpecies.size());
    for (std::size_t i = 0; i < forest.trees.size(); ++i)
        EXPECT_EQ(forest.species[forest.trees[i].species].name, tagsAndSpecies[i].second)
            << tagsAndSpecies[i].first;
    const std::string notes = notesOf(forest);
    EXPECT_TRUE(hasPart(notes, "4 trees of unknown species are read as related species"));
    EXPECT_TRUE(hasPart(notes, "Mystery nova as conifer (1)"));
    EXPECT_TRUE(hasPart(notes, "no name as conifer (1)"));
    EXPECT_TRUE(hasPart(notes, "of several species in a cell, the first that is known counts: 2 trees"));
    const ForestFile other = read("default_species = \"beech\"\n");
    EXPECT_EQ(other.species[other.trees[0].species].name, "conifer") << "which says more than the default";
}

TEST(InventoryFeatures, OpenStreetMapHasSizesInWords) {
    const TemporaryFolder folder;
    struct Tag {
        std::string text;
        float metres;
        bool isEstimate;
    };
    // 1 ft = .3048 m and 1 in = .0254 m by definition
    const std::vector<Tag> heights = {{"60'", 18.288f, false},   {R"(45'6\")", 13.8684f, false},
                                      {"12,5", 12.5f, false},    {"~20", 20.0f, true},
                                      {"10-15", 12.5f, true},    {"15 m", 15.0f, false},
                                      {"40 ft", 12.192f, false}, {">18", 18.0f, true}};
    std::string features;
    for (const Tag& height : heights)
        features += (features.empty() ? "" : ",") +
                    point("9.0, 0.0", R"("@id": "node/1", "natural": "tree", "genus": "Tilia", "height": ")" +
                                          height.text + R"(", "circumference": "1.2;0.9")");
    folder.write("a.geojson", geoJson(features));
    const ForestFile forest = inventoryOf(folder.path(), "file = \"a.geojson\"\n");
    ASSERT_EQ(forest.trees.size(), heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
        SCOPED_TRACE(heights[i].text);
        EXPECT_NEAR(forest.trees[i].size.height, heights[i].metres, 1e-4f);
        EXPECT_EQ(forest.trees[i].estimated.height, heights[i].isEstimate);
        EXPECT_NEAR(forest.trees[i].size.trunkDiameter, 1.5f / glm::pi<float>(), 1e-6f) << "of two stems";
    }
}

TEST(InventoryFeatures, CityJsonNeedsNoColumns) {
    const TemporaryFolder folder;
    folder.write("city.json", R"({"type": "CityJSON", "version": "1.1",
"transform": {"scale": [0.001, 0.001, 0.001], "translate": [100000, 400000, 2]},
"metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"},
"vertices": [[0,0,0],[4000,0,0],[4000,2000,9000],[50000,60000,1000]],
"CityObjects": {
"house": {"type": "Building", "attributes": {"height": 9}},
"t1": {"type": "SolitaryVegetationObject", "attributes": {"species": "Quercus robur", "height": 9.5, "trunkDiameter": 0.5,
"crownDiameter": 4, "felled": false}, "geometry": [{"type": "MultiSurface", "lod": 2, "boundaries": [[[0,1,2]]]}]},
"t2": {"type": "SolitaryVegetationObject", "attributes": {"species": "Fagus sylvatica"}, "geometry":
[{"type": "GeometryInstance", "template": 0, "boundaries": [3], "transformationMatrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}]}
}})");
    const ForestFile forest = inventoryOf(folder.path(), "file = \"city.json\"\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_EQ(forest.crs, "EPSG:28992") << "the horizontal part of a compound CRS";
    expectAt(forest.trees[0], 100002.0, 400001.0);
    EXPECT_NEAR(forest.trees[0].position.z, 2.0, 1e-9);
    EXPECT_EQ(forest.trees[0].name, "t1");
    EXPECT_EQ(forest.species[forest.trees[0].species].name, "oak");
    EXPECT_EQ(forest.trees[0].size.height, 9.5f);
    EXPECT_EQ(forest.trees[0].size.trunkDiameter, 0.5f);
    EXPECT_EQ(forest.trees[0].size.crownWidth, 4.0f);
    expectAt(forest.trees[1], 100050.0, 400060.0);
    EXPECT_EQ(inventoryOf(folder.path(), "file = \"city.json\"\nfilter = \"height > 3\"\n").trees.size(), 1u);
}

TEST(InventoryFeatures, ThousandsOfUnknownNamesGiveOneNote) {
    const TemporaryFolder folder;
    std::string rows = "x,y,s\n1,2,\n3,4,\n";
    for (int i = 0; i < 3000; ++i)
        rows += "1,2,weed " + std::to_string(i) + "\n3,4,bush\n";
    folder.write("a.csv", rows);
    const ForestFile forest =
        inventoryOf(folder.path(), "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", species = \"s\" }\n");
    ASSERT_EQ(forest.notes.size(), 2u) << "the other is about sizes";
    EXPECT_TRUE(hasPart(forest.notes[0], "read as \"beech\": bush (3000), no name (2), weed 0 (1), "));
    EXPECT_TRUE(hasPart(forest.notes[0], "and 2702 more names"));
    EXPECT_LT(forest.notes[0].size(), 6000u);
}

} // namespace osgTreeWind

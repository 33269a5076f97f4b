// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>
#include <tests/places/GeoJson.h>

#include <osgTreeWind/base/CsvCell.h>

namespace osgTreeWind {

namespace {

/// Reads trees of a column `place`.
Result<ForestFile> readPlaces(const std::vector<std::string>& cells, const std::string& lines = "",
                              const std::string& head = "") {
    const TemporaryFolder folder;
    std::string table = "nr,place\n";
    for (const std::string& cell : cells)
        table += "1," + csvCell(cell) + '\n';
    folder.write("a.csv", table);
    return readInventoryOf(folder.path(), "file = \"a.csv\"\ncolumns = { point = \"place\" }\n" + lines,
                           head);
}

/// Expects trees at 9 E on the equator, and 0.0001 degrees north of it (pyproj: EPSG:4326 to EPSG:32632).
ForestFile expectTwoTrees(const std::vector<std::string>& cells, const std::string& lines = "") {
    SCOPED_TRACE(cells[0]);
    const auto forest = readPlaces(cells, lines);
    EXPECT_TRUE(forest) << forest.problems().front().text();
    if (!forest || forest.value().trees.size() != 2)
        return {};
    EXPECT_EQ(forest.value().crs, "EPSG:32632");
    expectAt(forest.value().trees[0], 500000.0, 0.0, 0.01);
    expectAt(forest.value().trees[1], 500000.0, 11.053, 0.01);
    return forest.value();
}

/// A square of 0.0001 degrees.
std::string square(const std::string& open, const std::string& close, const std::string& comma, double x,
                   double y) {
    std::string text;
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
        text += (text.empty() ? "" : ", ") + open + std::to_string(x + 5e-5 * corner.x) + comma +
                std::to_string(y + 5e-5 * corner.y) + close;
    return text;
}

void expectProblem(const Result<ForestFile>& forest, const std::string& part) {
    ASSERT_FALSE(forest) << part;
    EXPECT_TRUE(hasPart(forest.problems().front().text(), part)) << forest.problems().front().text();
}

} // namespace

TEST(PointColumn, ReadsGeometriesInAnyForm) {
    expectTwoTrees({"POINT (9 0)", "POINT (9 0.0001)"});
    expectTwoTrees({"MULTIPOINT ((9 0))", "POINT ZM (9 0.0001 5 6)"});
    expectTwoTrees({"SRID=4326;POINT(9 0)", "SRID=4326;POINT(9 0.0001)"});
    // by PostGIS' rules: byte order, type with the flag of an SRID, SRID, x, y
    expectTwoTrees({"0101000020E610000000000000000022400000000000000000",
                    "0101000020E610000000000000000022402D431CEBE2361A3F"});
    expectTwoTrees({"0020000001000010E640220000000000000000000000000000",
                    "\\x0020000001000010e640220000000000003f1a36e2eb1c432d"});
    expectTwoTrees(
        {"010100000000000000000022400000000000000000", "010100000000000000000022402D431CEBE2361A3F"});
    expectTwoTrees({R"({"type": "Point", "coordinates": [9, 0]})",
                    R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [9, 0.0001]}})"});
    expectTwoTrees({"0°0'0\"N 9°0'0\"E", "N0 0.006 E9"});
}

TEST(PointColumn, OutlinesGiveTheCircleOfTheSameArea) {
    // 11.132 by 11.057 m by pyproj.Geod(ellps="WGS84")
    const float width = static_cast<float>(2.0 * std::sqrt(11.132 * 11.057 / 3.14159265));
    for (const bool isJson : {false, true}) {
        std::vector<std::string> cells;
        for (const double y : {0.0, 1e-4})
            cells.push_back(isJson ? R"({"type": "Polygon", "coordinates": [[)" +
                                         square("[", "]", ", ", 9, y) + "]]}"
                                   : "MULTIPOLYGON (((" + square("", "", " ", 9, y) + ")))");
        for (const TreePlacement& tree : expectTwoTrees(cells).trees) {
            EXPECT_NEAR(tree.size.crownWidth, width, 0.02f);
            EXPECT_FALSE(tree.estimated.crownWidth);
        }
    }
    const auto forest =
        readPlaces({"SRID=25832;POLYGON ((565000 5934000,565008 5934000,565008 5934006,565000 5934006,565000 "
                    "5934000))"});
    ASSERT_TRUE(forest) << forest.problems().front().text();
    EXPECT_EQ(forest.value().crs, "EPSG:25832");
    expectAt(forest.value().trees[0], 565004.0, 5934003.0);
    EXPECT_NEAR(forest.value().trees[0].size.crownWidth, 2.0 * std::sqrt(48.0 / 3.14159265), 1e-5);
}

TEST(PointColumn, TheKeyCrsOverridesAnSridWithANote) {
    const auto forest = readPlaces({"SRID=4326;POINT(565000 5934000)"}, "crs = \"EPSG:25832\"\n");
    ASSERT_TRUE(forest) << forest.problems().front().text();
    expectAt(forest.value().trees[0], 565000.0, 5934000.0);
    EXPECT_TRUE(hasPart(notesOf(forest.value()), "crs overrides WGS 84, which the cells of \"place\" state"));
    const auto same = readPlaces({"SRID=25832;POINT(565000 5934000)"}, "crs = \"EPSG:25832\"\n");
    EXPECT_FALSE(hasPart(notesOf(same.value()), "overrides"));
    expectProblem(readPlaces({"SRID=4326;POINT(9 50)", "SRID=4258;POINT(9 50)"}),
                  "expected one SRID, found 4258 and 4326");
    expectProblem(readPlaces({"SRID=1;POINT(9 50)"}), "the SRID 1 is not known");
}

TEST(PointColumn, PairsHaveTheOrderThatIsKnownOrStated) {
    expectTwoTrees({"9, 0", "9, 0.0001"}, "axis_order = \"xy\"\n");
    expectTwoTrees({"0, 9", "0.0001, 9"}, "axis_order = \"yx\"\n");
    EXPECT_TRUE(
        hasPart(notesOf(expectTwoTrees({"(0, 9)", "(0.0001, 9)"})),
                "places in \"place\" such as \"(0, 9)\" are read as latitude, longitude (for the other "
                "order, set axis_order = \"xy\")"));
    expectProblem(readPlaces({"0, 9"}),
                  "inventory.axis_order: missing: \"0, 9\" in \"place\" may have either order");
    const auto far = readPlaces({"139.7, 35.6", "139.7001, 35.6"});
    ASSERT_TRUE(far) << far.problems().front().text();
    EXPECT_EQ(far.value().crs, "EPSG:32654");
    expectTwoTrees({"POINT (0 9)", "POINT (0.0001 9)"}, "axis_order = \"yx\"\n");
    expectProblem(readPlaces({"POINT (35.6 139.7)"}),
                  "its places are no longitudes and latitudes; if their latitude stands first, set "
                  "inventory.axis_order = \"yx\"");
}

TEST(PointColumn, NamesTheFormsThatItReads) {
    expectProblem(readPlaces({"LINESTRING (9 0,9 1)"}),
                  "a.csv:2: place: expected a point or the outline of a crown, found LINESTRING");
    expectProblem(readPlaces({"POINT (9"}),
                  "a.csv:2: place: expected a geometry as WKT, EWKT, EWKB or GeoJSON");
    expectProblem(readPlaces({"0101000020E61000000000000000002240000000"}),
                  "a.csv:2: place: expected a place such");
    expectProblem(readPlaces({R"({"type": )"}), "a.csv:2: place: expected a geometry");
    expectProblem(readPlaces({"nowhere"}), "a.csv:2: place: expected a place such as POINT (2.30 48.88)");
}

TEST(PointColumn, ReadsDegreesInTwoColumns) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n\"9°0'0\"\" E\",\"0° 0' 0.36\"\" N\"\n9.0,0 0 0.36\n");
    const ForestFile forest = inventoryOf(folder.path(), "file = \"a.csv\"\n" + xy);
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_EQ(forest.crs, "EPSG:32632");
    for (const TreePlacement& tree : forest.trees)
        expectAt(tree, 500000.0, 11.053, 0.01);
    const auto other = readInventoryOf(folder.path(), "file = \"a.csv\"\ncrs = \"EPSG:25832\"\n" + xy);
    expectProblem(other, "a.csv:2: x: expected a number in the unit of the crs, which is not in degrees");
    expectProblem(readInventoryOf(folder.path(), "file = \"a.csv\"\naxis_order = \"xy\"\n" + xy),
                  "inventory.axis_order: applies to places in one column and to geometries");
}

TEST(PointColumn, GeometriesOfMapFilesHaveAnOrder) {
    const TemporaryFolder folder;
    folder.write("a.geojson", geoJson(point("0, 9") + "," + point("0.0001, 9")));
    const ForestFile forest = inventoryOf(folder.path(), "file = \"a.geojson\"\naxis_order = \"yx\"\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    expectAt(forest.trees[1], 500000.0, 11.053, 0.01);
    folder.write("a.geojson", geoJson(point("35.6, 139.7")));
    for (const char* head : {"", "crs = \"EPSG:6677\""})
        expectProblem(readInventoryOf(folder.path(), "file = \"a.geojson\"\n", head),
                      "if their latitude stands first, set inventory.axis_order = \"yx\"");
}

/// The tree is at (500000, 11.05) in the zone, and with its coordinates exchanged 1,400 km away.
TEST(PointColumn, AWindElsewhereTellsThatTheLatitudeStandsFirst) {
    const TemporaryFolder folder;
    folder.write("a.geojson", geoJson(point("0.0001, 9")));
    for (const std::string kind : {"vel", "ang"})
        folder.write(
            "w_" + kind + ".asc",
            "ncols 3\nnrows 3\nxllcorner 499850\nyllcorner -150\ncellsize 100\n5 5 5\n5 5 5\n5 5 5\n");
    const std::string lines = "file = \"a.geojson\"\n",
                      wind = "[wind]\nfile = \"w_vel.asc\"\nheight = 10\nroughness = 0.5\n",
                      head = "crs = \"EPSG:32632\"\nstretched = true";
    expectProblem(
        readInventoryOf(folder.path(), lines + wind, head),
        "to use that of the edge; if their latitude stands first, set inventory.axis_order = \"yx\"");
    const auto forest = readInventoryOf(folder.path(), lines + "axis_order = \"yx\"\n" + wind, head);
    EXPECT_TRUE(forest) << forest.problems().front().text();
}

} // namespace osgTreeWind

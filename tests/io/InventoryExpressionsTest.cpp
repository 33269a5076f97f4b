// SPDX-License-Identifier: MIT
#include <tests/base/IsProblem.h>
#include <tests/io/InventoryReading.h>

#include <cmath>

namespace osgTreeWind {

TEST(InventoryExpressions, JoinGenusAndEpithet) {
    const TemporaryFolder folder;
    folder.write("a.csv",
                 "Nr;Gattung;Art;lon;lat\n007;Tilia;cordata;14,2;48,3\n8;Acer;platanoides;14,2001;48,3\n"
                 "9;Pinus;nigra;14,2002;48,3\n10;Quercus;;14,2003;48,3\n");
    const ForestFile forest =
        inventoryOf(folder.path(), "file = \"a.csv\"\ncolumns = { id = \"'tree ' || Nr\", species = "
                                   "\"Gattung || coalesce(' ' || Art, '')\", x = \"lon\", y = \"lat\" }\n");
    std::string found;
    for (const TreePlacement& tree : forest.trees)
        found += tree.name + ": " + forest.species[tree.species].name + '\n';
    EXPECT_EQ(found, "tree 007: linden\ntree 8: Norway maple\ntree 9: Corsican pine\ntree 10: oak\n");
}

TEST(InventoryExpressions, ComputeSizesInTheUnitOfTheKey) {
    const TemporaryFolder folder;
    folder.write("a.csv", "X,Y,Radius,class,crown\n1,2,15,A,2.5\n5,6,,B,3.5\n");
    const ForestFile forest = inventoryOf(
        folder.path(), "file = \"a.csv\"\ncolumns = { x = \"X\", y = \"Y\", trunk_diameter = \"2 * Radius\", "
                       "height = \"CASE class WHEN 'A' THEN 5 ELSE 12 END\", crown_width = \"crown * 2\" }\n"
                       "units = { trunk_diameter = \"cm\" }\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_FLOAT_EQ(forest.trees[0].size.trunkDiameter, 0.3f);
    EXPECT_TRUE(forest.trees[1].estimated.trunkDiameter);
    EXPECT_EQ(forest.trees[0].size.height, 5.0f);
    EXPECT_EQ(forest.trees[1].size.height, 12.0f);
    EXPECT_EQ(forest.trees[1].size.crownWidth, 7.0f);
}

TEST(InventoryExpressions, ComputePolarPlaces) {
    const TemporaryFolder folder;
    folder.write("a.csv", "DIST,AZIMUTH\n100,90\n10,180\n20,330\n");
    const ForestFile forest = inventoryOf(
        folder.path(), "file = \"a.csv\"\ncolumns = { x = \"0.3048 * DIST * sin(radians(AZIMUTH))\", y "
                       "= \"0.3048 * DIST * cos(radians(AZIMUTH))\" }\nfilter = \"DIST <> 10\"\n");
    ASSERT_EQ(forest.trees.size(), 2u);
    expectAt(forest.trees[0], 30.48, 0.0, 1e-9);
    expectAt(forest.trees[1], -0.5 * 6.096, std::sqrt(0.75) * 6.096, 1e-9);
}

TEST(InventoryExpressions, ReadFeatures) {
    const TemporaryFolder folder;
    folder.write("a.geojson",
                 R"({"type": "FeatureCollection", "features": [)"
                 R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [14.2, 48.3]},)"
                 R"( "properties": {"genus": "Tilia", "epithet": "cordata", "r": 0.2, "unused": 1}}]})");
    const ForestFile forest = inventoryOf(
        folder.path(), "file = \"a.geojson\"\nfilter = \"r > 0\"\ncolumns = { species = \"genus || ' ' || "
                       "epithet\", trunk_diameter = \"2*r\" }\n");
    ASSERT_EQ(forest.trees.size(), 1u);
    EXPECT_EQ(forest.species[forest.trees[0].species].name, "linden");
    EXPECT_FLOAT_EQ(forest.trees[0].size.trunkDiameter, 0.4f);
}

TEST(InventoryExpressions, NameTheColumnThatIsMisspelled) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,Radius\n1,2,.15\n");
    const auto problem = [&](const std::string& diameter) {
        return toString(readInventoryOf(folder.path(), "file = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", "
                                                       "trunk_diameter = \"" +
                                                           diameter + "\" }\n")
                            .problems());
    };
    EXPECT_TRUE(hasPart(problem("2 * Radus"), "inventory.columns.trunk_diameter: at character 5: no column "
                                              "\"Radus\" in "));
    EXPECT_TRUE(hasPart(problem("2 * Radus"), "did you mean \"Radius\"?"));
    EXPECT_TRUE(hasPart(problem("Radus"), "trunk_diameter: no column \"Radus\" in "));
    EXPECT_TRUE(hasPart(problem("x; ATTACH 'a' AS b"), "at character 2: "));
    EXPECT_TRUE(hasPart(problem("abs(-9223372036854775807 - x)"), "a.csv:2: "))
        << problem("abs(-9223372036854775807 - x)");
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/Folders.h>
#include <tests/Near.h>
#include <tests/TestData.h>
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/io/ForestFile.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>

namespace osgTreeWind {

namespace {

const std::string examples = OSGTREEWIND_SOURCE_DIR "/examples/";

/// The forest; problems are test failures.
ForestFile expectForest(const Result<ForestFile>& result) {
    if (result.ok())
        return result.value();
    for (const Diagnostic& problem : result.problems())
        ADD_FAILURE() << problem.text();
    return {};
}

ForestFile forestOf(const std::string& text, const std::string& folder = "") {
    std::istringstream input("version = 1\n" + text);
    return expectForest(readForest(input, {"test.treewind", folder}));
}

glm::vec3 windOf(const std::string& lines, const glm::vec3& position = glm::vec3(0.0f), double time = 0.0,
                 const std::string& folder = "") {
    const ForestFile forest = forestOf("[[tree]]\nposition = [0, 0]\n[wind]\n" + lines, folder);
    return forest.wind.field ? asField(forest.wind)->velocity(position, time) : glm::vec3(NAN);
}

const std::string treeAtOrigin = "[[tree]]\nposition = [0, 0]\n";

} // namespace

TEST(ForestFile, ThesisExampleIsOneReferenceTree) {
    const ForestFile forest = expectForest(readForestFile(examples + "thesis.treewind"));
    ASSERT_EQ(forest.trees.size(), 1u);
    ASSERT_EQ(forest.species.size(), 1u);
    EXPECT_EQ(forest.law, MotionLaw::Thesis);
    const TreeCounts counts = countTree(forest.species[0].tree);
    EXPECT_EQ(counts.units, 122u);
    EXPECT_EQ(counts.totalVertices(), 38656u);
    EXPECT_EQ(counts.totalTriangles(), 40800u);
    expectNear(asField(forest.wind)->velocity({}, 0.0), {4, 0, 0});
}

TEST(ForestFile, SeasonIsAWordANumberOrADate) {
    EXPECT_EQ(forestOf(treeAtOrigin).season, midsummer);
    EXPECT_EQ(forestOf("season = \"autumn\"\n" + treeAtOrigin).season, midautumn);
    EXPECT_EQ(forestOf("season = 1\n" + treeAtOrigin).season, midspring);
    EXPECT_EQ(forestOf("season = 0.5\n" + treeAtOrigin).season, 0.5f);
    EXPECT_NEAR(forestOf("season = 2024-08-06\n" + treeAtOrigin).season, midsummer, 0.02);
    EXPECT_EQ(forestOf("season = 2024-11-05\n" + treeAtOrigin).season,
              forestOf("season = \"2024-11-05\"\n" + treeAtOrigin).season);
    const ForestFile larch =
        forestOf("[[species]]\nname = \"larch\"\nappearance = { leaf_form = \"needles\", evergreen = false, "
                 "autumn_leaves = [0.5, 0.3, 0] }\n" +
                 treeAtOrigin);
    EXPECT_FALSE(larch.species[0].appearance.isEvergreen());
    EXPECT_EQ(larch.species[0].appearance.autumnLeaves, glm::vec3(0.5f, 0.3f, 0.0f));
}

TEST(ForestFile, OldBarkHasTheColourOfBarkByDefault) {
    const auto appearance = [](const std::string& keys) {
        return forestOf("[[species]]\nname = \"it\"\nappearance = { bark = [0.5, 0.4, 0.3]" + keys + " }\n" +
                        treeAtOrigin)
            .species[0]
            .appearance;
    };
    EXPECT_EQ(appearance("").oldBarkColor(), glm::vec3(0.5f, 0.4f, 0.3f));
    EXPECT_EQ(appearance(", old_bark = [0.1, 0, 0.1]").oldBarkColor(), glm::vec3(0.1f, 0.0f, 0.1f));
    EXPECT_LT(appearance(", bark_form = \"banded\"").oldBarkColor().r, 0.1f);
}

TEST(ForestFile, ForestExampleKeepsItsSpacing) {
    const ForestFile forest = expectForest(readForestFile(examples + "forest.treewind"));
    ASSERT_EQ(forest.trees.size(), 40u);
    ASSERT_EQ(forest.species.size(), 3u);
    std::size_t oaks = 0;
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        const TreePlacement& a = forest.trees[i];
        oaks += a.species == 0;
        EXPECT_LE(std::abs(a.position.x), 40.0);
        EXPECT_LE(std::abs(a.position.y), 40.0);
        EXPECT_GE(a.size.height, 8.0f);
        EXPECT_LE(a.size.height, 16.0f);
        EXPECT_GE(a.size.trunkDiameter, 0.0249f * a.size.height);
        EXPECT_LE(a.size.trunkDiameter, 0.0351f * a.size.height);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(glm::distance(a.position, forest.trees[j].position), 7.0);
    }
    EXPECT_GT(oaks, 10u); // about three of six
    EXPECT_LT(oaks, 30u);
    EXPECT_NE(asField(forest.wind)->velocity({0, 0, 10}, 3.0),
              asField(forest.wind)->velocity({0, 0, 10}, 9.0));
}

TEST(ForestFile, ScatterIsReproducible) {
    const ForestFile forest = forestOf("[scatter]\ncount = 2\narea = [0, 0, 1, 1]\nseed = 0\n");
    // First two numbers of SplitMix64 from seed 0 (Vigna's reference: e220a8397b1dcdaf, 6e789e6aa1b965f4).
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_DOUBLE_EQ(forest.trees[0].position.x, static_cast<double>(0xe220a8397b1dcdafull >> 11) * 0x1p-53);
    EXPECT_DOUBLE_EQ(forest.trees[0].position.y, static_cast<double>(0x6e789e6aa1b965f4ull >> 11) * 0x1p-53);
}

TEST(ForestFile, CampusExampleHasMeasuredSizes) {
    REQUIRE_REAL_DATA(csv, "utah_campus/utah_campus_trees.csv");
    const ForestFile forest = expectForest(readForestFile(examples + "campus.treewind"));
    ASSERT_EQ(forest.trees.size(), 1233u);

    std::ifstream file(csv);
    std::string line;
    std::getline(file, line);
    for (const TreePlacement& placed : forest.trees) {
        ASSERT_TRUE(std::getline(file, line));
        double x, y, diameter, crown, height;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &x, &y, &diameter, &crown, &height), 5);
        EXPECT_DOUBLE_EQ(placed.position.x, x);
        EXPECT_DOUBLE_EQ(placed.position.y, y);
        EXPECT_FLOAT_EQ(placed.size.height, static_cast<float>(height));
        EXPECT_FLOAT_EQ(placed.size.trunkDiameter, static_cast<float>(diameter));
        EXPECT_FLOAT_EQ(placed.size.crownWidth, static_cast<float>(crown));
        const std::string& name = forest.species[placed.species].name;
        EXPECT_EQ(name == "Corsican pine", line.find("Pinus nigra") != std::string::npos ||
                                               line.find("Pinus ponderosa") != std::string::npos);
        EXPECT_LT(glm::distance(placed.position, forest.origin), 2000.0);
    }
    ASSERT_EQ(forest.notes.size(), 2u); // otherwise a species is not built in
    EXPECT_TRUE(hasPart(forest.notes[0], "no crs is known, and places are taken as metres"))
        << forest.notes[0];
    EXPECT_TRUE(hasPart(forest.notes[1], "wind.canopy = \"none\"")) << forest.notes[1];
}

TEST(ForestFile, CampusWindIsTheRecord) {
    REQUIRE_REAL_DATA(xml, "utah_campus/sensor2015.xml");
    const ForestFile forest = expectForest(readForestFile(examples + "campus.treewind"));
    ASSERT_TRUE(forest.wind.field);
    // First record: 3.1 m/s from 78.4 degrees at 42 m.
    expectNear(asField(forest.wind)->velocity({0, 0, 42}, 0.0), {-3.0367f, -0.6233f, 0.0f}, 1e-3f);
}

TEST(ForestFile, ReadsPlotInventoryWithUnits) {
    REQUIRE_REAL_DATA(csv, "scbi/scbi_joined_xy_height_dbh.csv");
    const ForestFile forest =
        forestOf("[inventory]\nfile = \"" + csv +
                 "\"\ncolumns = { x = \"px\", y = \"py\", height = \"height.m\", "
                 "trunk_diameter = \"dbh_cm\" }\nunits = { trunk_diameter = \"cm\" }\n");
    ASSERT_EQ(forest.trees.size(), 661u);
    EXPECT_FLOAT_EQ(forest.trees[0].size.height, 26.0f);
    EXPECT_NEAR(forest.trees[0].size.trunkDiameter, 0.4173f, 1e-6f);
    EXPECT_EQ(forest.origin, glm::dvec3(0.0)); // plot coordinates need no other origin
}

TEST(ForestFile, InventoryTreesKeepTheirIds) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,tag\n1,2,T 7\n3,4,\n5,6,0012\n7,8,T 7\n");
    folder.write("b.csv", "x,y,tag\n1,2,T 8\n3,4,0012\n");
    const std::string columns = "columns = { id = \"tag\", x = \"x\", y = \"y\" }\n";
    const ForestFile forest = forestOf("[[inventory]]\nfile = \"a.csv\"\n" + columns +
                                           "[[inventory]]\nfile = \"b.csv\"\n" + columns,
                                       folder.path());
    std::vector<std::string> names;
    for (const TreePlacement& tree : forest.trees)
        names.push_back(tree.name);
    EXPECT_EQ(names, std::vector<std::string>({"T 7", "", "0012", "", "T 8", ""}));
    std::vector<std::string> repeated;
    for (const std::string& note : forest.notes)
        if (note.find("1 trees have no id, because another tree has it: ") != std::string::npos)
            repeated.push_back(note);
    ASSERT_EQ(repeated.size(), 2u);
    EXPECT_TRUE(hasPart(repeated[0], "a.csv: "));
    EXPECT_TRUE(hasPart(repeated[0], "T 7"));
    EXPECT_TRUE(hasPart(repeated[1], "0012"));
}

TEST(ForestFile, PlotTreesKeepTheirTags) {
    REQUIRE_REAL_DATA(csv, "scbi/scbi_joined_xy_height_dbh.csv");
    const ForestFile forest =
        forestOf("[inventory]\nfile = \"" + csv + "\"\ncolumns = { id = \"tag\", x = \"px\", y = \"py\" }\n");
    EXPECT_EQ(forest.trees[0].name, "90684");
    EXPECT_EQ(forest.trees[1].name, "111182");
}

TEST(ForestFile, EmptyCellsMeanNotGiven) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h\n1,2,\n3,4,30\n");
    const ForestFile forest =
        forestOf("[inventory]\nfile = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\", height = \"h\" }\n"
                 "units = { height = \"ft\" }\n",
                 folder.path());
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_TRUE(forest.trees[0].estimated.height);
    EXPECT_FALSE(forest.trees[1].estimated.height);
    EXPECT_NEAR(forest.trees[1].size.height, 9.144f, 1e-5f);
}

TEST(ForestFile, LargeCoordinatesGetAnOriginNearTheTrees) {
    const ForestFile forest = forestOf("[[tree]]\nposition = [428759.19, 4512931.77, 1423.6]\n"
                                       "[[tree]]\nposition = [428760.19, 4512933.77, 1424.6]\n");
    EXPECT_EQ(forest.origin, glm::dvec3(428760, 4512933, 1423));
}

TEST(ForestFile, GivenOriginIsKept) {
    EXPECT_EQ(forestOf("origin = [10, 20, 30]\n" + treeAtOrigin).origin, glm::dvec3(10, 20, 30));
}

TEST(ForestFile, AnglesAreDegrees) {
    const ForestFile forest = forestOf("[[tree]]\nposition = [0, 0]\nheading = 90\n[[species]]\n"
                                       "name = \"a\"\n[species.tree]\ninclination = 30\n");
    EXPECT_FLOAT_EQ(forest.trees[0].heading, 1.5707964f);
    EXPECT_FLOAT_EQ(forest.species[0].tree.wood.inclination, 0.5235988f);
}

TEST(ForestFile, SpeciesMayHaveAllFieldsOfBuiltInOnes) {
    const ForestFile forest =
        forestOf(treeAtOrigin + "[[species]]\nname = \"elm\"\nsource = \"by hand\"\naliases = [\"Ulmus\"]\n"
                                "[species.habit]\nheight = 26\ntrunk_diameter = "
                                "0.57\n[species.leaves]\nthin_wood = 0.5\narea = 4000\n"
                                "length = 0.4\n[species.crown]\nbase = 1\nper_diameter = 15\nopen_base = 2\n"
                                "open_per_diameter = 20\n[species.wood]\nbranch_wood = \"broadleaf\"\n");
    const Species& elm = forest.species.front();
    EXPECT_EQ(elm.source, "by hand");
    EXPECT_EQ(elm.aliases, std::vector<std::string>{"Ulmus"});
    EXPECT_EQ(elm.tree.growth->size.height, 26.0f);
    EXPECT_EQ(elm.tree.growth->size.trunkDiameter, 0.57f);
    EXPECT_EQ(elm.tree.leaves.thinWood, 0.5f);
    EXPECT_EQ(elm.tree.leaves.area, 4000.0f);
    EXPECT_EQ(elm.crown.base, 1.0f);
    EXPECT_EQ(elm.crown.perDiameter, 15.0f);
    EXPECT_EQ(elm.crown.openBase, 2.0f);
    EXPECT_EQ(elm.crown.openPerDiameter, 20.0f);
    EXPECT_EQ(elm.wood.branchWood, WoodAllometry::Broadleaf);
}

TEST(ForestFile, DrawingKeepsDefaultsOfMissingKeys) {
    const DrawingOptions drawing = forestOf("[[tree]]\nposition = [0, 0]\n[drawing]\ntiers = false\nfull = "
                                            "500\nimpostor = 0\nblend = 0.5\nexposure = 2.5\n")
                                       .drawing;
    EXPECT_FALSE(drawing.tiers);
    EXPECT_EQ(drawing.full, 500.0f);
    EXPECT_EQ(drawing.reduced, DrawingOptions().reduced);
    EXPECT_EQ(drawing.impostor, 0.0f);
    EXPECT_EQ(drawing.blend, 0.5f);
    EXPECT_EQ(drawing.exposure, 2.5f);
}

TEST(ForestFile, FindsPicturesOfASpecies) {
    const TemporaryFolder folder;
    const std::string spray = folder.write("spray.png", "found by name only");
    const ForestFile forest = forestOf(
        "[[species]]\nname = \"oak\"\nappearance.leaf_image = \"spray.png\"\n[[tree]]\nposition = [0, 0]\n",
        folder.path());
    ASSERT_EQ(forest.species.size(), 1u);
    EXPECT_EQ(forest.species[0].appearance.leafImage, spray);
    EXPECT_EQ(forest.species[0].appearance.barkImage, "");
}

TEST(ForestFile, FindsFilesBesideTheDocumentThenInSearch) {
    const TemporaryFolder folder, other;
    other.write("a.csv", "x,y\n1,2\n");
    const std::string text = "[inventory]\nfile = \"a.csv\"\ncolumns = { x = \"x\", y = \"y\" }\n";
    const std::string search = "search = [\"" + other.path() + "\"]\n";
    EXPECT_EQ(forestOf(search + text, folder.path()).trees.size(), 1u);
    folder.write("a.csv", "x,y\n1,2\n3,4\n");
    EXPECT_EQ(forestOf(search + text, folder.path()).trees.size(), 2u);
}

TEST(ForestFile, SourceAndFolderReadBackAsTheSameForest) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y\n1,2\n3,4\n");
    const std::string path = folder.write("f.treewind", "version = 1\n[inventory]\nfile = \"a.csv\"\n"
                                                        "columns = { x = \"x\", y = \"y\" }\n");
    const ForestFile first = expectForest(readForestFile(path));
    std::istringstream again(first.source);
    const ForestFile second = expectForest(readForest(again, {"", first.folder}));
    ASSERT_EQ(second.trees.size(), 2u);
    EXPECT_EQ(second.trees[1].seed, first.trees[1].seed);
    EXPECT_EQ(second.source, first.source);
}

TEST(ForestFile, CalmHasNoField) {
    EXPECT_TRUE(forestOf(treeAtOrigin).wind.isCalm());
    EXPECT_TRUE(forestOf(treeAtOrigin + "[wind]\nkind = \"calm\"\n").wind.isCalm());
}

TEST(ForestFile, UniformWindSupportsUnitsAndDirections) {
    expectNear(windOf("kind = \"uniform\"\nvelocity = [1, 2, 3]\n"), {1, 2, 3});
    expectNear(windOf("kind = \"uniform\"\nspeed = 36\nunit = \"km/h\"\ndirection_from = 0\n"), {0, -10, 0});
    expectNear(windOf("kind = \"uniform\"\nspeed = 10\ndirection_toward = 90\n"), {10, 0, 0});
}

TEST(ForestFile, GridIsInWorldCoordinates) {
    const ForestFile forest = forestOf(
        "[[tree]]\nposition = [500000, 4000000]\n[wind]\nkind = \"grid\"\norigin = [499990, 4000000, 0]\n"
        "points = [2, 1]\ncell = [20, 20]\nvalues = [1, 0, 0, 3, 0, 0]\n");
    ASSERT_TRUE(forest.wind.field);
    expectNear(asField(forest.wind)->velocity({-10, 0, 0}, 0.0), {1, 0, 0}); // the first point, from the tree
    expectNear(asField(forest.wind)->velocity({0, 0, 0}, 0.0), {2, 0, 0});
}

TEST(ForestFile, WindSourcesAreInWorldCoordinates) {
    const ForestFile forest =
        forestOf("[[tree]]\nposition = [500000, 4000000]\n[wind]\nkind = \"uniform\"\nvelocity = [0, 1, "
                 "0]\nturn = 90\n"
                 "[[wind.source]]\nkind = \"jet\"\nposition = [500004, 4000000, 2]\nradius = 0.5\nspeed = 7\n"
                 "toward = 90\nturbulence = 0\n[[wind.source]]\nkind = \"shelter\"\nplace = [-20, 0, "
                 "0]\nshare = 0.5\n");
    ASSERT_TRUE(forest.wind.field);
    expectNear(asField(forest.wind)->velocity({5, 0, 2}, 0.0), {8, 0, 0}, 0.01f);
    expectNear(asField(forest.wind)->velocity({0, 0, 2}, 0.0), {1, 0, 0});
    expectNear(asField(forest.wind)->velocity({-20, 0, 2}, 0.0), {0.5f, 0, 0});
}

TEST(ForestFile, ForestWindReadsAnArrayFile) {
    const TemporaryFolder folder;
    folder.write("w.txt", "# u v w in thesis axes\n1 0 0\n2, 0, 0\n");
    expectNear(windOf("kind = \"forest_wind\"\nwidth = 2\nlength = 1\nfile = \"w.txt\"\n", {1.5f, 0, 0}, 0.0,
                      folder.path()),
               {2, 0, 0});
}

TEST(ForestFile, SeriesIsLinearAndRetimed) {
    const std::string record = "kind = \"series\"\ntimes = [0, 10]\nvelocities = [[0, 0, 0], [4, 2, 0]]\n";
    expectNear(windOf(record, {}, 5.0), {2, 1, 0});
    expectNear(windOf(record + "start = 2.5\ntime_scale = 2.0\n", {}, 1.25), {2, 1, 0});
    expectNear(windOf(record + "repeat = true\n", {}, 15.0), {2, 1, 0});
}

TEST(ForestFile, SeriesFollowsTheLogarithmicProfile) {
    const float u = windOf("kind = \"series\"\ntimes = [0]\nvelocities = [[5, 0, 0]]\nheight = 10\n"
                           "roughness = 0.1\n",
                           {0, 0, 1})
                        .x;
    EXPECT_NEAR(u, 5.0f * std::log(1.0f / 0.1f) / std::log(10.0f / 0.1f), 1e-4f);
}

TEST(ForestFile, SeriesReadsNamedColumns) {
    const TemporaryFolder folder;
    folder.write("w.csv", "when;kmh;deg\n0;36;270\n1;72;270\n");
    expectNear(windOf("kind = \"series\"\nfile = \"w.csv\"\ndelimiter = \";\"\ntime_unit = \"min\"\n"
                      "speed_unit = \"km/h\"\n"
                      "columns = { time = \"when\", speed = \"kmh\", direction_from = \"deg\" }\n",
                      {}, 30.0, folder.path()),
               {15, 0, 0});
}

TEST(ForestFile, SpeciesAreFoundByAliasInAnyCase) {
    const ForestFile forest =
        forestOf("[[tree]]\nposition = [0, 0]\nspecies = \"PINUS nigra\"\n[[species]]\nname = \"a\"\n"
                 "[[species]]\nname = \"b\"\naliases = [\"Pinus nigra\"]\n");
    EXPECT_EQ(forest.trees[0].species, 1u);
}

TEST(ForestFile, MessagesHaveFileLineAndColumn) {
    std::istringstream input("version = 1\n[[tree]]\nposition = [0, 0]\nheight = -2\n");
    const auto result = readForest(input, {"my.treewind", ""});
    ASSERT_FALSE(result.ok());
    EXPECT_TRUE(isProblem(result.problems().front().text(), "my.treewind:4:10: tree.height", "found -2"));
}

TEST(ForestFile, SettingsOverrideKeysOfTheDocument) {
    const std::string document = "version = 1\nseason = \"winter\"\n[wind]\nkind = \"uniform\"\nspeed = 3.0\n"
                                 "direction_from = 270.0\n" +
                                 treeAtOrigin;
    const auto with = [&](const std::vector<std::string>& settings) {
        std::istringstream input(document);
        return readForest(input, {"my.treewind", "", 100, settings});
    };
    const ForestFile forest = expectForest(with({"wind.speed=15", "season=autumn", "motion.gain = 2"}));
    expectNear(asField(forest.wind)->velocity({}, 0.0), {15, 0, 0});
    EXPECT_EQ(forest.season, expectForest(with({"season=\"autumn\""})).season);
    EXPECT_NE(forest.season, expectForest(with({})).season);
    EXPECT_EQ(forest.source, "") << "the source does not include the settings";
    const auto problem = [&](const std::string& setting) {
        const auto result = with({setting});
        return result.ok() ? "" : result.problems().front().text();
    };
    EXPECT_TRUE(isProblem(problem("wind.speed=fast"), "setting \"wind.speed=fast\":1:12: wind.speed",
                          "found the text \"fast\""));
    EXPECT_TRUE(
        isProblem(problem("wind.sped=3"), "setting \"wind.sped=3\":1:6: wind.sped", "did you mean speed?"));
    EXPECT_EQ(problem("season").rfind("setting \"season\":1:", 0), 0u) << problem("season");
    EXPECT_NE(problem("tree.height=3"), "") << "keys in arrays of tables cannot be set";
}

TEST(ForestFile, RejectsAForestThatDoesNotFitIntoMemory) {
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "100M");
    std::istringstream input("version = 1\n[scatter]\ncount = 1000000\narea = [0, 0, 9000, 9000]\n");
    const Result<ForestFile> forest = readForest(input, {"large.treewind", ""});
    ASSERT_FALSE(forest);
    ASSERT_EQ(forest.problems().size(), 1u);
    const std::string text = forest.problems().front().text();
    EXPECT_EQ(text.rfind("large.treewind:1", 0), 0u) << text;
    EXPECT_TRUE(hasPart(text, "1000000 trees of these species need about "));
    EXPECT_TRUE(hasPart(text, "the limit is 100 MB"));
}

namespace {

std::vector<std::string> notesOfSpecies(const std::string& name, const std::string& keys) {
    std::istringstream document("version = 1\n[[species]]\nname = \"" + name + "\"\n" + keys +
                                "[[tree]]\nposition = [0, 0]\n");
    const auto forest = readForest(document, {"f.treewind", ""});
    return forest ? forest.value().notes : std::vector<std::string>{forest.problems().front().text()};
}

} // namespace

TEST(ForestFile, NotesThatANamesakeOfABuiltInSpeciesHasTheDefaultShape) {
    EXPECT_EQ(notesOfSpecies("silver birch", ""),
              std::vector<std::string>{
                  "the species \"silver birch\" has the shape of the thesis' tree; for that of the "
                  "built-in species, set like = \"silver birch\""});
    EXPECT_TRUE(notesOfSpecies("silver birch", "like = \"silver birch\"\n").empty());
    EXPECT_TRUE(notesOfSpecies("silver birch", "[species.habit]\nheight = 12\n").empty());
}

TEST(ForestFile, NotesThatLikeFoundAGenericSpecies) {
    const std::vector<std::string> note = {
        "like: the built-in species \"broadleaf\" is used for \"hornbeam\""};
    EXPECT_EQ(notesOfSpecies("mine", "like = \"hornbeam\"\n"), note);
    EXPECT_EQ(notesOfSpecies("mine", "[species.habit]\nlike = \"hornbeam\"\n"), note);
    EXPECT_TRUE(notesOfSpecies("mine", "like = \"Fagus sylvatica\"\n").empty());
    EXPECT_TRUE(notesOfSpecies("mine", "like = \"broadleaf\"\n").empty());
}

} // namespace osgTreeWind

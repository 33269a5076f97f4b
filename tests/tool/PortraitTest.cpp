// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <osgDB/ReadFile>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using Json = nlohmann::json;

/// Mean brightness of a picture on the sheet, [0, 1]. @param row counted from the top.
double brightness(const osg::Image& sheet, int column, int row, int panel) {
    double sum = 0.0;
    for (int y = 0; y < panel; ++y)
        for (int x = 0; x < panel; ++x) {
            const osg::Vec4 color = sheet.getColor(static_cast<unsigned>(column * panel + x),
                                                   static_cast<unsigned>((2 - row) * panel + y));
            sum += static_cast<double>(color.r() + color.g() + color.b()) / 3.0;
        }
    return sum / (panel * panel);
}

} // namespace

TEST(Portrait, JsonHasTheNumbersAndNeedsNoGraphics) {
    const TemporaryFolder folder;
    const Outcome outcome = runTool({"portrait", "silver birch", "--json"}, folder.path());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Json looks = Json::parse(outcome.out);
    EXPECT_EQ(looks["species"], "silver birch");
    for (const char* key : {"crownOverStem", "leafInclination", "leafAreaDrawn", "leafAreaMechanics",
                            "hueSpread", "greenShare"})
        EXPECT_GT(looks[key].get<double>(), 0.0) << key;
    const double summer = looks["skyThroughCrown"]["summer"], winter = looks["skyThroughCrown"]["winter"];
    EXPECT_GT(summer, 0.0);
    EXPECT_LT(summer, winter);
    EXPECT_LT(winter, 1.0);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_EQ(outcome.out, runTool({"portrait", "silver birch", "--json"}).out);
}

TEST(Portrait, NamesWhereTheTreeGrew) {
    const TemporaryFolder folder;
    const std::string beech =
        folder.write("beech.treewind", "version = 1\n[[species]]\nname = \"beech\"\nlike = \"beech\"\n"
                                       "[species.crown]\ndepth = 0.9\ndepth_per_height = "
                                       "0.47\n[[tree]]\nspecies = \"beech\"\nposition = [0.0, 0.0, 0.0]\n") +
        ":beech";
    const Outcome open = runTool({"portrait", beech, "--json"}),
                  forest = runTool({"portrait", beech, "--json", "--forest"});
    ASSERT_EQ(open.exitCode, 0) << open.err;
    ASSERT_EQ(forest.exitCode, 0) << forest.err;
    EXPECT_EQ(Json::parse(open.out)["grown"], "the open");
    EXPECT_EQ(Json::parse(forest.out)["grown"], "a forest");
    EXPECT_NE(Json::parse(open.out)["skyThroughCrown"], Json::parse(forest.out)["skyThroughCrown"]);
    EXPECT_NE(runTool({"portrait", beech, "--forest"}).out.find("grown in a forest\n"), std::string::npos);
    EXPECT_EQ(Json::parse(open.out)["skyThroughCrown"],
              Json::parse(runTool({"portrait", "beech", "--json"}).out)["skyThroughCrown"]);
}

TEST(Portrait, PrintsTheNumbersAsText) {
    const Outcome outcome = runTool({"portrait", "beech"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("beech\n"), 0u);
    EXPECT_NE(outcome.out.find("leafAreaMechanics, m2"), std::string::npos);
}

TEST(Portrait, EveryPictureHasALabel) {
    const TemporaryFolder folder;
    ASSERT_EQ(runTool({"portrait", "palm", "-o", "palm.png", "--panel", "128"}, folder.path()).exitCode, 0);
    const osg::ref_ptr<osg::Image> sheet = osgDB::readRefImageFile(folder.path() + "/palm.png");
    ASSERT_TRUE(sheet);
    for (int panel = 0; panel < 15; ++panel) {
        int letters = 0, strip = 0;
        for (int x = 0; x < 60; ++x)
            for (int y = 1; y <= 16; ++y) {
                const float green = sheet
                                        ->getColor(static_cast<unsigned>(panel % 5 * 128 + x),
                                                   static_cast<unsigned>((3 - panel / 5) * 128 - y))
                                        .g();
                letters += green > 0.99f;
                strip += green < 0.5f;
            }
        EXPECT_GT(letters, 50) << panel;
        EXPECT_GT(strip, 400) << panel;
    }
}

TEST(Portrait, TheSheetHasAllItsPictures) {
    const TemporaryFolder folder;
    const Outcome outcome =
        runTool({"portrait", "oak", "-o", "oak.png", "--panel", "48", "--season", "spring"}, folder.path());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const osg::ref_ptr<osg::Image> sheet = osgDB::readRefImageFile(folder.path() + "/oak.png");
    ASSERT_TRUE(sheet);
    EXPECT_EQ(sheet->s(), 5 * 48);
    EXPECT_EQ(sheet->t(), 3 * 48);
    // Outlines are black on white, with more black in summer.
    const double summer = brightness(*sheet, 4, 0, 48), winter = brightness(*sheet, 4, 1, 48);
    EXPECT_GT(summer, 0.5);
    EXPECT_LT(summer, winter);
    EXPECT_LT(winter, 0.99);
    EXPECT_GT(sheet->getColor(4u * 48u + 1u, 2u * 48u + 46u).g(), 0.99f);
    for (int i = 0; i < 14; ++i)
        EXPECT_GT(brightness(*sheet, i % 5, i / 5, 48), 0.1) << i;
}

TEST(Portrait, TakesASpeciesOfAFile) {
    const Outcome outcome = runTool({"portrait", example("forest.treewind") + ":spruce", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["species"], "spruce");
}

TEST(Portrait, TakesASpeciesOfACatalogue) {
    const TemporaryFolder folder;
    folder.write("species.treewind", "version = 1\n[[species]]\nname = \"hornbeam\"\nlike = \"beech\"\n");
    const Outcome outcome = runTool({"portrait", "species.treewind:hornbeam", "--json"}, folder.path());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["species"], "hornbeam");
}

TEST(Portrait, NotesAGenericSpecies) {
    const Outcome outcome = runTool({"portrait", "hornbeam", "--json"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "hornbeam: note: the built-in species \"broadleaf\" is used for \"hornbeam\"\n");
    EXPECT_EQ(runTool({"portrait", "Quercus robur", "--json"}).err, "");
    EXPECT_EQ(runTool({"portrait", "broadleaf", "--json"}).err, "");
}

TEST(Portrait, WritesAllKeysOfASpecies) {
    const TemporaryFolder folder;
    ASSERT_EQ(runTool({"portrait", "beech", "-o", "beech.treewind"}, folder.path()).exitCode, 0);
    const std::string text = contentOf(folder.path() + "/beech.treewind");
    for (const char* key : {"\nbranch_angle = ", "\nelastic_modulus = ", "\nautumn_leaves = ", "\nscale = "})
        EXPECT_NE(text.find(key), std::string::npos) << key;
    EXPECT_EQ(runTool({"portrait", "beech.treewind:beech", "--json"}, folder.path()).out,
              runTool({"portrait", "beech", "--json"}).out);
    EXPECT_EQ(runTool({"portrait", "beech", "-o", "absent/beech.treewind"}, folder.path()).exitCode, 1);
}

TEST(Portrait, BadUsageIsExitCode2) {
    const TemporaryFolder folder;
    EXPECT_EQ(runTool({"portrait"}).exitCode, 2);
    const Outcome unknown = runTool({"portrait", "triffid"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("no built-in species \"triffid\""), std::string::npos);
    const Outcome inFile = runTool({"portrait", example("forest.treewind") + ":triffid"});
    EXPECT_EQ(inFile.exitCode, 2);
    EXPECT_NE(inFile.err.find("no species \"triffid\" in this file; expected one of "), std::string::npos)
        << inFile.err;
    EXPECT_EQ(runTool({"portrait", "absent.treewind:oak"}).exitCode, 2);
    EXPECT_EQ(runTool({"portrait", "oak", "-o", "oak.jpg"}, folder.path()).exitCode, 2);
    const Outcome season = runTool({"portrait", "oak", "--season", "monsoon"});
    EXPECT_EQ(season.exitCode, 2);
    EXPECT_NE(season.err.find("found 'monsoon'"), std::string::npos) << season.err;
    EXPECT_EQ(runTool({"portrait", "oak", "-o", "absent/oak.png", "--panel", "16"}, folder.path()).exitCode,
              1);
}

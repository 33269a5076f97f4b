// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

using nlohmann::json;

json swayOf(std::vector<std::string> words) {
    words.insert(words.begin(), "sway");
    words.emplace_back("--json");
    const Outcome outcome = runTool(words);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
}

TEST(Sway, PrintsTheMeasuredSway) {
    const json sway = swayOf({"--species", "Picea sitchensis", "--dbh", "14.5", "--height", "14.2"});
    EXPECT_EQ(sway["species"], "Sitka spruce");
    EXPECT_EQ(sway["dbh_cm"], 14.5);
    EXPECT_EQ(sway["height_m"], 14.2);
    EXPECT_NEAR(sway["frequency_hz"].get<double>(), 0.35, 0.09); // Milne 1991
    EXPECT_GT(sway["damping_ratio"].get<double>(), 0.04);
    EXPECT_LT(sway["damping_ratio"].get<double>(), 0.2);
    ASSERT_GE(sway["modes"].size(), 8u);
    for (const json& mode : sway["modes"])
        EXPECT_GT(mode["damping"].get<double>(), 0.04);
    EXPECT_NEAR(sway["modes"][0]["hz"].get<double>() / sway["frequency_hz"].get<double>(), 1.0, 0.05);
    EXPECT_GT(sway["modes"][0]["share"].get<double>(), sway["modes"][2]["share"].get<double>());
}

TEST(Sway, TakesSpeciesOfAFileInTheFilePath) {
    const TemporaryFolder empty, folder;
    const std::string path = "OSG_FILE_PATH=" + empty.path() + ':' + folder.path() + ' ';
    folder.write("species.treewind", "version = 1\n[[species]]\nname = \"wych elm\"\nlike = \"oak\"\n");
    const Outcome elm = runTool({"sway", "--species", "wych elm", "--json"}, ".", path);
    EXPECT_EQ(elm.err, "");
    EXPECT_EQ(json::parse(elm.out, nullptr, false)["species"], "wych elm");
    folder.write("oak.treewind", "version = 1\n[[tree]]\nposition = [0, 0]\nspecies = \"wych elm\"\n");
    EXPECT_EQ(runTool({"validate", folder.path() + "/oak.treewind"}, ".", path).exitCode, 0);
}

TEST(Sway, ABrokenSpeciesFileIsAWarningForSwayAndAnErrorForForests) {
    const TemporaryFolder folder;
    const std::string path = "OSG_FILE_PATH=" + folder.path() + ' ';
    const std::string file = folder.write("species.treewind", "version = 1\n[[species]]\nname = 3\n");
    const std::string problem = file + ":3:8: species.name: expected a text in quotes, found 3";
    const Outcome oak = runTool({"sway", "--species", "oak", "--json"}, ".", path);
    EXPECT_EQ(oak.exitCode, 0);
    EXPECT_EQ(oak.err, "osgTreeWind: " + problem + "; the built-in species are used\n");
    EXPECT_EQ(oak.out, runTool({"sway", "--species", "oak", "--json"}).out);
    const std::string tree = "version = 1\n[[tree]]\nposition = [0, 0]\n";
    folder.write("plain.treewind", tree);
    folder.write("oak.treewind", tree + "species = \"oak\"\n");
    EXPECT_EQ(runTool({"validate", folder.path() + "/plain.treewind"}, ".", path).exitCode, 0)
        << "needs no catalogue";
    const Outcome forest = runTool({"validate", folder.path() + "/oak.treewind"}, ".", path);
    EXPECT_EQ(forest.exitCode, 2);
    EXPECT_NE(forest.err.find(problem), std::string::npos) << forest.err;
}

TEST(Sway, PrintsTheModes) {
    const Outcome outcome = runTool({"sway", "--species", "oak", "--dbh", "40", "--height", "18"});
    EXPECT_NE(outcome.out.find("\nmodes      Hz  damping  share of gusts\n    1 "), std::string::npos)
        << outcome.out;
}

TEST(Sway, ALargerPullIsDampedMore) {
    const auto pulled = [](const char* share) {
        return swayOf({"--species", "ash", "--dbh", "30", "--height", "20", "--pull", share})["damping_ratio"]
            .get<double>();
    };
    EXPECT_GT(pulled("0.05"), pulled("0.01") + 0.01);
}

TEST(Sway, ATableOfTreesGivesATableOfTheirSway) {
    const auto path = std::filesystem::temp_directory_path() / "sway_trees.csv";
    const auto tableOf = [&](const char* text) {
        std::ofstream(path) << text;
        return runTool({"sway", "--table", path.string()});
    };
    const Outcome outcome =
        tableOf("species,height_m,dbh_cm,open\noak,18,40,0\nbroadleaf,15,30,1\n,15,30,\n");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.out.rfind("species,dbh_cm,height_m,crown_width_m,open,leaves,frequency_hz,"
                                "damping_ratio\noak,40,18,",
                                0),
              0u)
        << outcome.out;
    EXPECT_NE(outcome.out.find("\nbroadleaf,30,15,"), std::string::npos) << outcome.out;
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 4);
    const Outcome tall = tableOf("species,height_m\noak,1800\n");
    EXPECT_EQ(tall.exitCode, 2);
    EXPECT_NE(tall.err.find(":2: height_m: expected a number from 0.1 to 150, found '1800'"),
              std::string::npos)
        << tall.err;
    EXPECT_EQ(tableOf("height_m\nthick\n").exitCode, 2);
    std::filesystem::remove(path);
    EXPECT_EQ(runTool({"sway", "--table", path.string()}).exitCode, 2);
}

TEST(Sway, SizesNotGivenFollowFromTheHeightByTheLawOfTheSpecies) {
    const json shape = swayOf({"--species", "oak"});
    EXPECT_GT(shape["height_m"].get<double>(), 5.0);
    const json tall = swayOf({"--species", "oak", "--height", "22"});
    EXPECT_NEAR(tall["dbh_cm"].get<double>() / shape["dbh_cm"].get<double>(),
                std::pow(22.0 / shape["height_m"].get<double>(), 1.0 / 0.562), 0.1);
}

TEST(Sway, TheCrownFollowsFromTheTrunkAndFromOpen) {
    const std::vector<std::string> lime{"--species", "lime", "--dbh", "50", "--height", "16"};
    const auto with = [&lime](std::vector<std::string> more) {
        more.insert(more.begin(), lime.begin(), lime.end());
        return swayOf(more);
    };
    const json forest = with({}), open = with({"--open"}), narrow = with({"--open", "--crown-width", "5"});
    EXPECT_NEAR(forest["crown_width_m"].get<double>(), 9.7, 0.3);
    EXPECT_NEAR(open["crown_width_m"].get<double>(), 11.9, 0.3);
    EXPECT_EQ(open["open_grown"], true);
    EXPECT_EQ(narrow["crown_width_m"], 5.0);
    // A wide crown lowers the frequency; the deep crown of an open-grown tree raises it again.
    EXPECT_LT(open["frequency_hz"].get<double>(), 1.1 * forest["frequency_hz"].get<double>());
    EXPECT_GT(open["frequency_hz"].get<double>(), 0.85 * forest["frequency_hz"].get<double>());
    EXPECT_GT(narrow["frequency_hz"].get<double>(), open["frequency_hz"].get<double>());
}

TEST(Sway, ABareTreeSwaysFaster) {
    const std::vector<std::string> ash{"--species", "ash", "--dbh", "30", "--height", "20", "--leaves"};
    const auto with = [&ash](const char* share) {
        std::vector<std::string> words = ash;
        words.emplace_back(share);
        return swayOf(words)["frequency_hz"].get<double>();
    };
    EXPECT_GT(with("0"), 1.01 * with("1"));
    EXPECT_EQ(runTool({"sway", "--leaves", "2"}).exitCode, 2);
}

TEST(Sway, AnUnknownSpeciesIsRefusedWithTheLineOfItsRow) {
    const Outcome outcome = runTool({"sway", "--species", "lamp post", "--dbh", "30", "--height", "15"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.err.find("no built-in species \"lamp post\""), std::string::npos);
    EXPECT_EQ(outcome.out, "");
    const TemporaryFolder folder;
    const std::string table = folder.write("t.csv", "species,dbh_cm,height_m\noak,30,15\nlamp post,30,15\n");
    const Outcome row = runTool({"sway", "--table", table});
    EXPECT_EQ(row.exitCode, 2);
    EXPECT_NE(row.err.find("t.csv:3: no built-in species \"lamp post\""), std::string::npos) << row.err;
    EXPECT_EQ(row.out, "");
}

TEST(Sway, TakesASpeciesOfAFile) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.treewind",
        "version = 1\n[[species]]\nname = \"stiff\"\nlike = \"oak\"\n[species.wood]\nelastic_modulus = "
        "4e10\n[[tree]]\nspecies = \"stiff\"\nposition = [0, 0]\n");
    const auto frequency = [](const std::string& species) {
        return swayOf({"--species", species, "--dbh", "30", "--height", "15"})["frequency_hz"].get<double>();
    };
    EXPECT_GT(frequency(file + ":stiff"), 1.5 * frequency("oak"));
    const Outcome none = runTool({"sway", "--species", file + ":soft"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.err.find("no species \"soft\""), std::string::npos);
}

TEST(Sway, ListsSpeciesWithTheirSources) {
    const Outcome outcome = runTool({"sway", "--list"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.out.find("Norway spruce, spruce, Picea abies"), std::string::npos);
    EXPECT_NE(outcome.out.find("ForestGALES"), std::string::npos);
    EXPECT_GE(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 2 * 12);
}

TEST(Sway, RefusesInvalidSizes) {
    for (const char* bad : {"0", "-3", "nan", "thick"}) {
        const Outcome outcome = runTool({"sway", "--dbh", bad});
        EXPECT_EQ(outcome.exitCode, 2) << bad;
        EXPECT_NE(outcome.err.find("--dbh"), std::string::npos) << outcome.err;
    }
}

} // namespace

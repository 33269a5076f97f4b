// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace {

using nlohmann::json;

const std::vector<std::string> spruce{"--species", "Sitka spruce", "--dbh", "24", "--height", "20"};

json stormOf(std::vector<std::string> words) {
    words.insert(words.begin(), spruce.begin(), spruce.end());
    words.insert(words.begin(), {"storm", "--json"});
    const Outcome outcome = runTool(words);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
}

TEST(Storm, AStandCarriesTheMomentumThatFlowsIntoIt) {
    const json storm = stormOf({"--speed", "6", "--spacing", "3", "--duration", "1200", "--no-critical"});
    // rho u*^2 on nine square metres; it acts somewhere in the crown.
    const double force = 1.225 * 0.09 * 36.0 * 9.0, mean = storm["moment"]["mean"],
                 push = storm["push"]["mean"];
    EXPECT_GT(push, 0.5 * 20.0 * force);
    EXPECT_LT(push, 20.0 * force);
    EXPECT_GT(mean, 1.05 * push) << "overhanging weight";
    EXPECT_GT(storm["moment"]["max"].get<double>(), 4.0 * mean);
    EXPECT_GT(storm["features"]["skewness"].get<double>(), 0.5);
    EXPECT_NEAR(storm["features"]["f0_hz"].get<double>() / storm["frequency_hz"].get<double>(), 1.0, 0.35);
}

TEST(Storm, TheBasalAreaGivesTheSpacing) {
    const std::vector<std::string> shortly = {"--duration", "1", "--no-critical"};
    const auto storm = [&](std::vector<std::string> words) {
        words.insert(words.end(), shortly.begin(), shortly.end());
        return stormOf(words);
    };
    const json dense = storm({"--basal-area", "62"}); // stems of 24 cm
    EXPECT_NEAR(dense["spacing_m"].get<double>(), 2.7012, 1e-3);
    EXPECT_NEAR(dense["basal_area_m2ha"].get<double>(), 62.0, 1e-9);
    EXPECT_NEAR(storm({"--spacing", "3"})["basal_area_m2ha"].get<double>(), 50.265, 1e-3);
    EXPECT_TRUE(storm({"--open"})["basal_area_m2ha"].is_null());
}

TEST(Storm, ATreeAloneLeansFurther) {
    const json stand = stormOf({"--speed", "10", "--duration", "300", "--no-critical"}),
               alone = stormOf({"--speed", "10", "--duration", "300", "--open", "--no-critical"});
    EXPECT_GT(alone["tip"]["mean"].get<double>(), 1.5 * stand["tip"]["mean"].get<double>());
    EXPECT_TRUE(alone["spacing_m"].is_null());
    EXPECT_TRUE(stand["features"].is_null()) << "five minutes are too short";
}

TEST(Storm, WritesATraceOfWindAndSway) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/trace.csv";
    stormOf({"--speed", "8", "--duration", "60", "--no-critical", "-o", path});
    const std::string trace = contentOf(path);
    EXPECT_EQ(trace.rfind("time,wind_x,wind_y,strain_x,strain_y,tilt_x,tilt_y,tip_x,tip_y\n0.125,", 0), 0u);
    EXPECT_EQ(std::count(trace.begin(), trace.end(), '\n'), 1 + 8 * 60);
    EXPECT_EQ(trace.find("nan"), std::string::npos);
}

TEST(Storm, TheSameSeedGivesTheSameStorm) {
    const json a = stormOf({"--duration", "30", "--no-critical"}),
               b = stormOf({"--duration", "30", "--no-critical"}),
               c = stormOf({"--duration", "30", "--seed", "2", "--no-critical"});
    EXPECT_EQ(a, b);
    EXPECT_NE(a["moment"], c["moment"]);
}

TEST(Storm, StaysFiniteInTheStrongestWinds) {
    const json storm = stormOf({"--speed", "72", "--duration", "60", "--open", "--no-critical"});
    EXPECT_TRUE(std::isfinite(storm["moment"]["max"].get<double>()));
    EXPECT_LT(storm["tip"]["max"].get<double>(), 40.0);
}

TEST(Storm, ACalmMovesNothing) {
    const json calm = stormOf({"--speed", "0", "--duration", "10", "--no-critical"});
    EXPECT_EQ(calm["moment"]["max"], 0.0);
    EXPECT_EQ(calm["weight_factor"], 1.0);
}

TEST(Storm, WeightDeepensALean) {
    const json storm = stormOf({"--duration", "1200", "--no-critical"});
    // The overhanging weight at the foot, which comes from places and masses, agrees with the softer modes.
    const double byMoments = storm["moment"]["mean"].get<double>() / storm["push"]["mean"].get<double>();
    EXPECT_NEAR(storm["weight_factor"].get<double>() / byMoments, 1.0, 0.04);
    EXPECT_GT(byMoments, 1.05);
}

TEST(Storm, NotesAStemThatWouldHaveBroken) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/trees.csv";
    std::ofstream(path) << "species,dbh_cm,height_m,speed_ms\nSitka spruce,24,20,50\nSitka spruce,24,20,1\n"
                           "palm,24,10,50\n";
    const Outcome outcome = runTool({"storm", "--table", path, "--duration", "60", "--no-critical"});
    EXPECT_EQ(outcome.err.find(path + ":2: note: the largest strain of the stem, "), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    const json storm = stormOf({"--speed", "50", "--duration", "60", "--no-critical"});
    EXPECT_GT(storm["strain_max"], storm["strain_limit"]);
    // Moment and strain at the foot are proportional: 34 MPa pi d^3 / 32 at the limit.
    EXPECT_NEAR(storm["strain_limit"].get<double>() / storm["strain_max"].get<double>(),
                46143.0 / storm["moment"]["max"].get<double>(), 0.15);
}

TEST(Storm, AtTheCriticalWindTheLargestMomentReachesTheStrength) {
    const json storm = stormOf({"--speed", "6", "--duration", "1"});
    const double uproot = storm["critical"]["uproot"], breaks = storm["critical"]["break"];
    EXPECT_LT(breaks, uproot); // true for a slender spruce on mineral soil
    const json atBreak = stormOf({"--speed", std::to_string(breaks), "--duration", "3600"});
    // 34 MPa pi d^3 / 32; this is one of the three hours that the critical wind averages
    EXPECT_NEAR(atBreak["moment"]["max"].get<double>() / 46143.0, 1.0, 0.35);
}

TEST(Storm, NoCriticalLeavesOutTheCriticalWinds) {
    json with = stormOf({"--duration", "1"}), without = stormOf({"--duration", "1", "--no-critical"});
    EXPECT_TRUE(with["critical"]["uproot"].is_number());
    EXPECT_EQ(without["critical"], (json{{"uproot", nullptr}, {"break", nullptr}}));
    with.erase("critical");
    without.erase("critical");
    EXPECT_EQ(with, without);
}

TEST(Storm, ATableSimulatesEveryTree) {
    const TemporaryFolder folder;
    const std::string trees = folder.write("trees.csv", "species,dbh_cm,height_m,spacing_m,speed_ms,open\n"
                                                        "Sitka spruce,24,20,3,6,0\n"
                                                        "oak,40,18,,8,1\n"),
                      out = folder.path() + "/out.csv";
    const Outcome outcome = runTool({"storm", "--table", trees, "--duration", "30", "-o", out});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string text = contentOf(out);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
    EXPECT_EQ(text.rfind("species,dbh_cm,height_m,crown_width_m,spacing_m,basal_area_m2ha,leaves,speed_ms,"
                         "moment_mean,",
                         0),
              0u);
    const json one = stormOf({"--spacing", "3", "--speed", "6", "--duration", "30"});
    EXPECT_NE(text.find("," + one["moment"]["max"].dump() + ","), std::string::npos) << text;
    EXPECT_NE(text.find("\noak,40.0,18.0,"), std::string::npos) << text;
}

TEST(Storm, ReadsTheTreesThatInfoLists) {
    const TemporaryFolder folder;
    folder.write("f.treewind",
                 "version = 1\n"
                 "[[tree]]\nid = \"a, b\"\nspecies = \"Sitka spruce\"\nposition = [5, 5]\nheight = 20\n"
                 "trunk_diameter = 0.24\ncrown_width = 3.5\n"
                 "[[tree]]\nspecies = \"oak\"\nposition = [25, 5]\nheight = 18\nopen_grown = true\n");
    const auto run = [&](const std::vector<std::string>& words) {
        const Outcome outcome = runTool(words, folder.path());
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    };
    run({"tile", "f.treewind", "-o", "w", "--size", "10"});
    run({"info", "w/world.treewind", "--tiles", "0,0", "--trees", "trees.csv"});
    run({"storm", "--table", "trees.csv", "--duration", "30", "--speed", "6", "--no-critical", "-o",
         "out.csv"});
    const std::string text = contentOf(folder.path() + "/out.csv");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
    EXPECT_EQ(text.rfind("id,species,dbh_cm,", 0), 0u) << text;
    const json one = stormOf({"--crown-width", "3.5", "--speed", "6", "--duration", "30", "--no-critical"});
    EXPECT_NE(text.find("\n\"a, b\",Sitka spruce,24.0,20.0,3.5,"), std::string::npos) << text;
    EXPECT_NE(text.find("," + one["moment"]["max"].dump() + ","), std::string::npos) << text << one.dump();
}

TEST(Storm, RefusesAnInvalidTable) {
    const TemporaryFolder folder;
    const std::string trees = folder.write("trees.csv", "species,speed_ms\noak,90\n");
    const Outcome outcome = runTool({"storm", "--table", trees});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.err.find("trees.csv:2: speed_ms: expected a number from 0 to 80, found '90'"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(runTool({"storm", "--table", "/nowhere.csv"}).exitCode, 2);
    const std::string both = folder.write("both.csv", "dbh_cm,spacing_m,basal_area_m2ha\n24,,30\n24,3,30\n"),
                      dense = folder.write("dense.csv", "dbh_cm,height_m,basal_area_m2ha\n1,3,900\n");
    EXPECT_NE(
        runTool({"storm", "--table", both}).err.find("both.csv:3: expected spacing_m or basal_area_m2ha"),
        std::string::npos);
    EXPECT_NE(runTool({"storm", "--table", dense}).err.find("dense.csv:2: basal area: expected at most 78.5"),
              std::string::npos);
}

TEST(Storm, RefusesInvalidOptions) {
    EXPECT_EQ(runTool({"storm", "--speed", "-1"}).exitCode, 2);
    EXPECT_EQ(runTool({"storm", "--step", "0.5"}).exitCode, 2);
    EXPECT_EQ(runTool({"storm", "--spacing", "3", "--open"}).exitCode, 2);
    EXPECT_EQ(runTool({"storm", "--spacing", "3", "--basal-area", "30"}).exitCode, 2);
    EXPECT_EQ(runTool({"storm", "--basal-area", "30", "--open"}).exitCode, 2);
    const Outcome outcome = runTool({"storm", "--duration", "1", "-o", "/nowhere/trace.csv"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("/nowhere/trace.csv: cannot be written"), std::string::npos) << outcome.err;
}

} // namespace

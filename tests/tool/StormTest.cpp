// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

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
    const json storm = stormOf({"--speed", "6", "--spacing", "3", "--duration", "1200"});
    // rho u*^2 on nine square metres, somewhere in the crown.
    const double force = 1.225 * 0.09 * 36.0 * 9.0, mean = storm["moment"]["mean"];
    EXPECT_GT(mean, 0.5 * 20.0 * force);
    EXPECT_LT(mean, 1.05 * 20.0 * force);
    EXPECT_GT(storm["moment"]["max"].get<double>(), 4.0 * mean);
    EXPECT_GT(storm["features"]["skewness"].get<double>(), 0.5);
    EXPECT_NEAR(storm["features"]["f0_hz"].get<double>() / storm["frequency_hz"].get<double>(), 1.0, 0.35);
}

TEST(Storm, AloneItLeansFurther) {
    const json stand = stormOf({"--speed", "10", "--duration", "300"}),
               alone = stormOf({"--speed", "10", "--duration", "300", "--open"});
    EXPECT_GT(alone["tip"]["mean"].get<double>(), 1.5 * stand["tip"]["mean"].get<double>());
    EXPECT_TRUE(alone["spacing_m"].is_null());
    EXPECT_TRUE(stand["features"].is_null()) << "five minutes are too short";
}

TEST(Storm, WritesATraceOfWindAndSway) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/trace.csv";
    stormOf({"--speed", "8", "--duration", "60", "-o", path});
    const std::string trace = contentOf(path);
    EXPECT_EQ(trace.rfind("time,wind_x,wind_y,strain_x,strain_y,tilt_x,tilt_y,tip_x,tip_y\n0.125,", 0), 0u);
    EXPECT_EQ(std::count(trace.begin(), trace.end(), '\n'), 1 + 8 * 60);
    EXPECT_EQ(trace.find("nan"), std::string::npos);
}

TEST(Storm, OneSeedIsOneStorm) {
    const json a = stormOf({"--duration", "30"}), b = stormOf({"--duration", "30"}),
               c = stormOf({"--duration", "30", "--seed", "2"});
    EXPECT_EQ(a, b);
    EXPECT_NE(a["moment"], c["moment"]);
}

TEST(Storm, StandsTheWorstWindOnEarth) {
    const json storm = stormOf({"--speed", "72", "--duration", "60", "--open"});
    EXPECT_TRUE(std::isfinite(storm["moment"]["max"].get<double>()));
    EXPECT_LT(storm["tip"]["max"].get<double>(), 40.0);
}

TEST(Storm, ACalmMovesNothing) {
    EXPECT_EQ(stormOf({"--speed", "0", "--duration", "10"})["moment"]["max"], 0.0);
}

TEST(Storm, RefusesWhatIsNoStorm) {
    EXPECT_EQ(runTool({"storm", "--speed", "-1"}).exitCode, 2);
    EXPECT_EQ(runTool({"storm", "--step", "0.5"}).exitCode, 2);
    EXPECT_EQ(runTool({"storm", "--spacing", "3", "--open"}).exitCode, 2);
    const Outcome outcome = runTool({"storm", "--duration", "1", "-o", "/nowhere/trace.csv"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("/nowhere/trace.csv: cannot be written"), std::string::npos) << outcome.err;
}

} // namespace

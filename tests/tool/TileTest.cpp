// SPDX-License-Identifier: MIT
#include <tests/FullTests.h>
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

const std::string wood = R"(version = 1
[wind]
kind = "gusts"
speed = 8.0
direction_from = 250.0
[scatter]
count = 400
area = [0, 0, 1000, 1000]
species = ["birch", "Norway spruce"]
height = [5, 20]
)";

TEST(Tile, MakesAWorldThatTheOtherCommandsRead) {
    const TemporaryFolder folder;
    const std::string file = folder.write("wood.treewind", wood), world = folder.path() + "/world";
    const Outcome cut = runTool({"tile", file, "-o", world, "--size", "250", "--json"});
    ASSERT_EQ(cut.exitCode, 0) << cut.err;
    EXPECT_NE(cut.out.find("\"trees\": 400"), std::string::npos) << cut.out;
    EXPECT_NE(cut.out.find("\"files\": 16"), std::string::npos) << cut.out;

    const std::string start = world + "/world.treewind";
    const Outcome valid = runTool({"validate", start});
    EXPECT_EQ(valid.out.rfind(start + ": good, 400 trees on ", 0), 0u) << valid.out << valid.err;
    const std::string whole = folder.path() + "/whole.csv", part = folder.path() + "/part.csv";
    ASSERT_EQ(runTool({"simulate", start, "--tiles", "1,2", "--duration", "0.1", "--fps", "10", "-o", part})
                  .exitCode,
              0);
    EXPECT_GT(contentOf(part).size(), 500u);
    ASSERT_EQ(runTool({"risk", start, "--tiles", "0,0,1,0", "-o", whole}).exitCode, 0);
    EXPECT_NE(contentOf(whole).find("\n1_0/"), std::string::npos);
    EXPECT_EQ(contentOf(whole).find("\n2_0/"), std::string::npos);
    const Outcome again = runTool({"tile", start, "-o", folder.path() + "/other"});
    EXPECT_EQ(again.exitCode, 2);
    EXPECT_EQ(again.err, start + ": the forest is already in tiles\n");
    EXPECT_FALSE(fs::exists(folder.path() + "/other"));
}

/// Rows by id, with cells by column.
std::map<std::string, std::map<std::string, std::string>> rowsById(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line, cell;
    std::vector<std::string> columns;
    std::map<std::string, std::map<std::string, std::string>> rows;
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; std::getline(cells, cell, ','); ++i)
            if (rows.empty() && columns.size() == i && line.rfind("id,", 0) == 0)
                columns.push_back(cell);
            else
                row[columns[i]] = cell;
        if (!row.empty())
            rows[row["id"]] = row;
    }
    return rows;
}

/// Trees on one side of a border shelter those on the other side, in every part of the world.
TEST(Tile, RiskOfPartsMatchesThatOfTheWholeWorld) {
    const TemporaryFolder folder;
    std::string stand = wood;
    stand.replace(stand.find("area ="), std::string("area = [0, 0, 1000, 1000]").size(),
                  "area = [0, 0, 120, 80]");
    stand.replace(stand.find("400"), 3, "100");
    const std::string world = folder.path() + "/world", start = world + "/world.treewind";
    ASSERT_EQ(runTool({"tile", folder.write("wood.treewind", stand), "-o", world, "--size", "20"}).exitCode,
              0);
    const auto risk = [&](const std::vector<std::string>& tiles) {
        std::vector<std::string> arguments = {"risk", start, "-o", folder.path() + "/risk.csv"};
        arguments.insert(arguments.end(), tiles.begin(), tiles.end());
        EXPECT_EQ(runTool(arguments).exitCode, 0);
        return rowsById(contentOf(folder.path() + "/risk.csv"));
    };
    const auto whole = risk({});
    auto parts = risk({"--tiles", "0,0,2,3"});
    EXPECT_LT(parts.size(), 75u);
    parts.merge(risk({"--tiles", "3,0,5,3"}));
    ASSERT_EQ(whole.size(), 100u);
    ASSERT_EQ(parts.size(), 100u);
    for (const auto& [id, row] : whole) {
        const double top = std::stod(row.at("top_wind"));
        EXPECT_NEAR(std::stod(parts[id]["top_wind"]) / top, 1.0, 0.02) << id;
        EXPECT_EQ(parts[id]["height_m"], row.at("height_m"));
    }
}

TEST(Tile, RefusesInvalidTiles) {
    const TemporaryFolder folder;
    const std::string file = folder.write("wood.treewind", wood);
    for (const char* tiles : {"1", "1,2,3", "3,0,1,0", "a,b", "1,2,3,4,5"})
        EXPECT_EQ(runTool({"risk", file, "--tiles", tiles, "-o", "risk.csv"}).exitCode, 2) << tiles;
    EXPECT_EQ(runTool({"tile", file, "-o", file}).exitCode, 1) << "the output folder is a file";
    EXPECT_EQ(runTool({"tile", file, "-o", folder.path() + "/w", "--size", "0"}).exitCode, 2);
}

TEST(Tile, AKilledRunLeavesTheOldWorldOrTheNewOne) {
    const TemporaryFolder folder;
    const std::string file = folder.write("wood.treewind", wood), world = folder.path() + "/world",
                      start = world + "/world.treewind";
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_EQ(runTool({"tile", file, "-o", world, "--size", "20"}).exitCode, 0);
    const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - begun;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> moment(0.0, taken.count());
    int unfinished = 0;
    for (int i = 0; i < casesToRun(50, 15); ++i) {
        const pid_t child = fork();
        if (child == 0) {
            if (!freopen("/dev/null", "w", stdout))
                _exit(127);
            execl(OSGTREEWIND_TOOL, OSGTREEWIND_TOOL, "tile", file.c_str(), "-o", world.c_str(), "--size",
                  "20", nullptr);
            _exit(127);
        }
        std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(moment(random)));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        unfinished += WIFSIGNALED(status);
        EXPECT_EQ(runTool({"validate", start}).exitCode, 0);
    }
    EXPECT_GT(unfinished, 0) << "no run was killed in time";
    ASSERT_EQ(runTool({"tile", file, "-o", world, "--size", "20"}).exitCode, 0);
    EXPECT_EQ(runTool({"validate", start}).exitCode, 0);
}

} // namespace

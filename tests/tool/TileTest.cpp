// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <random>
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

TEST(Tile, CutsWhatTheOtherCommandsRead) {
    const TemporaryFolder folder;
    const std::string file = folder.write("wood.treewind", wood), world = folder.path() + "/world";
    const Outcome cut = runTool({"tile", file, "-o", world, "--size", "250", "--json"});
    ASSERT_EQ(cut.exitCode, 0) << cut.err;
    EXPECT_NE(cut.out.find("\"trees\": 400"), std::string::npos) << cut.out;
    EXPECT_NE(cut.out.find("\"files\": 16"), std::string::npos) << cut.out;

    const std::string start = world + "/world.treewind";
    const Outcome valid = runTool({"validate", start});
    EXPECT_EQ(valid.out, start + ": good, 400 trees\n") << valid.err;
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
    EXPECT_EQ(again.err, start + ": its trees are in tiles already\n");
}

TEST(Tile, RefusesTilesThatAreNone) {
    const TemporaryFolder folder;
    const std::string file = folder.write("wood.treewind", wood);
    for (const char* tiles : {"1", "1,2,3", "3,0,1,0", "a,b", "1,2,3,4,5"})
        EXPECT_EQ(runTool({"risk", file, "--tiles", tiles, "-o", "risk.csv"}).exitCode, 2) << tiles;
    EXPECT_EQ(runTool({"tile", file, "-o", file}).exitCode, 1) << "a file where the folder is to be";
    EXPECT_EQ(runTool({"tile", file, "-o", folder.path() + "/w", "--size", "0"}).exitCode, 2);
}

/// Killed at any moment it leaves a whole world or none, and the next run makes one.
TEST(Tile, IsDoneWhollyOrNotAtAll) {
    const TemporaryFolder folder;
    const std::string file = folder.write("wood.treewind", wood), world = folder.path() + "/world",
                      start = world + "/world.treewind";
    std::mt19937 random(7);
    int unfinished = 0;
    for (int i = 0; i < 20; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            if (!freopen("/dev/null", "w", stdout))
                _exit(127);
            execl(OSGTREEWIND_TOOL, OSGTREEWIND_TOOL, "tile", file.c_str(), "-o", world.c_str(), "--size",
                  "20", nullptr);
            _exit(127);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 300000));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        if (fs::exists(start))
            EXPECT_EQ(runTool({"validate", start}).exitCode, 0);
        else
            ++unfinished;
    }
    EXPECT_GT(unfinished, 0) << "none was killed in time";
    ASSERT_EQ(runTool({"tile", file, "-o", world, "--size", "20"}).exitCode, 0);
    EXPECT_EQ(runTool({"validate", start}).exitCode, 0);
}

} // namespace

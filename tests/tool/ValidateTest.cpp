// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/tool/Tool.h>

TEST(Validate, ListsEveryProblemWithItsPlace) {
    const TemporaryFolder folder;
    folder.write("bad.treewind", R"(version = 1
sead = 3
[wind]
kind = "unifrom"
[[tree]]
position = [0, "a"]
height = -2
)");
    const Outcome outcome = runTool({"validate", "bad.treewind"}, folder.path());
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.out, "");
    std::size_t from = 0;
    for (const char* problem : {"bad.treewind:2:1: sead: ", "bad.treewind:4:8: wind.kind: ",
                                "bad.treewind:6:16: tree.position: ", "bad.treewind:7:10: tree.height: "}) {
        const std::size_t found = outcome.err.find(problem, from);
        ASSERT_NE(found, std::string::npos) << problem << "not in order in:\n" << outcome.err;
        from = found + 1;
    }
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 4);
}

TEST(Validate, OtherCommandsPrintTheSameProblems) {
    const TemporaryFolder folder;
    folder.write("bad.treewind", "version = 1\nsead = 3\nsaed = 4\n[[tree]]\nposition = [0, 0]\n");
    for (const std::string command : {"validate", "info", "render", "simulate"}) {
        const Outcome outcome = runTool({command, "bad.treewind"}, folder.path());
        EXPECT_EQ(outcome.exitCode, 2);
        EXPECT_EQ(outcome.err.rfind("bad.treewind:2:1: sead: ", 0), 0u) << outcome.err;
        EXPECT_NE(outcome.err.find("\nbad.treewind:3:1: saed: "), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
    }
}

TEST(Validate, AnIncompleteFileHasALine) {
    const TemporaryFolder folder;
    folder.write("cut.treewind", "version = 1\n[wind\n");
    const Outcome outcome = runTool({"validate", "cut.treewind"}, folder.path());
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.err.rfind("cut.treewind:2:", 0), 0u) << outcome.err;
}

TEST(Validate, AGoodFileIsCalledGood) {
    const Outcome outcome = runTool({"validate", example("forest.treewind")});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.out, example("forest.treewind") + ": good, 40 trees\n");
    EXPECT_EQ(outcome.err, "");
}

TEST(Validate, CampusIsGood) {
    REQUIRE_REAL_DATA(inventory, "utah_campus/utah_campus_trees.csv");
    const Outcome outcome = runTool({"validate", example("campus.treewind")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(": good, 1233 trees\n"), std::string::npos) << outcome.out;
}

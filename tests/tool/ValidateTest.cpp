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

TEST(Validate, ChecksACatalogueOfSpecies) {
    const TemporaryFolder folder;
    folder.write("species.treewind", "version = 1\n[[species]]\nname = \"hornbeam\"\nlike = \"beech\"\n");
    const Outcome good = runTool({"validate", "species.treewind"}, folder.path());
    EXPECT_EQ(good.exitCode, 0) << good.err;
    EXPECT_EQ(good.out, "species.treewind: good, 31 species with the built-in ones\n");
    folder.write("species.treewind", "version = 1\n[[species]]\nname = \"hornbeam\"\nlike = \"bench\"\n"
                                     "[[species]]\nname = 3\n");
    const Outcome bad = runTool({"validate", "species.treewind"}, folder.path());
    EXPECT_EQ(bad.exitCode, 2);
    EXPECT_NE(bad.err.find("species.treewind:4:8: species.like: "), std::string::npos) << bad.err;
    EXPECT_NE(bad.err.find("species.treewind:6:8: species.name: "), std::string::npos) << bad.err;
}

TEST(Validate, ListsAtMost100Problems) {
    const TemporaryFolder folder;
    std::string text = "version = 1\n[[tree]]\nposition = [0, 0]\n";
    for (int i = 0; i < 150; ++i)
        text += "key" + std::to_string(i) + " = 1\n";
    folder.write("bad.treewind", text);
    const Outcome outcome = runTool({"validate", "bad.treewind"}, folder.path());
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 100) << outcome.err;
}

TEST(Validate, CampusIsGood) {
    REQUIRE_REAL_DATA(inventory, "utah_campus/utah_campus_trees.csv");
    const Outcome outcome = runTool({"validate", example("campus.treewind")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(": good, 1233 trees\n"), std::string::npos) << outcome.out;
}

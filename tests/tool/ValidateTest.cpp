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
    EXPECT_EQ(outcome.out, example("forest.treewind") +
                               ": good, 40 trees on 62 m by 64 m, 8.1 to 15 m high, trunks of 22 to "
                               "53 cm, wind of 2.5 to 9.6 m/s at 10 m\n");
    EXPECT_EQ(outcome.err, "");
}

/// Trees of Hamburg in a record from the west; the place by `gdaltransform`.
TEST(Validate, SaysWhatStandsWhere) {
    const TemporaryFolder folder;
    folder.write("a.csv", "x,y,h,dbh_cm\n564995,5933904,12,20\n565021,5933915,30,45\n");
    folder.write("w.csv", "time,speed,direction\n0,2,270\n3600,8,270\n");
    folder.write("a.treewind",
                 "version = 1\ncrs = \"EPSG:25832\"\n[inventory]\nfile = \"a.csv\"\ncolumns = { x = "
                 "\"x\", y = \"y\", height = \"h\", trunk_diameter = \"dbh_cm\" }\n[wind]\nkind = "
                 "\"series\"\nfile = \"w.csv\"\ncolumns = { time = \"time\", speed = \"speed\", "
                 "direction_from = \"direction\" }\n");
    const Outcome outcome = runTool({"validate", "a.treewind"}, folder.path());
    EXPECT_NE(outcome.out.find(
                  "\na.treewind: good, 2 trees on 26 m by 11 m at 53.5500 N, 9.9812 E, 12 to 30 m high, "
                  "trunks of 20 to 45 cm, wind of 2 to 8 m/s at 10 m\n"),
              std::string::npos)
        << outcome.out << outcome.err;
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
    EXPECT_NE(outcome.out.find(": good, 1233 trees on 712 m by 572 m, "), std::string::npos) << outcome.out;
}

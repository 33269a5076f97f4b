// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

namespace {

/// Tall spruces in the west and low birches in the east, too far apart to shelter each other.
const std::string twoStands = R"(version = 1
[wind]
kind = "gusts"
speed = 38.0
direction_from = 265.0
canopy = "forest"
[[scatter]]
count = 40
area = [0, 0, 200, 40]
species = ["Norway spruce"]
height = [22, 28]
seed = 3
[[scatter]]
count = 40
area = [200, 0, 400, 40]
species = ["birch"]
height = [6, 9]
seed = 4
)";

/// A world of 400 m by 40 m, in tiles of 40 m.
class Merge : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(runTool({"tile", _folder.write("stands.treewind", twoStands), "-o", path("world"), "--size",
                           "40"})
                      .exitCode,
                  0);
    }
    std::string path(const std::string& name) const { return _folder.path() + '/' + name; }
    std::string world() const { return path("world/world.treewind"); }
    /// Runs a command for some tiles, or for all. @return the path of the table that it writes.
    std::string tableOf(std::vector<std::string> command, const std::string& name,
                        const std::string& tiles = "") const {
        command.insert(command.begin() + 1, {world(), "-o", path(name)});
        if (!tiles.empty())
            command.insert(command.end(), {"--tiles", tiles});
        const Outcome outcome = runTool(command);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return path(name);
    }
    const TemporaryFolder& folder() const { return _folder; }

private:
    TemporaryFolder _folder;
};

TEST_F(Merge, MergedRiskEqualsThatOfTheWholeWorld) {
    const std::vector<std::string> risk = {"risk", "--speed", "20"};
    const std::string whole = tableOf(risk, "whole.csv"), a = tableOf(risk, "a.csv", "0,0,1,0"),
                      b = tableOf(risk, "b.csv", "2,0,6,0"), c = tableOf(risk, "c.csv", "7,0,9,0");
    const Outcome merged = runTool({"merge", a, b, c, "-o", path("all.csv"), "--world", world()});
    ASSERT_EQ(merged.exitCode, 0) << merged.err;
    EXPECT_EQ(merged.out, "80 rows in " + path("all.csv") + '\n');
    EXPECT_EQ(contentOf(path("all.csv")), contentOf(whole));
}

/// Rows without the column `tree`, which each part counts from 0.
std::multimap<std::string, std::string> damages(const std::string& csv) {
    std::istringstream lines(csv);
    std::multimap<std::string, std::string> rows;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t tree = line.find(','), name = line.find(',', tree + 1);
        rows.emplace(line.substr(name), line.substr(0, tree));
    }
    return rows;
}

TEST_F(Merge, MergedDamageEqualsThatOfTheWholeWorld) {
    const std::vector<std::string> simulate = {"simulate", "--damage", "--duration", "60", "--fps", "10"};
    const std::string whole = tableOf(simulate, "whole.csv"), a = tableOf(simulate, "a.csv", "0,0,3,0"),
                      b = tableOf(simulate, "b.csv", "4,0,9,0");
    ASSERT_EQ(runTool({"merge", a, b, "-o", path("all.csv")}).exitCode, 0);
    const auto found = damages(contentOf(path("all.csv")));
    EXPECT_GT(found.size(), 20u) << "too little falls to tell";
    EXPECT_EQ(found, damages(contentOf(whole)));
    std::istringstream lines(contentOf(path("all.csv")));
    double last = 0.0;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        EXPECT_GE(std::stod(line), last);
        last = std::stod(line);
    }
}

TEST_F(Merge, RefusesPartsThatDoNotBelongTogether) {
    const std::string head = "id,species,uproot_ms\n", all = path("all.csv");
    const std::string a = folder().write("a.csv", head + "1,birch,20\n\"2,\"\"b\",birch,30\n"),
                      twice = folder().write("twice.csv", head + "3,birch,20\n\"2,\"\"b\",birch,30\n"),
                      other = folder().write("other.csv", "id,species,break_ms\n4,birch,20\n"),
                      none = folder().write("none.csv", "time,tree,unit\n0,0,0\n"),
                      empty = folder().write("empty.csv", head);
    const auto refusal = [&](const std::vector<std::string>& parts) {
        std::vector<std::string> words = {"merge", "-o", all};
        words.insert(words.end(), parts.begin(), parts.end());
        const Outcome outcome = runTool(words);
        EXPECT_EQ(outcome.exitCode, 2);
        EXPECT_FALSE(std::filesystem::exists(all));
        return outcome.err;
    };
    EXPECT_EQ(refusal({a, twice}),
              twice +
                  ":3: the tree 2,\"b already has a row; give each part once, without overlapping --tiles\n");
    EXPECT_EQ(refusal({a, other}),
              other + ":1: expected the columns of the first part, id,species,uproot_ms\n");
    EXPECT_EQ(refusal({none}), none +
                                   ":1: expected a table of risk or of simulate --damage, found the columns "
                                   "time,tree,unit\n");
    EXPECT_EQ(refusal({a, path("gone.csv")}), path("gone.csv") + ": no such file\n");
    EXPECT_EQ(refusal({a, empty, "--world", world()}),
              world() + ": expected a row for each of its 80 trees, found 2\n");
    EXPECT_EQ(
        refusal({a, "--world", folder().path() + "/stands.treewind"}),
        folder().path() +
            "/stands.treewind: expected a world (made by osgtreewind tile), found a forest without tiles\n");
    EXPECT_EQ(runTool({"merge", a, empty, "-o", all}).exitCode, 0);
    EXPECT_EQ(contentOf(all), contentOf(a)) << "with the same quotes";
    EXPECT_EQ(runTool({"merge", a, "-o", folder().path()}).exitCode, 2);
}

} // namespace

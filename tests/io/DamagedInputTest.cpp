// SPDX-License-Identifier: MIT
#include <tests/Folders.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/io/ForestFile.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace osgTreeWind {

namespace {

std::string readAll(const std::string& name) {
    std::ifstream file(OSGTREEWIND_SOURCE_DIR "/examples/" + name + ".treewind", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Expects a valid forest or problems with messages.
void expectForestOrProblems(const std::string& text) {
    std::istringstream input(text);
    const auto result = readForest(input, {"damaged", OSGTREEWIND_SOURCE_DIR "/examples"});
    if (!result.ok()) {
        ASSERT_FALSE(result.problems().empty());
        for (const Diagnostic& problem : result.problems()) {
            EXPECT_FALSE(problem.message.empty());
            EXPECT_FALSE(problem.file.empty()) << problem.message;
        }
        return;
    }
    ASSERT_FALSE(result.value().species.empty());
    EXPECT_FALSE(result.value().trees.empty());
    for (const TreePlacement& tree : result.value().trees) {
        EXPECT_LT(tree.species, result.value().species.size());
        EXPECT_TRUE(std::isfinite(tree.position.x + tree.position.y + tree.position.z + tree.size.height +
                                  tree.size.trunkDiameter + tree.size.crownWidth + tree.heading));
    }
}

class DamagedInputTest : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(DamagedInputTest, SurvivesTruncation) {
    const std::string text = readAll(GetParam());
    ASSERT_FALSE(text.empty());
    for (std::size_t length = 0; length < text.size(); length += 7)
        expectForestOrProblems(text.substr(0, length));
}

TEST_P(DamagedInputTest, SurvivesChangedBytes) {
    const std::string text = readAll(GetParam());
    ASSERT_FALSE(text.empty());
    Random random(2);
    for (int trial = 0; trial < 600; ++trial) {
        std::string damaged = text;
        for (std::uint64_t changes = 1 + random.next() % 4; changes > 0; --changes) {
            const std::size_t at = random.next() % damaged.size();
            switch (random.next() % 4) {
            case 0:
                damaged[at] = static_cast<char>(random.next());
                break;
            case 1:
                damaged.erase(at, random.next() % 9);
                break;
            case 2: // a digit more, a bracket less
                damaged.insert(at, 1, "0123456789.-+eE[]{}\"'=\n#,"[random.next() % 25]);
                break;
            default:
                damaged.insert(at, damaged.substr(random.next() % damaged.size(), random.next() % 40));
            }
        }
        expectForestOrProblems(damaged);
    }
}

TEST(DamagedInput, RejectsDeepNesting) {
    for (const char* open : {"[", "{a=", "[{a="}) {
        std::string text = "version = 1\na = ";
        for (int i = 0; i < 100000; ++i)
            text += open;
        expectForestOrProblems(text);
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, DamagedInputTest, testing::Values("thesis", "forest", "campus"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/FullTests.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/Toml.h>

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
void expectForestOrProblems(const std::string& text,
                            const std::string& folder = OSGTREEWIND_SOURCE_DIR "/examples") {
    std::istringstream input(text);
    const auto result = readForest(input, {"damaged", folder});
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

/// Calls a function with the first byte and the end of each value of a document.
template <typename Function>
void forEachValue(const std::string& text, const toml::node& node, const Function& function) {
    const toml::table* const table = node.as_table();
    const toml::array* const array = node.as_array();
    if (table)
        for (const auto& [key, value] : *table)
            forEachValue(text, value, function);
    if (array)
        for (const toml::node& element : *array)
            forEachValue(text, element, function);
    const bool hasHeader = table ? !table->is_inline() : array && array->is_array_of_tables();
    if (!hasHeader)
        function(offsetOf(text, node.source().begin), offsetOf(text, node.source().end));
}

class DamagedInputTest : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(DamagedInputTest, SurvivesTruncation) {
    const std::string text = readAll(GetParam());
    ASSERT_FALSE(text.empty());
    for (std::size_t length = 0; length < text.size(); length += 7)
        expectForestOrProblems(text.substr(0, length));
}

TEST(DamagedInput, RejectsDeepNesting) {
    for (const char* open : {"[", "{a=", "[{a="}) {
        std::string text = "version = 1\na = ";
        for (int i = 0; i < 100000; ++i)
            text += open;
        expectForestOrProblems(text);
    }
}

TEST(DamagedInput, SurvivesValuesOfOtherTypes) {
    const TemporaryFolder folder;
    folder.write("trees.csv", "id,x,y,z,name,h,d,c,w\n1,2,3,4,oak,12,30,95,5\n2,9,8,1,elm,9,20,60,4\n");
    folder.write("wind.csv", "t,s,d\n0,4,270\n60,6,280\n");
    folder.write("ground.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 20\n1 2\n3 4\n");
    const char* const documents[] = {R"(
version = 1
[[inventory]]
file = "trees.csv"
default_species = "beech"
filter = "h > 1"
skip = true
columns = { id = "id", x = "x", y = "y", z = "z", species = "name", height = "h", trunk_diameter = "d", crown_width = "w" }
units = { trunk_diameter = "cm" }
)",
                                     R"(
version = 1
crs = "EPSG:25832"
[[inventory]]
file = "trees.csv"
crs = "EPSG:25833"
columns = { x = "x", y = "y", circumference = "c" }
units = { circumference = "cm" }
)",
                                     R"(
version = 1
[[tree]]
position = [0, 0]
species = "oak"
[wind]
kind = "series"
file = "wind.csv"
height = 10
roughness = 0.1
repeat = true
columns = { time = "t", speed = "s", direction_from = "d" }
)",
                                     R"(
version = 1
[ground]
file = "ground.asc"
[[scatter]]
species = ["oak"]
count = 5
area = [0, 0, 30, 30]
height = [5, 9]
)"};
    std::vector<std::string> texts(std::begin(documents), std::end(documents));
    const char* const examples[] = {"thesis", "lorry", "helicopter", "explosion"};
    for (int i = 0; i < casesToRun(4, 1); ++i)
        texts.push_back(readAll(examples[i]));
    const char* const others[] = {"true", "3",     "-1",    "1e300", "nan",       "\"t\"",
                                  "[]",   "[1.5]", "[[3]]", "{}",    "{ t = 1 }", "2024-11-05"};
    for (const std::string& text : texts) {
        std::istringstream input(text);
        const auto forest = readForest(input, {"whole", folder.path()});
        for (const Diagnostic& problem : forest.problems())
            ADD_FAILURE() << problem.text();
        const Result<toml::table> document = parseToml(text);
        ASSERT_TRUE(document.ok());
        int count = 0;
        forEachValue(text, document.value(), [&](std::size_t begin, std::size_t end) {
            SCOPED_TRACE(text.substr(begin, end - begin));
            for (const char* const other : others)
                expectForestOrProblems(text.substr(0, begin) + other + text.substr(end), folder.path());
            ++count;
        });
        EXPECT_GE(count, 7);
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, DamagedInputTest, testing::Values("thesis", "forest", "campus"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace osgTreeWind

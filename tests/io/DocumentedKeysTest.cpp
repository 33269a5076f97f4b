// SPDX-License-Identifier: MIT
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/ForestSections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <sstream>

namespace osgTreeWind {

namespace {

std::string manual() {
    std::ifstream file(OSGTREEWIND_SOURCE_DIR "/docs/treewind.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The ```toml blocks of the manual.
std::vector<std::string> examplesOf(const std::string& text) {
    const std::string open = "```toml\n", close = "```\n";
    std::vector<std::string> examples;
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        at += open.size();
        const std::size_t end = text.find(close, at);
        examples.push_back(text.substr(at, end - at));
        at = end + close.size();
    }
    return examples;
}

bool needsFile(const std::string& example) {
    return example.rfind("# needs a file", 0) == 0;
}

/// Every key that the reader asks for anywhere.
std::set<std::string> knownKeys() {
    const TemporaryFolder folder;
    folder.write("a.csv", "t\n1\n");
    const std::string everySection =
        "version = 1\n[motion]\n[drawing]\n[[tree]]\n[scatter]\nheight = 1\n[inventory]\nfile = "
        "\"a.csv\"\n[inventory.columns]\n"
        "[inventory.units]\n[[species]]\n[species.tree]\n[species.growth]\n[species.growth.boughs]\n"
        "[species.growth.branches]\n[species.growth.twigs]\n[species.leaves]\n[species.crown]\n[species.wood]"
        "\n[species."
        "branch]\n"
        "[species.leaf]\n[species.appearance]\n[wind]\n";
    std::set<std::string> keys;
    for (const char* wind :
         {"kind = \"calm\"", "kind = \"uniform\"", "kind = \"gusts\"\nheight = 1", "kind = \"file\"",
          "kind = \"grid\"\nvalues = [0]", "kind = \"grid\"\nfile = \"a.csv\"",
          "kind = \"forest_wind\"\nvalues = [0]", "kind = \"series\"\nheight = 1",
          "kind = \"series\"\nfile = \"a.csv\"\n[wind.columns]"}) {
        ForestReading reading;
        reading.folders = {folder.path()};
        TableReader::readDocument(everySection + wind, reading.log,
                                  [&](TableReader& root) { readRoot(root, reading); });
        keys.insert(reading.log.keys.begin(), reading.log.keys.end());
    }
    return keys;
}

/// The cells of a row of a Markdown table.
std::vector<std::string> cellsOf(const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream parts(row.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(" `"), last = cell.find_last_not_of(" `");
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return cells;
}

/// Structs of 4-byte numbers alike, but for the rounding of the manual's angles.
template <typename Parameters>
bool alike(const Parameters& a, const Parameters& b) {
    float left[sizeof(Parameters) / sizeof(float)], right[sizeof(Parameters) / sizeof(float)];
    std::memcpy(left, &a, sizeof a);
    std::memcpy(right, &b, sizeof b);
    return std::equal(std::begin(left), std::end(left), right,
                      [](float x, float y) { return std::abs(x - y) <= 0.005f * std::abs(x); });
}

} // namespace

TEST(DocumentedKeys, DefaultsOfASpeciesAreTrue) {
    const Species usual;
    const GrownTreeParameters grown;
    int checked = 0;
    std::istringstream lines(manual());
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| `species.", 0) != 0)
            continue;
        const std::vector<std::string> cells = cellsOf(line);
        if (cells[0].find(',') != std::string::npos || cells[3].empty() ||
            std::string("0123456789-").find(cells[3][0]) == std::string::npos)
            continue;
        const std::size_t dot = cells[0].rfind('.');
        std::istringstream document("version = 1\n[[tree]]\nposition = [0, 0]\n[[species]]\nname = \"a\"\n" +
                                    (dot == 7 ? "" : '[' + cells[0].substr(0, dot) + "]\n") +
                                    cells[0].substr(dot + 1) + " = " + cells[3] + '\n');
        const auto forest = readForest(document);
        ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
        const Species& species = forest.value().species.front();
        EXPECT_TRUE(alike(species.tree.wood, usual.tree.wood) &&
                    alike(species.tree.grown.value_or(grown), grown) &&
                    (species.tree.grown || alike(species.tree.leaves, usual.tree.leaves)) &&
                    alike(species.crown, usual.crown) && alike(species.wood, usual.wood) &&
                    alike(species.branch, usual.branch) && alike(species.leaf, usual.leaf) &&
                    species.shapes == usual.shapes)
            << line;
        ++checked;
    }
    EXPECT_GT(checked, 30);
}

TEST(DocumentedKeys, DefaultsOfDrawingAreTrue) {
    const DrawingOptions usual;
    int checked = 0;
    std::istringstream lines(manual());
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| `drawing.", 0) != 0)
            continue;
        const std::vector<std::string> cells = cellsOf(line);
        std::istringstream document("version = 1\n[[tree]]\nposition = [0, 0]\n[drawing]\n" +
                                    cells[0].substr(8) + " = " + cells[3] + '\n');
        const auto forest = readForest(document);
        ASSERT_TRUE(forest.ok()) << forest.problems().front().text();
        const DrawingOptions& drawing = forest.value().drawing;
        EXPECT_TRUE(drawing.tiers == usual.tiers && drawing.full == usual.full &&
                    drawing.reduced == usual.reduced && drawing.impostor == usual.impostor &&
                    drawing.blend == usual.blend)
            << line;
        ++checked;
    }
    EXPECT_EQ(checked, 5);
}

TEST(DocumentedKeys, EveryKeyOfTheReaderIsInTheManual) {
    const std::string text = manual();
    const std::set<std::string> keys = knownKeys();
    EXPECT_GT(keys.size(), 100u);
    for (const std::string& key : keys)
        EXPECT_NE(text.find('`' + key + '`'), std::string::npos) << key << " is not documented";
}

TEST(DocumentedKeys, EveryKeyOfTheManualIsRead) {
    const std::set<std::string> keys = knownKeys();
    std::istringstream lines(manual());
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| `", 0) != 0)
            continue;
        const std::string cell = line.substr(0, line.find('|', 2));
        for (std::size_t at = cell.find('`'); at != std::string::npos; at = cell.find('`', at + 1)) {
            const std::size_t end = cell.find('`', at + 1);
            const std::string key = cell.substr(at + 1, end - at - 1);
            EXPECT_TRUE(keys.count(key)) << key << " is documented but not read";
            at = end;
        }
    }
}

TEST(DocumentedKeys, EveryExampleOfTheManualIsRead) {
    const std::vector<std::string> examples = examplesOf(manual());
    EXPECT_GT(examples.size(), 8u);
    for (const std::string& example : examples) {
        std::istringstream input(example);
        const auto result = readForest(input, {"treewind.md", "/nowhere"});
        if (result.ok())
            continue;
        for (const Diagnostic& problem : result.problems())
            EXPECT_TRUE(needsFile(example) && problem.message.find("no file") == 0)
                << problem.text() << " in\n"
                << example;
    }
}

} // namespace osgTreeWind

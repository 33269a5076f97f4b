// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/scanfiles/ScanProblem.h>

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

namespace osgTreeWind {

namespace {

const std::string folder = OSGTREEWIND_TEST_DATA "/scan/";

/// The same sapling in each format: 8 cylinders, 2 m high, foot at (100.5, 200.25, 3).
struct FormatCase {
    const char* file;
    const char* format;
    std::size_t trees;
};

const FormatCase formats[] = {{"treeqsm.txt", "TreeQSM", 1},
                              {"treeqsm_plain.txt", "TreeQSM", 1},
                              {"simpleforest.csv", "SimpleForest", 1},
                              {"archi.csv", "aRchi", 1},
                              {"rtwig.txt", "rTwig", 1},
                              {"rtwig_treeqsm.csv", "rTwig", 1},
                              {"raycloud.txt", "RayCloudTools", 2},
                              {"sapling.swc", "SWC", 1}};

void PrintTo(const FormatCase& format, std::ostream* out) {
    *out << format.file;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// @param cases texts and their problems.
void expectProblems(std::initializer_list<std::pair<std::string, std::string>> cases) {
    for (const auto& [text, problem] : cases)
        EXPECT_EQ(problemOfScanText(text), problem) << text;
}

double volumeOf(const ScanCylinders& tree) {
    double volume = 0.0;
    for (const ScanCylinder& c : tree)
        volume += 3.14159265 * c.radius * c.radius * glm::distance(c.start, c.end);
    return volume;
}

/// Expects valid trees that can be converted, or one problem with a message.
void expectTreesOrProblem(const std::string& text, const std::string& what) {
    const auto scan = readScan(text, "damaged");
    if (!scan) {
        ASSERT_EQ(scan.problems().size(), 1u) << what;
        EXPECT_FALSE(scan.problems().front().message.empty()) << what;
        EXPECT_EQ(scan.problems().front().file, "damaged") << what;
        return;
    }
    ASSERT_FALSE(scan.value().trees.empty()) << what;
    for (const ScanCylinders& cylinders : scan.value().trees) {
        const auto tree = makeScannedTree(cylinders);
        ASSERT_TRUE(tree) << what << ": " << firstProblem(tree);
        for (const glm::vec3& point : tree.value().skeleton.points)
            ASSERT_TRUE(std::isfinite(point.x + point.y + point.z)) << what;
    }
}

} // namespace

class ScanFormat : public testing::TestWithParam<FormatCase> {};

TEST_P(ScanFormat, IsRecognisedAndReadCompletely) {
    const auto scan = readScanFile(folder + GetParam().file);
    ASSERT_TRUE(scan) << firstProblem(scan);
    EXPECT_EQ(scan.value().format, GetParam().format);
    ASSERT_EQ(scan.value().trees.size(), GetParam().trees);
    for (const ScanCylinders& tree : scan.value().trees)
        EXPECT_EQ(tree.size(), 8u);
}

TEST_P(ScanFormat, GivesTheSameTreeAsOtherFormats) {
    const auto scan = readScanFile(folder + GetParam().file);
    ASSERT_TRUE(scan) << firstProblem(scan);
    for (const ScanCylinders& tree : scan.value().trees) {
        EXPECT_NEAR(volumeOf(tree), 0.00409933, 1e-7);
        const auto made = makeScannedTree(tree);
        ASSERT_TRUE(made);
        const ScanReport& report = made.value().report;
        EXPECT_EQ(report.cylinders, 8u);
        EXPECT_NEAR(report.height, 2.0, 1e-5);
        EXPECT_EQ(made.value().skeleton.units.front().base, glm::vec3(0.0f));
        float east = 0.0f;
        for (const BranchUnit& unit : made.value().skeleton.units)
            east = std::max(east, unit.tip.x);
        EXPECT_NEAR(east, 0.7f, 1e-5f);
    }
}

TEST_P(ScanFormat, TruncatedFilesAreReadCompletelyOrRefused) {
    const std::string whole = bytesOf(folder + GetParam().file);
    ASSERT_FALSE(whole.empty());
    for (std::size_t length = 0; length < whole.size(); ++length)
        expectTreesOrProblem(whole.substr(0, length), "cut at " + std::to_string(length));
}

TEST_P(ScanFormat, AcceptsWindowsLineEndsAndAByteOrderMark) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : bytesOf(folder + GetParam().file))
        text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const TemporaryFolder temporary;
    const auto scan = readScanFile(temporary.write("scan.txt", text));
    ASSERT_TRUE(scan) << firstProblem(scan);
    EXPECT_EQ(scan.value().trees.front().size(), 8u);
}

INSTANTIATE_TEST_SUITE_P(Saplings, ScanFormat, testing::ValuesIn(formats), [](const auto& info) {
    std::string name = info.param.file;
    name[name.find('.')] = '_';
    return name;
});

TEST(ScanFile, TreesKeepTheirPositions) {
    const auto scan = readScanFile(folder + "raycloud.txt");
    ASSERT_TRUE(scan) << firstProblem(scan);
    EXPECT_EQ(scan.value().trees[0].front().start, glm::dvec3(100.5, 200.25, 3.0));
    EXPECT_EQ(scan.value().trees[1].front().start, glm::dvec3(105.5, 200.25, 3.0));
}

TEST(ScanFile, ReadsTreeValuesAndAShorterFirstSegment) {
    const auto scan = readScan("height,dbh, x,y,z,radius x,y,z,radius,parent_id,volume\n"
                               "2,0.1, 0,0,0,0.05, 0,0,1,0.05,0,0.1, 0,0,2,0.04,1,0.1\n",
                               "a");
    ASSERT_TRUE(scan) << firstProblem(scan);
    ASSERT_EQ(scan.value().trees.front().size(), 2u);
    EXPECT_EQ(scan.value().trees.front()[1].end, glm::dvec3(0, 0, 2));
    EXPECT_EQ(scan.value().trees.front()[1].parent, 0);
}

TEST(ScanFile, ThickestStemOfARootBecomesTheTrunk) {
    const auto scan = readScan("1 1 0 0 0 0.1 -1\n2 3 0.2 0 1 0.05 1\n3 3 -0.1 0 2 0.08 1\n", "a");
    ASSERT_TRUE(scan) << firstProblem(scan);
    const ScanCylinders& tree = scan.value().trees.front();
    EXPECT_EQ(tree[1].parent, -1);
    EXPECT_EQ(tree[0].parent, 1);
}

TEST(BrokenScan, TreeQsmGivesOneErrorWithItsPlace) {
    const std::string row = "0.1 1 0 0 0 0 0 1 0 2 0 0.1 1 0 1\n",
                      next = "0.1 1 0 0 1 0 0 1 1 0 0 0.1 1 0 2\n";
    expectProblems(
        {{row + next, ""},
         {row + replaced(next, "0.1 1 0", "0 1 0"),
          "a:2:1: expected a radius above 0 and of at most 10 m, found '0'"},
         {row + replaced(next, "0.1 1 0", "-0.1 1 0"),
          "a:2:1: expected a radius above 0 and of at most 10 m, found '-0.1'"},
         {row + replaced(next, "0.1 1 0", "0.1 0 0"),
          "a:2:5: expected a length above 0 and of at most 200 m, found '0'"},
         {row + replaced(next, "0 0 1 0", "0 oak 1 0"), "a:2:9: expected metres within 1e9, found 'oak'"},
         {row + replaced(next, "0 0 1 0", "0 nan 1 0"), "a:2:9: expected metres within 1e9, found 'nan'"},
         {row + replaced(next, "0 0 1 0", "0 1e999 1 0"), "a:2:9: expected metres within 1e9, found '1e999'"},
         {row + replaced(next, "0 0 1 1", "0 0 0.5 1"),
          "a:2:13: expected a unit vector, found one of length 0.5"},
         {row + replaced(next, " 1 0 0 0.1", " 7 0 0 0.1"),
          "a:2: expected a parent of the same tree, found 7"},
         {row + replaced(next, " 1 0 0 0.1", " 1.5 0 0 0.1"),
          "a:2:19: expected the number of the parent cylinder, or 0, found '1.5'"},
         {row + replaced(next, " 1 0 0 0.1", " 0 0 0 0.1"),
          "a:2: expected one root, found a second one besides line 1; branches without a parent have 50 % of "
          "the wood, and at most 5 % can be joined to the nearest cylinder"},
         {row + replaced(next, " 1 0 0 0.1", " 2 0 0 0.1"),
          "a:2: expected parents that lead to the root, found a loop"},
         {replaced(row, "1 0 2", "1 2 2") + next, "a: expected a root: a cylinder without a parent"},
         {row + "0.1 1 0 0 1 0 0 1 1\n", "a:2: expected 15 or 17 columns, the same in all lines, found 9"},
         {"radius length start axis parent\n", "a: expected at least one cylinder"},
         {replaced(row, "0.1 1 0", "0.1 160 0"),
          "a:1: expected a tree of 0.1 to 150 m above its foot, in metres, found 160"},
         {replaced(row, "0 0 1 0 2", "0 0 -1 0 2"),
          "a:1: expected a tree of 0.1 to 150 m above its foot, in metres, found 0"}});
}

TEST(BrokenScan, SimpleForestGivesOneErrorWithItsPlace) {
    const std::string head = " ID, parentID, startX, startY, startZ, endX, endY, endZ, radius\n",
                      row = "0,-1,0,0,0,0,0,1,0.1\n";
    expectProblems(
        {{head + row, ""},
         {head, "a: expected at least one cylinder"},
         {head + "0,-1,0,0,0,0,0,0,0.1\n", "a:2: expected a cylinder of at least a micrometre"},
         {head + "0,-1,0,0,0,0,tall,1,0.1\n", "a:2: endY: expected metres within 1e9, found 'tall'"},
         {head + row + row, "a:3: expected unique ids, found 0 again"},
         {head + row + "1,4,0,0,1,0,0,2,0.1\n", "a:3: expected a parent of the same tree, found 4"},
         {head + row + "1,0,0,0,1,0,0\n", "a:3: expected 9 cells as in the header, found 7"},
         {replaced(head, "radius", "width") + row, "a:1: expected a column with one of the names radius, "
                                                   "radius_cyl, node_radius, rad, r; found ID, parentID, "
                                                   "startX, startY, startZ, endX, endY, endZ, width"}});
}

TEST(BrokenScan, RayCloudToolsGivesOneErrorWithItsPlace) {
    const std::string head = "# a\nx,y,z,radius,parent_id\n";
    expectProblems(
        {{head + "0,0,0,0.1,-1, 0,0,1,0.1,0\n", ""},
         {head, "a:2: expected at least one tree after the header"},
         {head + "0,0,0,0.1,-1, 0,0,1,0.1\n",
          "a:3: expected 5 values and then 5 for each further segment, found 9"},
         {head + "0,0,0,0.1,-1, 0,0,1,none,0\n",
          "a:3:21: expected a radius above 0 and of at most 10 m, found 'none'"},
         {head + "0,0,0,0.1,-1, 0,0,1,0.1,-1\n",
          "a:3:25: expected the index of a segment in its line, from 0, found '-1'"},
         {head + "0,0,0,0.1,-1, 0,0,1,0.1,5\n", "a:3: expected a parent of the same tree, found 5"}});
}

TEST(BrokenScan, SwcGivesOneErrorWithItsPlace) {
    const std::string root = "# a\n1 1 0 0 0 0.1 -1\n";
    expectProblems(
        {{root + "2 3 0 0 1 0.1 1\n", ""},
         {root, "a:2: expected more than one point"},
         {root + "2 3 0 0 1 0.1 1\n3 3 1 0 0 0.1 -1\n4 3 1 0 1 0.1 3\n",
          "a:5: expected one root, found a second one besides line 3; branches without a parent "
          "have 50 % of the wood, and at most 5 % can be joined to the nearest cylinder"},
         {root + "2 3 0 0 1 0.1\n",
          "a:3: expected 7 numbers: id, type, x, y, z, radius, parent; found 6 words"},
         {root + "2 3 0 0 1 0.1 3\n3 3 0 0 2 0.1 2\n", "a: expected a root: a cylinder without a parent"},
         {root + "2 3 0 0 1 0.1 1\n3 3 0 0 2 0.1 4\n4 3 0 0 3 0.1 3\n",
          "a:4: expected parents that lead to the root, found a loop"}});
}

TEST(BrokenScan, UnknownFormatListsTheKnownOnes) {
    expectProblems(
        {{"\n# only this\n", "a: expected a scanned tree, found only blank lines and comments"},
         {"hello\n", "a: expected a scanned tree: TreeQSM's cylinders as text or .mat, a table of cylinders "
                     "or points with named columns, a tree file of RayCloudTools, or SWC"}});
    const TemporaryFolder temporary;
    const std::string empty = temporary.write("empty.txt", "");
    EXPECT_EQ(firstProblem(readScanFile(empty)), empty + ": the file is empty");
    EXPECT_EQ(firstProblem(readScanFile("/no/such.txt")), "/no/such.txt: no such file");
    EXPECT_NE(firstProblem(readScanFile(temporary.path())), "");
    EXPECT_NE(firstProblem(readScanFile(temporary.write("a.bin", std::string("1 2\0", 4)))).find("binary"),
              std::string::npos);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/scanfiles/ScanProblem.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

/// A table with column names and a row per cylinder, whose commas are replaced by `delimiter`.
std::string table(const std::string& names, const std::vector<std::string>& rows, char delimiter = ',') {
    std::string text = names + '\n';
    for (const std::string& row : rows)
        text += row + '\n';
    for (char& c : text)
        if (c == ',')
            c = delimiter;
    return text;
}

const std::string archi = "startX,startY,startZ,endX,endY,endZ,cyl_ID,parent_ID,radius_cyl",
                  rtwig = "start_x,start_y,start_z,axis_x,axis_y,axis_z,id,parent,radius,length",
                  treeQsm = "radius,start.x,start.y,start.z,axis.x,axis.y,axis.z,length,extension,parent";
const std::vector<std::string> archiRows = {"0,0,0,0,0,1,1,0,0.1", "0,0,1,0,0.5,2,2,1,0.05"},
                               rtwigRows = {"0,0,0,0,0,1,1,0,0.1,1", "0,0,1,0,0.6,0.8,2,1,0.05,0.5"};

ScanFile read(const std::string& text) {
    Result<ScanFile> scan = readScan(text, "a");
    EXPECT_TRUE(scan) << firstProblem(scan) << " in\n" << text;
    return std::move(scan.value());
}

std::vector<int> parentsOf(const ScanFile& scan) {
    std::vector<int> parents;
    for (const ScanCylinder& cylinder : scan.trees.front())
        parents.push_back(cylinder.parent);
    return parents;
}

} // namespace

TEST(ScanTable, FindsColumnsInAnyCaseAndOrder) {
    EXPECT_EQ(read(table(archi, archiRows)).format, "aRchi");
    EXPECT_EQ(read(table(rtwig, rtwigRows)).format, "rTwig");
    EXPECT_EQ(read(table("RADIUS,Parent_Id,cyl_id,ENDZ,ENDY,ENDX,note,STARTZ,STARTY,STARTX",
                         {"0.1,0,1,1,0,0,a,0,0,0"}))
                  .format,
              "table");
}

TEST(ScanTable, ReadsCommasSemicolonsTabsAndBlanks) {
    for (const char delimiter : {',', ';', '\t', ' '}) {
        const ScanFile scan = read(table(archi, archiRows, delimiter));
        ASSERT_EQ(scan.trees.front().size(), 2u);
        EXPECT_EQ(scan.trees.front()[1].end, glm::dvec3(0, 0.5, 2));
        EXPECT_EQ(scan.trees.front()[1].line, 3);
    }
    EXPECT_EQ(read("  cyl_ID  parent_ID startX startY startZ endX endY   endZ radius_cyl \r\n"
                   "1   0  0 0 0   0 0 1  0.1  \r\n")
                  .trees.front()
                  .size(),
              1u);
}

TEST(ScanTable, ComputesTheEndFromAxisAndLength) {
    const ScanCylinders tree = read(table(rtwig, rtwigRows)).trees.front();
    EXPECT_NEAR(glm::distance(tree[1].end, {0, 0.3, 1.4}), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(tree[1].start, tree[1].end), 0.5, 1e-12);
}

TEST(ScanTable, RecognisesTheParentOfTheRoot) {
    for (const char* none : {"0", "-1", "NA", "na", ""})
        EXPECT_EQ(
            parentsOf(read(table(archi, {"0,0,0,0,0,1,1," + std::string(none) + ",0.1", archiRows[1]}))),
            (std::vector<int>{-1, 0}))
            << none;
    EXPECT_EQ(parentsOf(read(table(archi, {"0,0,1,0,0,2,7,0,0.1", "0,0,0,0,0,1,0,-1,0.1"}))),
              (std::vector<int>{1, -1}))
        << "0 is the id of a cylinder";
}

/// TreeQSM's extension is the next cylinder of a branch, 0 at its end. rTwig's update_cylinders() replaces it
/// by the id.
TEST(ScanTable, ExtensionsWithoutAZeroAreIds) {
    const auto parents = [](const char* first, const char* second, const char* third) {
        return parentsOf(read(table(treeQsm, {"0.1,0,0,0,0,0,1,1," + std::string(first),
                                              "0.1,0,0,1,0,0,1,1," + std::string(second),
                                              "0.1,0,0,1,0,1,0,1," + std::string(third)})));
    };
    EXPECT_EQ(parents("2,0", "0,1", "0,2"), (std::vector<int>{-1, 0, 1}));
    EXPECT_EQ(parents("1,0", "5,1", "3,5"), (std::vector<int>{-1, 0, 1}));
}

TEST(ScanTable, RealTreeIsTheSameAsATable) {
    REQUIRE_REAL_DATA(path, "qsm/Tree_1_TreeQSM.txt");
    const auto real = readScanFile(path);
    ASSERT_TRUE(real) << firstProblem(real);
    const ScanCylinders& tree = real.value().trees.front();
    std::string ends = archi + '\n', axes = rtwig + '\n';
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const auto cells = [](const glm::dvec3& v) {
            return numberText(v.x) + ',' + numberText(v.y) + ',' + numberText(v.z) + ',';
        };
        const double length = glm::distance(tree[i].start, tree[i].end);
        const std::string names = std::to_string(i + 1) + ',' + std::to_string(tree[i].parent + 1) + ',' +
                                  numberText(tree[i].radius);
        ends += cells(tree[i].start) + cells(tree[i].end) + names + '\n';
        axes += cells(tree[i].start) + cells((tree[i].end - tree[i].start) / length) + names + ',' +
                numberText(length) + '\n';
    }
    for (const std::string& text : {ends, axes}) {
        const ScanCylinders same = read(text).trees.front();
        ASSERT_EQ(same.size(), tree.size());
        for (std::size_t i = 0; i < tree.size(); ++i) {
            EXPECT_EQ(same[i].parent, tree[i].parent) << i;
            EXPECT_EQ(same[i].radius, tree[i].radius) << i;
            EXPECT_EQ(same[i].start, tree[i].start) << i;
            EXPECT_NEAR(glm::distance(same[i].end, tree[i].end), 0.0, 1e-9) << i;
        }
    }
}

TEST(BrokenScanTable, ErrorListsTheNamesOfAMissingColumn) {
    const auto without = [](std::string names, const std::string& name) {
        return problemOfScanText(table(names.replace(names.find(name), name.size(), "other"), {}));
    };
    EXPECT_EQ(without(archi, "radius_cyl"), "a:1: radius_cyl: expected a column of this name");
    EXPECT_EQ(without(archi, "endY"), "a:1: endY: expected a column of this name");
    EXPECT_EQ(without(rtwig, "parent"), "a:1: parentID: expected a column of this name or parent");
    EXPECT_EQ(without(rtwig, "axis_y"), "a:1: axis_y: expected a column of this name");
    EXPECT_EQ(without(rtwig, "length"), "a:1: length: expected a column of this name");
    EXPECT_EQ(without(archi, "cyl_ID"), "a:1: cyl_ID: expected a column of this name");
    EXPECT_EQ(without(treeQsm, "extension"), "a:1: id: expected a column of this name or extension");
    EXPECT_EQ(problemOfScanText("cyl_ID,parent,startX,startY,startZ,endX,endY,endZ\n"),
              "a:1: radius: expected a column of this name or radius_cyl");
}

TEST(BrokenScanTable, GivesOneErrorWithItsPlace) {
    const auto archiWith = [](const std::string& row) {
        return problemOfScanText(table(archi, {archiRows[0], row}));
    };
    EXPECT_EQ(archiWith("0,0,1,0,0,2,2,1,0"),
              "a:3: radius_cyl: expected a radius above 0 and of at most 10 m, found '0'");
    EXPECT_EQ(archiWith("0,0,1,NA,0,2,2,1,0.1"), "a:3: endX: expected metres within 1e9, found 'NA'");
    EXPECT_EQ(archiWith("0,0,1,0,0,2,NA,1,0.1"), "a:3: cyl_ID: expected a whole number, found 'NA'");
    EXPECT_EQ(
        archiWith("0,0,1,0,0,2,2,1.5,0.1"),
        "a:3: parent_ID: expected the id of the parent cylinder, or 0, -1 or NA for the root, found '1.5'");
    EXPECT_EQ(archiWith("0,0,1,0,0,2,2,3,0.1"), "a:3: expected a parent of the same tree, found 3");
    EXPECT_EQ(
        archiWith("0,0,1,0,0,2,2,NA,0.1"),
        "a:3: expected one root, found a second one besides line 2; branches without a parent have 50 % of "
        "the wood, and at most 5 % can be joined to the nearest cylinder");
    EXPECT_EQ(archiWith("0,0,1,0,0,2,2,1"), "a:3: expected 9 cells as in the header, found 8");
    EXPECT_EQ(problemOfScanText(table(rtwig, {"0,0,0,0,0,2,1,0,0.1,1"})),
              "a:2: axis_z: expected a component of a unit vector, found '2'");
    EXPECT_EQ(problemOfScanText(table(rtwig, {"0,0,0,0,0,0.5,1,0,0.1,1"})),
              "a:2: axis_x: expected a unit vector, found one of length 0.5");
    EXPECT_EQ(problemOfScanText(table(rtwig, {"0,0,0,0,0,1,1,0,0.1,"})),
              "a:2: length: expected a length above 0 and of at most 200 m, found nothing");
}

} // namespace osgTreeWind

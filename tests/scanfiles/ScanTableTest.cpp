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

namespace {

/// A trunk of two metres with two branches, as points with ids, parents, x, y, z and radius.
const std::vector<std::string> points = {"1,-1,0,0,0,0.1", "2,1,0,0,1,0.1", "3,2,0,0,2,0.05",
                                         "4,2,0.5,0,1.5,0.02", "5,4,1,0,1.5,0.01"};

void expectPoints(const std::string& text) {
    SCOPED_TRACE(text);
    const Result<ScanFile> scan = readScan(text, "a");
    ASSERT_TRUE(scan) << firstProblem(scan);
    EXPECT_EQ(scan.value().format, "table of points");
    EXPECT_EQ(parentsOf(scan.value()), (std::vector<int>{-1, 0, 0, 2}));
    const ScanCylinders& tree = scan.value().trees.front();
    EXPECT_EQ(tree[2].start, glm::dvec3(0, 0, 1));
    EXPECT_EQ(tree[2].end, glm::dvec3(0.5, 0, 1.5));
    EXPECT_NEAR(tree[2].radius, 0.02, 1e-12);
    EXPECT_EQ(tree[2].line, 5);
}

/// The cylinders of these points in an order that no parents need.
const std::vector<std::string> ends = {"0.5,0,1.5,1,0,1.5,0.01", "0,0,0,0,0,1,0.1", "0,0,1,0,0,2,0.05",
                                       "0,0,1,0.5,0,1.5,0.02"};

std::vector<std::string> notesOf(const std::string& text) {
    return read(text).notes;
}

} // namespace

TEST(ScanTable, ReadsPointsOfSkeletons) {
    for (const char* names : {"node_id,parent_id,x,y,z,radius", "NodeID,Parent,X,Y,Z,R",
                              "\"id\",\"parent\",\"pos_x\",\"pos_y\",\"pos_z\",\"radius\"", "n,P,x,y,z,R",
                              "index,pid,x (m),y (m),z (m),radius [m]"})
        expectPoints(table(names, points));
    for (const char delimiter : {';', '\t', ' '})
        expectPoints(table("node_id,parent_id,x,y,z,radius", points, delimiter));
    std::vector<std::string> others = points;
    for (const char* root : {"1,0,0,0,0,0.1", "1,1,0,0,0,0.1", "1,,0,0,0,0", "1,NaN,0,0,0,"}) {
        others[0] = root;
        expectPoints(table("node_id,parent_id,x,y,z,radius", others));
    }
    EXPECT_NEAR(read(table("id,parent,x,y,z,diameter", points)).trees.front()[0].radius, 0.05, 1e-12);
}

TEST(ScanTable, ReadsSwcWithAHeaderLine) {
    const std::string rows = "1 1 0 0 0 0.1 -1\n2 1 0 0 1 0.1 1\n3 1 0 0 2 0.05 2\n4 1 0.5 0 1.5 0.02 2\n"
                             "5 1 1 0 1.5 0.01 4\n";
    for (const char* header :
         {"id type x y z radius parent\n", "n T x y z R P\n", "sample structure x y z r parent\n"})
        expectPoints(header + rows);
    EXPECT_EQ(read("# made by a program\n# n T x y z R P\n" + rows).format, "SWC");
    EXPECT_EQ(read("# made by a program\nid type x y z radius parent\n" + rows).trees.front()[2].line, 6);
}

/// RayCloudTools uses the same names for many points in a line.
TEST(ScanTable, RowsWithoutIdsAreNumbered) {
    const std::string names = "x,y,z,radius,parent_id";
    const std::vector<std::string> fromZero = {"0,0,0,0.1,-1", "0,0,1,0.1,0", "0,0,2,0.05,1"},
                                   fromOne = {"0,0,0,0.1,0", "0,0,1,0.1,1", "0,0,2,0.05,2"},
                                   withoutRoot = {"0,0,0,0.1,", "0,0,1,0.1,0", "0,0,2,0.05,1"};
    for (const auto& [rows, first] : {std::pair(fromZero, "0"), {fromOne, "1"}, {withoutRoot, "0"}}) {
        EXPECT_EQ(parentsOf(read(table(names, rows))), (std::vector<int>{-1, 0}));
        EXPECT_EQ(notesOf(table(names, rows)),
                  std::vector<std::string>{"its parents are taken as numbers of rows from " +
                                           std::string(first) + " on, because there is no column of ids"});
    }
    EXPECT_EQ(parentsOf(read(table("startX,startY,startZ,endX,endY,endZ,parent,radius",
                                   {"0,0,0,0,0,1,0,0.1", "0,0,1,0,0,2,1,0.1"}))),
              (std::vector<int>{-1, 0}));
}

TEST(ScanTable, JoinsCylindersWithoutParents) {
    for (const char* names :
         {"startX,startY,startZ,endX,endY,endZ,radius", "x1,y1,z1,x2,y2,z2,r", "sx,sy,sz,ex,ey,ez,radius"}) {
        const ScanFile scan = read(table(names, ends));
        EXPECT_EQ(parentsOf(scan), (std::vector<int>{3, -1, 1, 1}));
        EXPECT_EQ(scan.joined, std::vector<std::size_t>{0});
    }
    const ScanFile turned = read(table("endX,endY,endZ,startX,startY,startZ,radius", ends));
    EXPECT_EQ(parentsOf(turned), (std::vector<int>{3, -1, 1, 1})) << "from the tips to the foot";
    EXPECT_EQ(turned.trees.front()[3].end, glm::dvec3(0.5, 0, 1.5));
    std::vector<std::string> some = ends;
    some.emplace_back("0.05,0,1.6,0.5,0,2.5,0.06"); // on the bark, and more than 5 % of the wood
    EXPECT_EQ(parentsOf(read(table("x1,y1,z1,x2,y2,z2,r", some))), (std::vector<int>{3, -1, 1, 1, 2}));
    EXPECT_EQ(read(table("x1,y1,z1,x2,y2,z2,r", some)).joined, std::vector<std::size_t>{1});
    some.insert(some.begin(), "0.3,0,2.1,0.3,0.5,2.1,0.01"); // on the bark of the last one
    EXPECT_EQ(parentsOf(read(table("x1,y1,z1,x2,y2,z2,r", some))), (std::vector<int>{5, 4, -1, 2, 2, 3}));
    some.back() = "5,5,0,5,5,1,0.06";
    some.erase(some.begin());
    EXPECT_EQ(problemOfScanText(table("x1,y1,z1,x2,y2,z2,r", some)),
              "a:6: expected a cylinder that starts at the end of another or near it, found one 6.566 m from "
              "the nearest "
              "wood; a column of parents would join them");
}

TEST(ScanTable, YMayPointUp) {
    const std::vector<std::string> rows = {"1,-1,7,0,0,0.1", "2,1,7,1,0,0.1", "3,2,7,2,-0.5,0.05"};
    const std::string text = table("node_id,parent_id,x,y,z,radius", rows);
    const std::vector<std::string> found = {
        "y is taken as up, because the trees lie along it; up = \"z\" would keep "
        "them so"};
    for (const ScanUp up : {ScanUp::Found, ScanUp::Y}) {
        const Result<ScanFile> scan = readScan(text, "a", up);
        ASSERT_TRUE(scan) << firstProblem(scan);
        EXPECT_EQ(scan.value().trees.front()[1].end, glm::dvec3(7, 0.5, 2));
        EXPECT_EQ(scan.value().notes, up == ScanUp::Found ? found : std::vector<std::string>());
    }
    EXPECT_EQ(firstProblem(readScan(text, "a", ScanUp::Z)),
              "a:3: expected a tree of 0.1 to 150 m above its foot, in metres, found 0");
    const Result<ScanFile> leaning =
        readScan(table("node_id,parent_id,x,y,z,radius", {"1,-1,0,0,0,0.1", "2,1,0,1.9,1,0.1"}), "a");
    ASSERT_TRUE(leaning) << firstProblem(leaning);
    EXPECT_EQ(leaning.value().trees.front()[0].end, glm::dvec3(0, 1.9, 1));
    EXPECT_TRUE(leaning.value().notes.empty());
}

TEST(BrokenScanTable, ErrorListsTheNamesOfAMissingColumn) {
    const auto without = [](std::string names, const std::string& name) {
        return problemOfScanText(table(names.replace(names.find(name), name.size(), "other"), {}));
    };
    const std::string expected = "a:1: expected a column with one of the names ";
    EXPECT_EQ(without(archi, "radius_cyl"),
              expected +
                  "radius, radius_cyl, node_radius, rad, r; found startX, startY, startZ, endX, endY, endZ, "
                  "cyl_ID, parent_ID, other");
    EXPECT_EQ(without(archi, "endY").find(expected + "endY, Y_end, eY, Y2, topY, tipY, toY; found startX"),
              0u);
    EXPECT_EQ(without(rtwig, "axis_y").find(expected + "axisY, aY, directionY, dirY; found"), 0u);
    EXPECT_EQ(without(rtwig, "length").find(expected + "length, len, l; found"), 0u);
    EXPECT_EQ(
        problemOfScanText("node_id,x,y,z,radius\n1,0,0,0,0.1\n"),
        expected +
            "parent_ID, parent, parent_node, parent_node_ID, parent_index, PID, p; found node_id, x, y, z, "
            "radius");
    EXPECT_EQ(problemOfScanText("node_id,parent_id,x,y,radius\n1,-1,0,0,0.1\n"),
              expected + "Z, posZ, positionZ, nodeZ, coordZ; found node_id, parent_id, x, y, radius");
    EXPECT_EQ(without(archi, "parent_ID"), "a: expected at least one cylinder") << "parents are found";
}

TEST(BrokenScanTable, GivesOneErrorWithItsPlace) {
    const auto archiWith = [](const std::string& row) {
        return problemOfScanText(table(archi, {archiRows[0], row}));
    };
    EXPECT_EQ(archiWith("0,0,1,0,0,2,2,1,0"),
              "a:3: radius_cyl: expected a radius above 0 and of at most 10 m, found '0'");
    EXPECT_EQ(archiWith("0,0,1,NA,0,2,2,1,0.1"), "a:3: endX: expected metres within 1e9, found 'NA'");
    EXPECT_EQ(archiWith("0,0,1,0,0,2,NA,1,0.1"), "a:3: cyl_ID: expected a whole number, found 'NA'");
    EXPECT_EQ(archiWith("0,0,1,0,0,2,2,1.5,0.1"),
              "a:3: parent_ID: expected the id of the parent, or 0, -1 or NA for the root, found '1.5'");
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

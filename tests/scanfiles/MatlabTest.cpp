// SPDX-License-Identifier: MIT
#include <tests/FullTests.h>
#include <tests/MissingReader.h>
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/scanfiles/WriteMatlab.h>

#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/scanfiles/ScanFile.h>

#include <functional>
#include <random>

namespace osgTreeWind {

namespace {

ScanCylinders treeOf(const std::string& path) {
    Result<ScanFile> scan = readScanFile(path);
    EXPECT_TRUE(scan) << firstProblem(scan);
    return scan ? std::move(scan.value().trees.front()) : ScanCylinders();
}

ScanCylinders sapling() {
    return treeOf(OSGTREEWIND_TEST_DATA "/scan/treeqsm_plain.txt");
}

void expectSame(const ScanCylinders& actual, const ScanCylinders& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
        EXPECT_EQ(actual[i].parent, expected[i].parent) << i;
        EXPECT_NEAR(actual[i].radius, expected[i].radius, 1e-9) << i;
        EXPECT_NEAR(glm::distance(actual[i].start, expected[i].start), 0.0, 1e-9) << i;
        EXPECT_NEAR(glm::distance(actual[i].end, expected[i].end), 0.0, 1e-9) << i;
    }
}

} // namespace

class Matlab : public testing::TestWithParam<MatVersion> {
protected:
    TemporaryFolder _folder;

    std::string write(const std::vector<matvar_t*>& variables) const {
        return writeMat(_folder.path() + "/a.mat", GetParam(), variables);
    }
    std::string problemOf(const std::vector<matvar_t*>& variables) const {
        const std::string path = write(variables), problem = firstProblem(readScanFile(path));
        return problem.substr(0, path.size()) == path ? problem.substr(path.size() + 2) : problem;
    }
};

TEST_P(Matlab, QsmEqualsItsTextFile) {
    const ScanCylinders tree = sapling();
    const auto scan = readScanFile(write({qsmStruct("QSM", {QsmArrays(tree)})}));
    ASSERT_TRUE(scan) << firstProblem(scan);
    EXPECT_EQ(scan.value().format, "TreeQSM");
    ASSERT_EQ(scan.value().trees.size(), 1u);
    expectSame(scan.value().trees.front(), tree);
}

TEST_P(Matlab, RealQsmEqualsItsTextFile) {
    REQUIRE_REAL_DATA(path, "qsm/Tree_1_TreeQSM.txt");
    const ScanCylinders tree = treeOf(path);
    expectSame(treeOf(write({qsmStruct("QSM", {QsmArrays(tree)})})), tree);
}

TEST_P(Matlab, ReadsSeveralTrees) {
    const QsmArrays one(sapling());
    QsmArrays other = one;
    for (std::size_t i = 0; i < other.radius.size(); ++i)
        other.start[i] += 5.0;
    const std::pair<const char*, std::function<std::vector<matvar_t*>()>> ways[] = {
        {"an array of structs",
         [&] {
             return std::vector{qsmStruct("QSM", {one, other})};
         }},
        {"cells",
         [&] {
             return std::vector{matCell("QSMs", {qsmStruct("", {one}), qsmStruct("", {other})})};
         }},
        {"variables", [&] {
             return std::vector{matColumns("version", std::vector<double>{2.4}), qsmStruct("elm", {one}),
                                qsmStruct("oak", {other})};
         }}};
    for (const auto& [way, variables] : ways) {
        const auto scan = readScanFile(write(variables()));
        ASSERT_TRUE(scan) << way << ": " << firstProblem(scan);
        ASSERT_EQ(scan.value().trees.size(), 2u) << way;
        EXPECT_NEAR(scan.value().trees[0].front().start.x, 100.5, 1e-9) << way;
        EXPECT_NEAR(scan.value().trees[1].front().start.x, 105.5, 1e-9) << way;
    }
}

TEST_P(Matlab, ReadsSinglePrecision) {
    const QsmArrays arrays(sapling());
    std::vector<matvar_t*> fields = arrays.variables(qsmNames);
    Mat_VarFree(fields[0]);
    fields[0] = matColumns("radius", std::vector<float>(arrays.radius.begin(), arrays.radius.end()));
    const ScanCylinders tree = treeOf(write({matStruct("cylinder", qsmNames, fields)}));
    ASSERT_EQ(tree.size(), 8u);
    EXPECT_EQ(tree[0].radius, static_cast<double>(0.03f));
}

TEST_P(Matlab, ReadsVariablesOfVersion2) {
    const ScanCylinders tree = sapling();
    expectSame(treeOf(write(QsmArrays(tree).variables({"Rad", "Len", "Sta", "Axe", "CPar"}))), tree);
}

TEST_P(Matlab, ErrorsNameTheirPlace) {
    const auto with = [&](const std::function<void(QsmArrays&)>& change) {
        QsmArrays good(sapling()), arrays = good;
        change(arrays);
        const std::string problem = problemOf({qsmStruct("QSM", {good, arrays})});
        return problem.substr(0, problem.find("; branches without a parent have "));
    };
    EXPECT_EQ(with([](QsmArrays&) {}), "");
    EXPECT_EQ(with([](QsmArrays& a) { a.radius[2] = 0.0; }),
              "QSM(2).cylinder.radius(3): expected a radius above 0 and of at most 10 m, found '0'");
    EXPECT_EQ(with([](QsmArrays& a) { a.start[8] = std::nan(""); }),
              "QSM(2).cylinder.start(1,2): expected metres within 1e9, found 'nan'");
    EXPECT_EQ(with([](QsmArrays& a) { a.axis[16] = 0.1; }),
              "QSM(2).cylinder.axis(1,1): expected a unit vector, found one of length 0.1");
    EXPECT_EQ(with([](QsmArrays& a) { a.parent[4] = 9; }),
              "QSM(2).cylinder.parent(5): expected a parent of the same tree, found 9");
    EXPECT_EQ(with([](QsmArrays& a) { a.parent[4] = 0; }),
              "tree 2, cylinder 5: expected one root, found a second one besides line 1");
    EXPECT_EQ(with([](QsmArrays& a) { a.parent[1] = 2; }),
              "tree 2, cylinder 2: expected parents that lead to the root, found a loop");
    EXPECT_EQ(with([](QsmArrays& a) { a.length.pop_back(); }),
              "QSM(2).cylinder.length: expected a real number for each of 8 cylinders");
    EXPECT_EQ(with([](QsmArrays& a) { a.axis.resize(21); }),
              "QSM(2).cylinder.axis: expected 3 real numbers for each of 8 cylinders");
    EXPECT_EQ(problemOf({matStruct("cylinder", {"radius", "start"},
                                   {matColumns("", std::vector<double>{0.1}),
                                    matColumns("", std::vector<double>{0, 0, 0}, 3)})}),
              "cylinder.length: expected a real number for each of 1 cylinders");
    EXPECT_EQ(problemOf({matColumns("a", std::vector<double>{1.0})}),
              "expected TreeQSM's cylinders, for example QSM.cylinder; found none");
}

TEST_P(Matlab, TruncatedFilesAreReadCompletelyOrRefused) {
    const ScanCylinders tree = sapling();
    const QsmArrays arrays(tree);
    for (const bool separate : {false, true}) {
        const std::string whole =
            bytesOf(separate ? write({qsmStruct("elm", {arrays}), qsmStruct("oak", {arrays})})
                             : write({qsmStruct("QSM", {arrays, arrays})}));
        const std::size_t step = whole.size() / static_cast<std::size_t>(casesToRun(60, 12)) + 1;
        for (std::size_t length = 0; length < whole.size(); length += step) {
            const auto scan = readScanFile(_folder.write("cut.mat", whole.substr(0, length)));
            if (!scan) {
                EXPECT_EQ(scan.problems().size(), 1u) << length;
                EXPECT_FALSE(scan.problems().front().message.empty()) << length;
                continue;
            }
            ASSERT_EQ(scan.value().trees.size(), 2u) << length;
            expectSame(scan.value().trees[1], tree);
        }
    }
}

TEST_P(Matlab, DamagedFilesAreReadOrRefused) {
    const QsmArrays arrays(sapling());
    const std::string whole = bytesOf(write({qsmStruct("QSM", {arrays})}));
    std::mt19937 random(6);
    int ended = 0;
    testing::internal::CaptureStderr();
    for (int round = 0; round < casesToRun(150, 20); ++round) {
        std::string bytes = whole;
        for (unsigned changes = 1u << round % 5; changes > 0; --changes)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        const auto scan = readScanFile(_folder.write("changed.mat", bytes));
        if (scan) {
            for (const ScanCylinders& tree : scan.value().trees)
                EXPECT_FALSE(problemOfScan(tree)) << round;
            continue;
        }
        const std::string reason = firstProblem(scan);
        EXPECT_NE(reason.substr(reason.size() - 2), ": ") << reason;
        ended += reason.find("its reader ended") != std::string::npos;
    }
    RecordProperty("readers_ended", ended);
    testing::internal::GetCapturedStderr();
}

INSTANTIATE_TEST_SUITE_P(Versions, Matlab, testing::ValuesIn(matVersions),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(MatlabReader, ErrorNamesTheMissingReader) {
    const TemporaryFolder folder;
    const std::string path =
        writeMat(folder.path() + "/a.mat", matVersions[0], {qsmStruct("QSM", {QsmArrays(sapling())})});
    expectMissingReaderError("OSGTREEWIND_MATLAB", path, ".mat", "libmatio",
                             [&] { return firstProblem(readScanFile(path)); });
}

} // namespace osgTreeWind

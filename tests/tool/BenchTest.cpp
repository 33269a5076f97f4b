// SPDX-License-Identifier: MIT
#include <tests/tool/DocumentedFields.h>
#include <tests/tool/Tool.h>

#include <examples/osgtreewind/bench/BenchStatistics.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <memory>

namespace {

using nlohmann::json;

const std::vector<std::string> stages = {"cpu", "cpu-vbo", "gpu", "gpu-skin", "gpu-leaves"};
const std::vector<std::string> laterStages = {"resident", "resident-full"};

std::vector<std::string> allStages() {
    std::vector<std::string> all = stages;
    all.insert(all.end(), laterStages.begin(), laterStages.end());
    return all;
}

/// All these tests share one run with two pairs of small frames.
class BenchTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<TemporaryFolder>();
        outcome = runTool({"bench", "--trees", "1", "--frames", "2", "--size", "64x64", "--scale-trees",
                           "300", "-o", "results.json"},
                          folder->path());
        report = json::parse(contentOf(folder->path() + "/results.json"), nullptr, false);
    }
    static void TearDownTestSuite() { folder.reset(); }
    void SetUp() override {
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        ASSERT_TRUE(report.is_object());
    }

    static const json& result(const std::string& stage) {
        for (const json& candidate : report["results"])
            if (candidate["stage"] == stage)
                return candidate;
        static const json none;
        ADD_FAILURE() << "no result of " << stage;
        return none;
    }

    static std::unique_ptr<TemporaryFolder> folder;
    static Outcome outcome;
    static json report;
};

std::unique_ptr<TemporaryFolder> BenchTest::folder;
Outcome BenchTest::outcome;
json BenchTest::report;

TEST_F(BenchTest, PrintsNothingToStandardError) {
    EXPECT_EQ(outcome.err, "");
}

void expectDocumented(const json& report) {
    const DocumentedFields table = documentedFields(pageOf("results.md"), "## The JSON document");
    std::set<std::string> fields;
    addFields(report, "", fields);
    for (const std::string& field : fields)
        EXPECT_TRUE(isDocumented(table, field)) << field << " is not documented";
}

TEST_F(BenchTest, DocumentsEveryFieldOfItsReport) {
    expectDocumented(report);
}

TEST_F(BenchTest, MeasuresEveryStage) {
    std::vector<std::string> measured;
    for (const json& result : report["results"])
        measured.push_back(result["stage"]);
    EXPECT_EQ(measured, allStages());
}

TEST_F(BenchTest, ReportsMachineAndSettings) {
    EXPECT_EQ(report["format"], "osgtreewind bench 1");
    EXPECT_EQ(report["version"], OSGTREEWIND_VERSION);
    EXPECT_NE(report["machine"], "");
    EXPECT_TRUE(report["opengl"]["backend"] == "osmesa" || report["opengl"]["backend"] == "egl");
    EXPECT_NE(report["opengl"]["renderer"], "");
    EXPECT_EQ(report["settings"]["width"], 64);
    EXPECT_EQ(report["settings"]["height"], 64);
    EXPECT_EQ(report["settings"]["framePairs"], 2);
}

TEST_F(BenchTest, UsesTheAngleSourceOfTheStage) {
    for (const std::string& stage : stages)
        EXPECT_EQ(result(stage)["angles"], stage.substr(0, 3)) << stage;
    EXPECT_EQ(result("resident")["angles"], "gpu");
}

TEST_F(BenchTest, UsesTheLawOfTheStage) {
    for (const std::string& stage : stages)
        EXPECT_EQ(result(stage)["law"], "thesis") << stage;
    for (const std::string& stage : laterStages)
        EXPECT_EQ(result(stage)["law"], "modal") << stage;
}

TEST_F(BenchTest, IncludesTheTablesOfTheThesis) {
    const std::map<std::string, std::pair<std::string, int>> tables = {{"cpu", {"6.1", 10}},
                                                                       {"cpu-vbo", {"6.2", 12}},
                                                                       {"gpu", {"6.3", 105}},
                                                                       {"gpu-skin", {"6.4", 90}},
                                                                       {"gpu-leaves", {"6.5", 32}}};
    for (const auto& [stage, table] : tables) {
        EXPECT_EQ(result(stage)["thesisTable"], table.first);
        EXPECT_EQ(result(stage)["thesisFps"], table.second);
    }
    EXPECT_TRUE(result("resident")["thesisFps"].is_null());
}

TEST_F(BenchTest, DividesFramesBySeconds) {
    for (const json& result : report["results"])
        for (const char* variant : {"moving", "static"})
            EXPECT_NEAR(result[variant]["fps"].get<double>() * result[variant]["seconds"].get<double>(), 2.0,
                        1e-6);
}

TEST_F(BenchTest, GivesOrderedSpreadsOfEveryTime) {
    for (const json& result : report["results"]) {
        std::vector<json> spreads = {result["ratioToStatic"], result["processorRatioToStatic"]};
        for (const char* variant : {"moving", "static"})
            for (const char* time : {"frameMs", "processorMs", "updateMs", "cullMs", "drawMs"})
                spreads.push_back(result[variant][time]);
        for (const json& spread : spreads) {
            ASSERT_TRUE(spread["median"].is_number()) << result;
            EXPECT_GE(spread["p10"].get<double>(), 0.0);
            EXPECT_LE(spread["p10"], spread["median"]);
            EXPECT_LE(spread["median"], spread["p90"]);
        }
    }
}

TEST_F(BenchTest, PrintsARowForEachResult) {
    for (const std::string& stage : allStages())
        EXPECT_NE(outcome.out.find("| `" + stage + "` | 1 |"), std::string::npos) << stage;
}

/// Number of trees drawn, summed over all tiers.
std::size_t drawnTrees(const json& view) {
    std::size_t trees = 0;
    for (const json& tier : view["tiers"])
        trees += tier.get<std::size_t>();
    return trees;
}

TEST_F(BenchTest, DrawsAForestInTurnsWithOneTree) {
    ASSERT_EQ(report["scale"].size(), 1u);
    const json& wood = report["scale"][0];
    EXPECT_EQ(wood["trees"], 300);
    EXPECT_EQ(wood["shapes"], 15); // five species
    EXPECT_EQ(wood["view"], "over");
    EXPECT_GT(drawnTrees(wood), 150u); // all are in view; some hide others; fading trees count twice
    if (wood["forestBytes"].is_null()) // under a sanitizer's allocator
        EXPECT_TRUE(wood["bytesPerTree"].is_null());
    else
        EXPECT_GT(wood["bytesPerTree"].get<double>(), 100.0);
    EXPECT_GT(wood["loadSeconds"], wood["loadParts"]["forest"]);
    EXPECT_GT(wood["ratioToTree"]["median"], 0.0);
    EXPECT_TRUE(wood["inFull"].is_null());
    EXPECT_TRUE(report["views"].empty()); // no file was given
    EXPECT_NE(outcome.out.find("\n| made trees | over | 300 | "), std::string::npos) << outcome.out;
}

TEST(BenchUsageTest, AForestAloneMeasuresOnlyItsViews) {
    const TemporaryFolder folder;
    const Outcome outcome = runTool(
        {"bench", "--forest", example("forest.treewind"), "--frames", "2", "--size", "64x64", "-o", "r.json"},
        folder.path());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json report = json::parse(contentOf(folder.path() + "/r.json"), nullptr, false);
    EXPECT_TRUE(report["results"].empty());
    ASSERT_EQ(report["views"].size(), 3u);
    EXPECT_EQ(report["views"][0]["view"], "over");
    EXPECT_EQ(report["views"][1]["view"], "home");
    EXPECT_EQ(report["views"][2]["view"], "inside");
    for (const json& view : report["views"]) {
        EXPECT_EQ(view["forest"], example("forest.treewind"));
        EXPECT_GE(drawnTrees(view), view["view"] == "inside" ? 1 : view["trees"].get<std::size_t>());
        EXPECT_GT(view["inFullRatioToTree"]["median"], 0.0);
    }
}

TEST(BenchUsageTest, CountsTheCallsOfAForest) {
    const TemporaryFolder folder;
    const Outcome outcome = runTool({"bench", "--stage", "calls", "--forest", example("forest.treewind"),
                                     "--frames", "2", "--size", "640x360", "-o", "r.json"},
                                    folder.path());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json report = json::parse(contentOf(folder.path() + "/r.json"), nullptr, false);
    ASSERT_EQ(report["calls"].size(), 1u);
    const json& scene = report["calls"][0];
    EXPECT_EQ(scene["scene"], example("forest.treewind"));
    EXPECT_GT(scene["trees"], 0);
    EXPECT_GT(scene["bufferBytes"], 0.0);
    EXPECT_GT(scene["calls"]["instancedDraws"].get<double>() + scene["calls"]["multiDraws"].get<double>(),
              0.0);
    for (const char* part : {"leaves", "bark", "impostors", "poses"})
        EXPECT_GT(scene["work"][part]["leastTextureFetches"], 0) << part;
    EXPECT_GE(scene["work"]["leaves"]["vertices"], scene["work"]["leaves"]["shadedVertices"]);
    expectDocumented(report);
}

TEST(BenchUsageTest, TheStageViewNeedsAForest) {
    const Outcome refused = runTool({"bench", "--stage", "view"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_EQ(refused.err, "--stage view: expected --forest FILE\n");
}

TEST(BenchUsageTest, MeasuresOneStageWithSeveralNumbersOfTrees) {
    const TemporaryFolder folder;
    const Outcome outcome = runTool({"bench", "--stage", "gpu-skin", "--trees", "2,3", "--frames", "1",
                                     "--size", "32x32", "-o", "results.json"},
                                    folder.path());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json results =
        json::parse(contentOf(folder.path() + "/results.json"), nullptr, false).at("results");
    ASSERT_EQ(results.size(), 2u);
    for (const int trees : {2, 3}) {
        const json& result = results[static_cast<std::size_t>(trees - 2)];
        EXPECT_EQ(result["stage"], "gpu-skin");
        EXPECT_EQ(result["trees"], trees);
    }
}

TEST(BenchUsageTest, RefusesInvalidOptions) {
    const std::vector<std::vector<std::string>> cases = {{"--trees", "0"},    {"--trees", "x"},
                                                         {"--frames", "0"},   {"--size", "0x9"},
                                                         {"--stage", "fast"}, {"--scale-trees", "0"}};
    for (const std::vector<std::string>& words : cases) {
        std::vector<std::string> line = {"bench"};
        line.insert(line.end(), words.begin(), words.end());
        const Outcome refused = runTool(line);
        EXPECT_EQ(refused.exitCode, 2) << words[0] << ' ' << words[1];
        EXPECT_NE(refused.err.find(words[0]), std::string::npos) << refused.err;
    }
}

TEST(BenchUsageTest, RefusesAForestThatIsNotThere) {
    const Outcome refused = runTool({"bench", "--stage", "view", "--forest", "nowhere.treewind"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_NE(refused.err.find("nowhere.treewind"), std::string::npos) << refused.err;
}

TEST(BenchUsageTest, FailsBeforeMeasuringWhenTheResultsCannotBeWritten) {
    const Outcome failed = runTool({"bench", "-o", "/nowhere/results.json"});
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_EQ(failed.err, "/nowhere/results.json: cannot be written: there is no folder /nowhere\n");
    EXPECT_EQ(failed.out, "");
}

TEST(BenchStatisticsTest, QuantilesAreLinearBetweenValues) {
    const std::vector<double> values = {50, 15, 40, 20, 35};
    EXPECT_DOUBLE_EQ(quantile(values, 0.0), 15.0);
    EXPECT_DOUBLE_EQ(quantile(values, 0.4), 29.0);
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 35.0);
    EXPECT_DOUBLE_EQ(quantile(values, 1.0), 50.0);
}

TEST(BenchStatisticsTest, NoValuesHaveNoQuantile) {
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(BenchStatisticsTest, RatiosArePaired) {
    EXPECT_EQ(ratios({2.0, 9.0}, {4.0, 3.0}), (std::vector<double>{0.5, 3.0}));
}

} // namespace

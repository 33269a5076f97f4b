// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/sway/FreeSwayTree.h>
#include <osgTreeWind/scanfiles/ScanFile.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

/// Scanned trees from outside this project.
namespace osgTreeWind {

namespace {

struct RealScan {
    const char* file;
    const char* format;
    std::size_t cylinders;
    double height, volume;             ///< Of the cylinders, computed by a separate script; metres, m^3.
    double minFrequency, maxFrequency; ///< Plausible range of the first natural frequency, Hz.
};

const RealScan realScans[] = {
    {"qsm/Tree_1_TreeQSM.txt", "TreeQSM", 2271, 22.0356, 3.89906, 0.1, 0.6},
    {"qsm/SimpleForest_QSM.csv", "SimpleForest", 1149, 3.70195, 0.0299737, 0.4, 3.0}};

void PrintTo(const RealScan& scan, std::ostream* out) {
    *out << scan.file;
}

} // namespace

class RealScanTest : public testing::TestWithParam<RealScan> {
protected:
    ScannedTree tree;

    void SetUp() override {
        REQUIRE_REAL_DATA(path, GetParam().file);
        const auto scan = readScanFile(path);
        ASSERT_TRUE(scan) << firstProblem(scan);
        EXPECT_EQ(scan.value().format, GetParam().format);
        ASSERT_EQ(scan.value().trees.size(), 1u);
        EXPECT_EQ(scan.value().trees.front().size(), GetParam().cylinders);
        auto made = makeScannedTree(scan.value().trees.front());
        ASSERT_TRUE(made) << firstProblem(made);
        tree = std::move(made.value());
    }
    Species species() const {
        Species species;
        species.shapes = 1;
        species.tree.scans = std::make_shared<const std::vector<ScannedTree>>(1, tree);
        return species;
    }
};

TEST_P(RealScanTest, StandsAtTheOriginWithTheHeightOfItsCylinders) {
    EXPECT_EQ(tree.skeleton.units.front().base, glm::vec3(0.0f));
    float low = 1e9f, high = 0.0f;
    for (const glm::vec3& point : tree.skeleton.points) {
        low = std::min(low, point.z);
        high = std::max(high, point.z);
    }
    EXPECT_NEAR(low, 0.0, 0.01 * GetParam().height);
    EXPECT_NEAR(high / GetParam().height, 1.0, 0.01);
}

TEST_P(RealScanTest, DrawnAndSimulatedWoodKeepTheVolume) {
    double swayed = 0.0;
    for (const BranchUnit& unit : tree.skeleton.units)
        swayed += static_cast<double>(ScaledUnit(unit, {}).volume());
    for (const ShootWood& shoots : shootWoodOf(tree.skeleton))
        swayed += static_cast<double>(shoots.volume);
    EXPECT_NEAR(woodVolume(tree.skeleton) / GetParam().volume, 1.0, 0.05);
    EXPECT_NEAR(swayed / GetParam().volume, 1.0, 0.05);
    EXPECT_LE(tree.skeleton.units.size(), 400u);
}

TEST_P(RealScanTest, HasAPlausibleNaturalFrequency) {
    const FreeSwayTree swaying(species(), TreePlacement{});
    ASSERT_FALSE(swaying.modes().empty());
    const double frequency = swaying.omega(0) / 6.283185;
    EXPECT_GT(frequency, GetParam().minFrequency);
    EXPECT_LT(frequency, GetParam().maxFrequency);
}

INSTANTIATE_TEST_SUITE_P(Trees, RealScanTest, testing::ValuesIn(realScans),
                         [](const auto& info) { return std::string(info.param.format); });

} // namespace osgTreeWind

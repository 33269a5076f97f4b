// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/BranchParameters.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

BranchUnit unit() {
    return {-1, 3, {1, 1, 1}, {1, 1, 3}, 0.03f, 0.02f};
}

} // namespace

TEST(BranchParameters, SpringIsThatOfTheMeanDiameter) {
    Species oak;
    oak.wood.elasticModulus = 12.0e9f;
    const BranchParameters branch = makeBranchParameters(unit(), {}, oak);
    EXPECT_FLOAT_EQ(branch.length, 2.0f);
    EXPECT_NEAR(branch.spring, 12.0e9f * 0.05f * 0.05f * 0.05f * 0.05f / 32.0f, 0.5f);
}

TEST(BranchParameters, ComeFromTheScaledBranch) {
    TreeScale scale;
    scale.axes = {5.0f, 5.0f, 2.0f};
    scale.radius = 3.0f;
    const Species oak;
    const BranchParameters small = makeBranchParameters(unit(), {}, oak);
    const BranchParameters large = makeBranchParameters(unit(), scale, oak);
    EXPECT_FLOAT_EQ(large.length, 4.0f);
    EXPECT_NEAR(large.spring / small.spring, 81.0f / 8.0f, 1e-3f);
}

TEST(BranchParameters, LevelLoadGrowsWithTheLevel) {
    Species oak;
    oak.branch.levelFactor = 0.2f;
    EXPECT_FLOAT_EQ(makeBranchParameters(unit(), {}, oak).levelLoad, 0.6f);
}

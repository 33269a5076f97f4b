// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/branchwise/ThesisParameters.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

BranchUnit unit() {
    return {-1, 3, {1, 1, 1}, {1, 1, 3}, 0.03f, 0.02f};
}

} // namespace

TEST(ThesisParameters, SpringFollowsTheMeanDiameter) {
    Species oak;
    oak.wood.elasticModulus = 12.0e9f;
    const Laws::ThesisBranch branch = makeThesisBranch(unit(), {}, oak);
    EXPECT_FLOAT_EQ(branch.branchLength, 2.0f);
    EXPECT_NEAR(branch.spring, 12.0e9f * 0.05f * 0.05f * 0.05f * 0.05f / 32.0f, 0.5f);
}

TEST(ThesisParameters, FollowTheScaledBranch) {
    TreeScale scale;
    scale.axes = {5.0f, 5.0f, 2.0f};
    scale.radius = 3.0f;
    const Species oak;
    const Laws::ThesisBranch small = makeThesisBranch(unit(), {}, oak);
    const Laws::ThesisBranch large = makeThesisBranch(unit(), scale, oak);
    EXPECT_FLOAT_EQ(large.branchLength, 4.0f);
    EXPECT_NEAR(large.spring / small.spring, 81.0f / 8.0f, 1e-3f);
}

TEST(ThesisParameters, LevelLoadGrowsWithTheLevel) {
    Species oak;
    oak.branch.levelFactor = 0.2f;
    EXPECT_FLOAT_EQ(makeThesisBranch(unit(), {}, oak).levelLoad, 0.6f);
}

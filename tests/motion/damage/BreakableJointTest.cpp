// SPDX-License-Identifier: MIT
#include <tests/motion/GrownTree.h>

#include <osgTreeWind/motion/damage/BreakableJoint.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

std::vector<BreakableJoint> boughsOf(const GrownTree& tree) {
    return thickestBoughs(tree.form(), makeUnitLoads(tree.model, tree.scale, tree.species, tree.leaves));
}

/// The largest moment of each bough in ten minutes of gusts, over its limit; largest first.
std::vector<double> largestShares(const GrownTree& tree, ModalLevel level, float speed) {
    const std::vector<BreakableJoint> boughs = boughsOf(tree);
    ModalMotion motion({{tree.form(), glm::vec3(0.0f), 0.0f, level}}, 1.0f, runInTurn);
    const WindFieldPtr wind = gustsOf(speed);
    const double step = level == ModalLevel::Near ? 0.05 : 0.2;
    std::vector<double> largest(boughs.size());
    for (int i = 1; i <= static_cast<int>(600.0 / step); ++i) {
        motion.step(wind.get(), step * i, static_cast<float>(step));
        if (step * i < 60.0)
            continue;
        const ModalMotion::PoseVector vector = motion.poseVector(0);
        for (std::size_t b = 0; b < boughs.size(); ++b)
            largest[b] = std::max(largest[b],
                                  static_cast<double>(boughs[b].moment(motion, 0, vector) / boughs[b].limit));
    }
    std::sort(largest.rbegin(), largest.rend());
    return largest;
}

} // namespace

TEST(BreakableJoint, ThickestBoughsHaveTheBreakingMomentOfTheirWood) {
    const GrownTree oak("oak", {15.0f, 0.25f, 0.0f});
    const std::vector<BreakableJoint> boughs = boughsOf(oak);
    ASSERT_GT(boughs.size(), 8u);
    EXPECT_LE(boughs.size(), 32u);
    for (std::size_t i = 0; i < boughs.size(); ++i) {
        const BranchUnit& unit = oak.units()[boughs[i].unit];
        EXPECT_LT(oak.units()[static_cast<std::size_t>(unit.parent)].level, unit.level);
        EXPECT_NEAR(
            boughs[i].limit,
            breakingMoment(oak.species.wood, 2.0 * static_cast<double>(oak.scale.radius * unit.baseRadius)),
            1e-3f * boughs[i].limit);
        EXPECT_TRUE(i == 0 || boughs[i].limit <= boughs[i - 1].limit);
    }
}

TEST(BreakableJoint, MomentsOfFarTreesMatchThoseOfNearTrees) {
    for (const char* name : {"oak", "silver birch", "Norway spruce", "Scots pine"}) {
        const GrownTree tree(name, {14.0f, 0.2f, 0.0f});
        const std::vector<double> near = largestShares(tree, ModalLevel::Near, 15.0f),
                                  far = largestShares(tree, ModalLevel::Far, 15.0f);
        EXPECT_GT(near.front(), 0.05) << name;
        // A near bough has its own gusts; a far one shares those of a quarter of the crown.
        EXPECT_NEAR(far.front() / near.front(), 1.0, 0.3) << name;
        for (std::size_t b = 1; b < 4; ++b)
            EXPECT_NEAR(far[b] / near[b], 1.0, 0.25) << name << ' ' << b;
    }
}

} // namespace osgTreeWind

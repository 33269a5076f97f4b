// SPDX-License-Identifier: MIT
#include <tests/motion/GrownTree.h>

#include <osgTreeWind/motion/damage/HeldJoint.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

std::vector<HeldJoint> boughsOf(const GrownTree& tree) {
    return thickestBoughs(tree.form(), makeUnitLoads(tree.model, tree.scale, tree.species, tree.leaves));
}

/// The largest share of what a bough of the tree bears, in ten minutes of gusts.
double largestShare(const GrownTree& tree, ModalLevel level, float speed) {
    const std::vector<HeldJoint> boughs = boughsOf(tree);
    ModalMotion motion({{tree.form(), glm::vec3(0.0f), 0.0f, level}}, 1.0f, runInTurn);
    const WindFieldPtr wind = gustsOf(speed);
    const double step = level == ModalLevel::Near ? 0.05 : 0.2;
    double largest = 0.0;
    for (int i = 1; i <= static_cast<int>(600.0 / step); ++i) {
        motion.step(wind.get(), step * i, static_cast<float>(step));
        if (step * i < 60.0)
            continue;
        float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
        motion.poseVector(0, vector);
        for (const HeldJoint& bough : boughs)
            largest = std::max(largest, static_cast<double>(bough.moment(motion, 0, vector) / bough.limit));
    }
    return largest;
}

} // namespace

TEST(HeldJoint, BoughsAreTheThickestAndBearWhatTheirWoodDoes) {
    const GrownTree oak("oak", {15.0f, 0.25f, 0.0f});
    const std::vector<HeldJoint> boughs = boughsOf(oak);
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

TEST(HeldJoint, OfTreesFollowedFromAfarBearWhatTheyDoNearby) {
    for (const char* name : {"oak", "silver birch", "Norway spruce", "Scots pine"}) {
        const GrownTree tree(name, {14.0f, 0.2f, 0.0f});
        const double near = largestShare(tree, ModalLevel::Near, 15.0f);
        EXPECT_GT(near, 0.05) << name;
        EXPECT_NEAR(largestShare(tree, ModalLevel::Far, 15.0f) / near, 1.0, 0.3) << name;
    }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/Archetype.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/motion/modal/TreeModes.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace osgTreeWind {
namespace {

/// Trees of five species, from 6 to 30 m, slender to stout, narrow to wide.
class MixedForest {
public:
    explicit MixedForest(std::size_t count) {
        for (const char* name : {"oak", "silver birch", "beech", "Scots pine", "Norway spruce"})
            _kinds.emplace_back(name, TreeSize());
        Random random(5);
        for (std::size_t i = 0; i < count; ++i) {
            const auto kind = static_cast<std::size_t>(random.uniform() * 5.0f);
            const float height = 6.0f + 24.0f * random.uniform();
            _sizes.push_back({height, height * (0.01f + 0.012f * random.uniform()),
                              height * (0.3f + 0.3f * random.uniform())});
            trees.push_back(_kinds[kind].form());
            trees.back().scale = fitTree(_kinds[kind].model, _sizes.back());
        }
    }

    /// For messages.
    std::string nameOf(std::size_t i) const {
        const TreeSize& size = _sizes[i];
        return trees[i].species->name + " of " + std::to_string(size.height) + " m, " +
               std::to_string(size.trunkDiameter) + " m thick, " + std::to_string(size.crownWidth) +
               " m wide";
    }

    std::vector<SwayingTree> trees;

private:
    std::vector<GrownTree> _kinds;
    std::vector<TreeSize> _sizes;
};

float grown(const SizePowers& powers, const SizePowers& logs) {
    return Laws().nearExponential(powers.modulus * logs.modulus + powers.branches * logs.branches +
                                  powers.width * logs.width + powers.leaves * logs.leaves +
                                  powers.support * logs.support + powers.roots * logs.roots);
}

/// Of a mode of the only tree, with weight, rad/s.
float paceOf(const ModalMotion& motion, std::size_t mode) {
    const ModalModel::Mode& m = motion.archetype(0).model(0).modes[mode];
    const TreeFactors f = motion.factors(0);
    const float stiffness = grown(m.stiffness, f.logs), mass = grown(m.mass, f.logs);
    const float weight = std::clamp(m.weightShare * mass / (f.pace * f.length * stiffness), -1.0f, 0.75f);
    return m.pace * std::sqrt(f.pace * stiffness * (1.0f - weight) / mass);
}

std::vector<double> modeAngles(const ModalMotion& motion, std::size_t mode) {
    const ModalModel& model = motion.archetype(0).model(0);
    std::vector<double> angles;
    for (std::size_t i = 0; i < model.joints; ++i)
        angles.push_back(static_cast<double>(model.poses[i * model.columns() + mode]));
    return angles;
}

/// Pace that the rung gives to the tree's own strongest mode, over what it is. Where paces lie close together
/// a mode is a mixture of several on the rung: the mean of their squared paces, by their part in it.
float paceRatio(const ModalMotion& rung, const ModalMotion& own, const SwayingTree& tree) {
    const JointMasses masses(makeJointTree(*tree.model, tree.scale, *tree.species, tree.leaves));
    const std::vector<double> momenta = masses.times(modeAngles(own, 0));
    double parts = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < rung.archetype(0).model(0).modes.size(); ++k) {
        const std::vector<double> angles = modeAngles(rung, k), its = masses.times(angles);
        const double common = std::inner_product(angles.begin(), angles.end(), momenta.begin(), 0.0),
                     whole = std::inner_product(angles.begin(), angles.end(), its.begin(), 0.0);
        const double part = common * common / whole, pace = static_cast<double>(paceOf(rung, k));
        parts += part;
        squares += part * pace * pace;
    }
    return static_cast<float>(std::sqrt(squares / parts)) / paceOf(own, 0);
}

/// Standard deviation of the angle at which the top of the trunk stands in gusts.
float topMotion(ModalMotion& motion, const SwayingTree& tree, const WindField& wind) {
    constexpr int frames = 1200, settling = 120;
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    std::vector<glm::vec2> angles(units.size());
    motion.meet(&wind, 0.0);
    glm::vec2 sum(0.0f);
    float squares = 0.0f, count = 0.0f;
    for (int i = 1; i <= frames; ++i) {
        motion.step(&wind, i / 60.0, 1.0f / 60.0f);
        if (i <= settling || i % 6 != 0)
            continue;
        motion.angles(0, angles.data());
        glm::vec2 turn(0.0f);
        for (std::size_t unit = 0; unit < units.size(); ++unit)
            if (units[unit].level == 0)
                turn += angles[unit];
        sum += turn;
        squares += glm::dot(turn, turn);
        ++count;
    }
    return std::sqrt((squares - glm::dot(sum, sum) / count) / count);
}

TEST(Archetype, FitsTheTreesAroundIt) {
    const MixedForest forest(60);
    const WindFieldPtr wind = gustsOf(8);
    std::vector<std::pair<float, std::size_t>> paces, motions; // error, tree
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        ModalMotion::Tree placed;
        placed.form = forest.trees[i];
        ModalMotion rung({placed}, 1.0f, runInTurn), own({placed}, 1.0f, runInTurn, true);
        paces.emplace_back(std::abs(paceRatio(rung, own, placed.form) - 1.0f), i);
        motions.emplace_back(
            std::abs(topMotion(rung, placed.form, *wind) / topMotion(own, placed.form, *wind) - 1.0f), i);
    }
    std::sort(paces.begin(), paces.end());
    std::sort(motions.begin(), motions.end());
    const std::size_t most = forest.trees.size() * 95 / 100 - 1;
    EXPECT_LT(paces[most].first, 0.035f) << forest.nameOf(paces[most].second) << "; median "
                                         << paces[paces.size() / 2].first << ", worst " << paces.back().first;
    EXPECT_LT(motions[most].first, 0.16f)
        << forest.nameOf(motions[most].second) << "; median " << motions[motions.size() / 2].first
        << ", worst " << motions.back().first;
    RecordProperty("medianPaceError", std::to_string(paces[paces.size() / 2].first));
    RecordProperty("medianMotionError", std::to_string(motions[motions.size() / 2].first));
}

TEST(Archetype, IsExactForItsOwnTree) {
    const GrownTree oak("oak", {17, 0.31f, 0});
    const Archetype archetype(oak.form());
    const TreeFactors factors = archetype.factors(oak.form(), 0.0f);
    EXPECT_EQ(factors.length, 1.0f);
    EXPECT_EQ(factors.pace, 1.0f);
    EXPECT_EQ(factors.logs.modulus, 0.0f);
    EXPECT_EQ(factors.logs.branches, 0.0f);
    EXPECT_EQ(factors.logs.width, 0.0f);
    EXPECT_EQ(factors.logs.leaves, 0.0f);
    EXPECT_EQ(factors.logs.support, 0.0f);
    EXPECT_EQ(factors.logs.roots, 0.0f);
    EXPECT_EQ(factors.leafDrag, 1.0f);
    EXPECT_EQ(factors.stillDrag, 1.0f);
}

TEST(Archetype, ATreeOnARungIsItsOwn) {
    const MixedForest forest(60);
    for (const SwayingTree& tree : forest.trees) {
        const ArchetypeRung rung = nearestRung(tree), again = nearestRung(treeOn(rung));
        EXPECT_FALSE(rung < again || again < rung);
    }
}

TEST(Archetype, RungsAreOneForAllWhoAreNear) {
    const GrownTree oak("oak", {18, 0.3f, 0});
    const ArchetypeRung rung = nearestRung(oak.form());
    SwayingTree near = treeOn(rung), far = treeOn(rung);
    near.scale.axes *= 1.2f;
    near.scale.radius *= 1.2f;
    far.scale.axes *= 1.6f;
    far.scale.radius *= 1.6f;
    EXPECT_FALSE(nearestRung(near) < rung || rung < nearestRung(near));
    EXPECT_TRUE(rung < nearestRung(far));
    far = treeOn(rung);
    far.leaves = 0.0f;
    EXPECT_TRUE(nearestRung(far) < rung) << "bare trees stand on a rung of their own";
}

TEST(Archetype, ARungDoesNotDependOnTheForest) {
    const MixedForest forest(60);
    std::vector<ModalMotion::Tree> trees;
    for (const SwayingTree& form : forest.trees) {
        trees.emplace_back();
        trees.back().form = form;
    }
    const ModalMotion all(trees, 1.0f, runInTurn);
    for (const std::size_t i : {std::size_t(0), std::size_t(31), std::size_t(59)}) {
        const ModalMotion alone({trees[i]}, 1.0f, runInTurn);
        const ModalModel &a = all.archetype(i).model(0), &b = alone.archetype(0).model(0);
        EXPECT_EQ(a.poses, b.poses) << forest.nameOf(i);
        EXPECT_EQ(all.factors(i).pace, alone.factors(0).pace);
        EXPECT_EQ(all.factors(i).logs.branches, alone.factors(0).logs.branches);
    }
}

TEST(Archetype, AFarPatchIsNextToItsNearOnes) {
    const GrownTree oak("oak", {18, 0.3f, 0});
    const Archetype archetype(oak.form());
    for (std::size_t level = 0; level < Archetype::levels; ++level) {
        const std::vector<std::size_t>& other = archetype.otherPatches(level);
        ASSERT_EQ(other.size(), archetype.model(level).patches.size());
        for (const std::size_t patch : other)
            EXPECT_LT(patch, archetype.model(1 - level).patches.size());
    }
}

} // namespace
} // namespace osgTreeWind

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

    std::vector<TreeForm> trees;

private:
    std::vector<GrownTree> _kinds;
    std::vector<TreeSize> _sizes;
};

float grown(const SizePowers& powers, const SizePowers& logs) {
    return Laws().nearExponential(powers.modulus * logs.modulus + powers.branches * logs.branches +
                                  powers.width * logs.width + powers.leaves * logs.leaves +
                                  powers.support * logs.support + powers.roots * logs.roots);
}

/// Angular frequency of a mode of the only tree, with weight, rad/s.
float omegaOf(const ModalMotion& motion, std::size_t mode) {
    const ModalModel::Mode& m = motion.archetype(0).model(0).modes[mode];
    const TreeFactors f = motion.factors(0);
    const float stiffness = grown(m.stiffness, f.logs), mass = grown(m.mass, f.logs);
    const float weight =
        std::clamp(m.weightShare * mass / (f.omegaSquare * f.length * stiffness), -1.0f, 0.75f);
    return m.omega * std::sqrt(f.omegaSquare * stiffness * (1.0f - weight) / mass);
}

std::vector<double> modeAngles(const ModalMotion& motion, std::size_t mode) {
    const ModalModel& model = motion.archetype(0).model(0);
    std::vector<double> angles;
    for (std::size_t i = 0; i < model.joints; ++i)
        angles.push_back(static_cast<double>(model.poses[i * model.columns() + mode]));
    return angles;
}

/// Frequency of the tree's strongest mode by its size class, over the exact one. Where frequencies are close,
/// the mode is a mixture of several modes of the size class: the mean of their squared frequencies by share.
float omegaRatio(const ModalMotion& typical, const ModalMotion& own, const TreeForm& tree) {
    const JointMasses masses(makeJointTree(*tree.model, tree.scale, *tree.species, tree.leaves));
    const std::vector<double> momenta = masses.times(modeAngles(own, 0));
    double parts = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < typical.archetype(0).model(0).modes.size(); ++k) {
        const std::vector<double> angles = modeAngles(typical, k), its = masses.times(angles);
        const double common = std::inner_product(angles.begin(), angles.end(), momenta.begin(), 0.0),
                     whole = std::inner_product(angles.begin(), angles.end(), its.begin(), 0.0);
        const double part = common * common / whole, omega = static_cast<double>(omegaOf(typical, k));
        parts += part;
        squares += part * omega * omega;
    }
    return static_cast<float>(std::sqrt(squares / parts)) / omegaOf(own, 0);
}

/// Standard deviation of the angle of the top of the trunk in gusts.
float topMotion(ModalMotion& motion, const TreeForm& tree, const WindField& wind) {
    constexpr int frames = 1200, settling = 120;
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    std::vector<glm::vec2> angles(units.size());
    motion.sampleWind(&wind, 0.0);
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

TEST(Archetype, FitsTheTreesOfItsSizeClass) {
    const MixedForest forest(60);
    const WindFieldPtr wind = gustsOf(8);
    std::vector<std::pair<float, std::size_t>> frequencyErrors, motions; // error, tree
    for (std::size_t i = 0; i < forest.trees.size(); ++i) {
        ModalMotion::Tree placed;
        placed.form = forest.trees[i];
        ModalMotion typical({placed}, 1.0f, runInTurn), own({placed}, 1.0f, runInTurn, true);
        frequencyErrors.emplace_back(std::abs(omegaRatio(typical, own, placed.form) - 1.0f), i);
        motions.emplace_back(
            std::abs(topMotion(typical, placed.form, *wind) / topMotion(own, placed.form, *wind) - 1.0f), i);
    }
    std::sort(frequencyErrors.begin(), frequencyErrors.end());
    std::sort(motions.begin(), motions.end());
    const std::size_t most = forest.trees.size() * 95 / 100 - 1;
    EXPECT_LT(frequencyErrors[most].first, 0.035f)
        << forest.nameOf(frequencyErrors[most].second) << "; median "
        << frequencyErrors[frequencyErrors.size() / 2].first << ", worst " << frequencyErrors.back().first;
    EXPECT_LT(motions[most].first, 0.16f)
        << forest.nameOf(motions[most].second) << "; median " << motions[motions.size() / 2].first
        << ", worst " << motions.back().first;
    RecordProperty("medianFrequencyError", std::to_string(frequencyErrors[frequencyErrors.size() / 2].first));
    RecordProperty("medianMotionError", std::to_string(motions[motions.size() / 2].first));
}

TEST(Archetype, IsExactForItsOwnTree) {
    const GrownTree oak("oak", {17, 0.31f, 0});
    const Archetype archetype(oak.form());
    const TreeFactors factors = archetype.factors(oak.form(), 0.0f);
    EXPECT_EQ(factors.length, 1.0f);
    EXPECT_EQ(factors.omegaSquare, 1.0f);
    EXPECT_EQ(factors.logs.modulus, 0.0f);
    EXPECT_EQ(factors.logs.branches, 0.0f);
    EXPECT_EQ(factors.logs.width, 0.0f);
    EXPECT_EQ(factors.logs.leaves, 0.0f);
    EXPECT_EQ(factors.logs.support, 0.0f);
    EXPECT_EQ(factors.logs.roots, 0.0f);
    EXPECT_EQ(factors.leafDrag, 1.0f);
    EXPECT_EQ(factors.stillDrag, 1.0f);
}

TEST(Archetype, ATypicalTreeIsExact) {
    const MixedForest forest(60);
    for (const TreeForm& tree : forest.trees) {
        const TreeSizeClass sizeClass = sizeClassOf(tree), again = sizeClassOf(typicalTree(sizeClass));
        EXPECT_FALSE(sizeClass < again || again < sizeClass);
    }
}

TEST(Archetype, SimilarTreesShareASizeClass) {
    const GrownTree oak("oak", {18, 0.3f, 0});
    const TreeSizeClass typical = sizeClassOf(oak.form());
    TreeForm near = typicalTree(typical), far = typicalTree(typical);
    near.scale.axes *= 1.2f;
    near.scale.radius *= 1.2f;
    far.scale.axes *= 1.6f;
    far.scale.radius *= 1.6f;
    EXPECT_FALSE(sizeClassOf(near) < typical || typical < sizeClassOf(near));
    EXPECT_TRUE(typical < sizeClassOf(far));
    far = typicalTree(typical);
    far.leaves = 0.0f;
    EXPECT_TRUE(sizeClassOf(far) < typical) << "bare trees have their own size class";
}

TEST(Archetype, ASizeClassDoesNotDependOnTheForest) {
    const MixedForest forest(60);
    std::vector<ModalMotion::Tree> trees;
    for (const TreeForm& form : forest.trees) {
        trees.emplace_back();
        trees.back().form = form;
    }
    const ModalMotion all(trees, 1.0f, runInTurn);
    for (const std::size_t i : {std::size_t(0), std::size_t(31), std::size_t(59)}) {
        const ModalMotion alone({trees[i]}, 1.0f, runInTurn);
        const ModalModel &a = all.archetype(i).model(0), &b = alone.archetype(0).model(0);
        EXPECT_EQ(a.poses, b.poses) << forest.nameOf(i);
        EXPECT_EQ(all.factors(i).omegaSquare, alone.factors(0).omegaSquare);
        EXPECT_EQ(all.factors(i).logs.branches, alone.factors(0).logs.branches);
    }
}

TEST(Archetype, AFarPatchIsNearItsNearPatches) {
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

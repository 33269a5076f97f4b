// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace osgTreeWind {
namespace {

constexpr float frame = 1.0f / 60.0f;
using Level = ModalMotion::Level;
using Angles = std::vector<glm::vec2>;

ModalMotion::Tree placed(const GrownTree& tree, const glm::vec3& foot = {0, 0, 0}, float heading = 0.0f) {
    ModalMotion::Tree result;
    result.form = tree.form();
    result.foot = foot;
    result.heading = heading;
    return result;
}

Angles anglesOf(const ModalMotion& motion, std::size_t tree) {
    Angles angles(motion.archetype(tree).model(0).joints / 2);
    motion.angles(tree, angles.data());
    return angles;
}

std::vector<glm::vec3> windsOf(const ModalMotion& motion, std::size_t tree) {
    std::vector<glm::vec3> winds(motion.archetype(tree).model(0).joints / 2);
    motion.winds(tree, winds.data());
    return winds;
}

float largest(const Angles& angles) {
    float most = 0.0f;
    for (const glm::vec2& angle : angles)
        most = std::max(most, glm::length(angle));
    return most;
}

float furthest(const Angles& a, const Angles& b) {
    float most = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, glm::length(a[i] - b[i]));
    return most;
}

void run(ModalMotion& motion, const WindField* wind, int frames, int from = 0) {
    for (int i = from + 1; i <= from + frames; ++i)
        motion.step(wind, i / 60.0, frame);
}

/// Scattered trees of one model in many sizes.
struct Forest {
    std::vector<GrownTree> kinds;
    std::vector<ModalMotion::Tree> trees;

    Forest(std::size_t count, const std::vector<std::string>& names, std::uint64_t seed = 1) {
        Random random(seed);
        for (const std::string& name : names)
            kinds.emplace_back(name, TreeSize{18, 0.3f, 0});
        for (std::size_t i = 0; i < count; ++i) {
            const GrownTree& kind = kinds[random.next() % kinds.size()];
            ModalMotion::Tree tree = placed(kind);
            const float height = 6.0f + 24.0f * random.uniform();
            tree.form.scale = fitTree(kind.model, {height, height * (0.01f + 0.012f * random.uniform()),
                                                   height * (0.3f + 0.3f * random.uniform())});
            tree.foot = {200.0f * random.uniform(), 200.0f * random.uniform(), 5.0f * random.uniform()};
            tree.heading = 6.28f * random.uniform();
            trees.push_back(tree);
        }
    }
};

TEST(ModalMotion, ATreeRotatedWithItsWindMovesAlike) {
    const GrownTree oak("oak", {16, 0.3f, 0});
    const float heading = 1.1f;
    ModalMotion motion({placed(oak), placed(oak, {0, 0, 0}, heading)}, 1.0f, runInTurn);
    ModalMotion turned = ModalMotion({placed(oak, {0, 0, 0}, heading)}, 1.0f, runInTurn);
    const UniformWind wind({7, 2, 0.5f});
    const glm::vec2 c(std::cos(heading), std::sin(heading));
    const UniformWind turnedWind({7 * c.x - 2 * c.y, 7 * c.y + 2 * c.x, 0.5f});
    run(motion, &wind, 240);
    run(turned, &turnedWind, 240);
    const Angles expected = anglesOf(motion, 0);
    EXPECT_LT(furthest(anglesOf(turned, 0), expected), 1e-3f * largest(expected));
    EXPECT_GT(furthest(anglesOf(motion, 1), expected), 0.1f * largest(expected))
        << "in its own frame, a rotated tree has a different wind";
}

TEST(ModalMotion, GainMultipliesTheResponseToASteadyWind) {
    GrownTree oak("oak", {16, 0.4f, 0});
    oak.species.branch.maxAngle = 1.5f;
    oak.species.wood.dampingRatio = 0.5f; // shortens the transient
    const UniformWind wind({4, 1, 0});
    Angles angles[2];
    for (const bool more : {false, true}) {
        ModalMotion motion({placed(oak)}, more ? 3.0f : 1.0f, runInTurn, true);
        run(motion, &wind, 3600);
        angles[more] = anglesOf(motion, 0);
    }
    for (std::size_t i = 0; i < angles[0].size(); ++i)
        EXPECT_LT(glm::length(angles[1][i] - 3.0f * angles[0][i]), 1e-4f * largest(angles[1]))
            << "unit " << i;
}

TEST(ModalMotion, GainDoesNotChangeFrequencyAndDamping) {
    const GrownTree oak("oak", {16, 0.3f, 0});
    ModalMotion plain({placed(oak)}, 1.0f, runInTurn, true), more({placed(oak)}, 3.0f, runInTurn, true);
    std::vector<float> pulled = plain.amplitudes(0);
    for (std::size_t k = 0; k < pulled.size(); ++k)
        pulled[k] = 4.0f / static_cast<float>(k + 1);
    plain.setAmplitudes(0, pulled);
    for (float& amplitude : pulled)
        amplitude *= 3.0f;
    more.setAmplitudes(0, pulled);
    for (int i = 0; i < 600; ++i) {
        run(plain, nullptr, 1, i);
        run(more, nullptr, 1, i);
        const std::vector<float> a = plain.amplitudes(0), b = more.amplitudes(0);
        for (std::size_t k = 0; k < a.size(); ++k)
            ASSERT_NEAR(b[k], 3.0f * a[k], 1e-3f) << "mode " << k << ", frame " << i;
    }
}

TEST(ModalMotion, CrownContactAddsDamping) {
    // x e^(-ratio omega t): 0.05 more damping ratio adds a factor e^(-0.05 omega t).
    GrownTree oak("oak", {16, 0.3f, 0});
    oak.species.wood.dampingRatio = 0.01f;
    ModalMotion alone({placed(oak)}, 1.0f, runInTurn, true), among({placed(oak)}, 1.0f, runInTurn, true);
    among.setNeighbourEffect(0, {1.0f, 1.0f});
    double taken[2] = {}; // logarithmic decrement
    double time = 0.0, omega = 0.0;
    for (ModalMotion* motion : {&alone, &among}) {
        motion->setAmplitudes(0, {1.0e-3f}); // small, so that the air does not damp it
        const ModalModel::Mode& mode = motion->model(0).modes[0];
        omega = static_cast<double>(mode.omega) * std::sqrt(1.0 - static_cast<double>(mode.weightShare));
        const int steps = static_cast<int>(std::round(2.0 * 6.283185307 / omega * 240.0));
        time = steps / 240.0;
        for (int i = 0; i < steps; ++i)
            motion->step(nullptr, i / 240.0, 1.0f / 240.0f);
        taken[motion == &among] = std::log(1.0e-3 / static_cast<double>(motion->amplitudes(0)[0]));
    }
    EXPECT_NEAR((taken[1] - taken[0]) / (omega * time), 0.05, 0.003);
}

TEST(ModalMotion, AReplacedTreeKeepsItsNeighbourEffect) {
    const GrownTree small("oak", {16, 0.3f, 0}), alike("oak", {16.2f, 0.3f, 0}), large("oak", {30, 0.9f, 0});
    ModalMotion motion({placed(small)}, 1.0f, runInTurn);
    motion.setNeighbourEffect(0, {1.0f, 0.5f});
    const float contact = motion.factors(0).contact;
    EXPECT_GT(contact, 0.0f);
    for (const GrownTree* other : {&alike, &large}) {
        motion.replace(0, placed(*other));
        EXPECT_EQ(motion.factors(0).contact, contact);
        EXPECT_EQ(motion.factors(0).shelter, 0.5f);
    }
    motion.remove(0);
    motion.add(0, placed(small));
    EXPECT_EQ(motion.factors(0).shelter, 1.0f) << "the neighbours are not known yet";
}

TEST(ModalMotion, WithoutGainNothingMoves) {
    const GrownTree oak("oak", {16, 0.3f, 0});
    ModalMotion motion({placed(oak)}, 0.0f, runInTurn);
    const UniformWind wind({12, 0, 0});
    run(motion, &wind, 60);
    EXPECT_EQ(largest(anglesOf(motion, 0)), 0.0f);
}

TEST(ModalMotion, ASingleTreeMovesAsInAForest) {
    const Forest forest(60, {"oak", "Norway spruce"});
    const WindFieldPtr wind = gustsOf(8);
    ModalMotion all(forest.trees, 1.0f, runInTurn);
    run(all, wind.get(), 120);
    for (const std::size_t tree : {std::size_t(0), std::size_t(17), std::size_t(59)}) {
        ModalMotion alone({forest.trees[tree]}, 1.0f, runInTurn);
        run(alone, wind.get(), 120);
        EXPECT_EQ(alone.amplitudes(0), all.amplitudes(tree)) << "tree " << tree;
        EXPECT_EQ(anglesOf(alone, 0), anglesOf(all, tree)) << "tree " << tree;
    }
}

TEST(ModalMotion, ResultsDoNotDependOnThreads) {
    const Forest forest(300, {"oak", "Norway spruce"});
    const WindFieldPtr wind = gustsOf(8);
    ModalMotion one(forest.trees, 1.0f, runInTurn);
    for (std::size_t tree = 0; tree < forest.trees.size(); tree += 3)
        one.setLevel(tree, Level::Far);
    run(one, wind.get(), 60);
    for (const unsigned threads : {1u, 2u, 3u}) {
        ModalMotion several(forest.trees, 1.0f, ThreadPool::executor(threads));
        for (std::size_t tree = 0; tree < forest.trees.size(); tree += 3)
            several.setLevel(tree, Level::Far);
        run(several, wind.get(), 60);
        for (std::size_t tree = 0; tree < forest.trees.size(); ++tree) {
            ASSERT_EQ(several.amplitudes(tree), one.amplitudes(tree)) << threads << " threads, tree " << tree;
            ASSERT_EQ(windsOf(several, tree), windsOf(one, tree));
        }
    }
}

TEST(ModalMotion, ATreeTakesAtMostTreeBytes) {
    for (const char* name : {"oak", "Norway spruce"}) {
        const Forest forest(4000, {name});
        const ModalMotion motion(forest.trees, 1.0f, ThreadPool::executor());
        EXPECT_LE(motion.stateBytes(), ModalMotion::treeBytes(Level::Near) * 4000 * 11 / 10)
            << name << ": " << static_cast<double>(motion.stateBytes()) / 4000.0 << " bytes a tree, "
            << motion.archetypeCount() << " archetypes";
    }
}

/// Number of moves of each of 40 far trees in some steps.
std::vector<int> movesOfFarTrees(int steps, float seconds) {
    const Forest forest(40, {"oak"});
    const WindFieldPtr wind = gustsOf(8);
    ModalMotion motion(forest.trees, 1.0f, runInTurn);
    for (std::size_t tree = 0; tree < 40; ++tree)
        motion.setLevel(tree, Level::Far);
    run(motion, wind.get(), 16);
    std::vector<int> moved(40, 0);
    for (int i = 1; i <= steps; ++i) {
        std::vector<std::vector<float>> before;
        for (std::size_t tree = 0; tree < 40; ++tree)
            before.push_back(motion.amplitudes(tree));
        motion.step(wind.get(), 16 * frame + i * seconds, seconds);
        for (std::size_t tree = 0; tree < 40; ++tree)
            moved[tree] += motion.amplitudes(tree) != before[tree];
    }
    return moved;
}

TEST(ModalMotion, FarTreesStepFiveTimesASecondAtAnyFrameRate) {
    for (const float seconds : {0.1f, frame, 0.001f})
        for (const int moves : movesOfFarTrees(static_cast<int>(std::round(3.0f / seconds)), seconds))
            EXPECT_EQ(moves, 15);
}

/// Largest jump of the trunk's foot and of any unit over level changes, over their largest angle.
struct Jumps {
    float foot = 0.0f, any = 0.0f;
};
Jumps jumpsTo(Level level, const GrownTree& tree, float speed) {
    const WindFieldPtr wind = gustsOf(speed);
    ModalMotion motion({placed(tree)}, 1.0f, runInTurn);
    motion.setLevel(0, level == Level::Far ? Level::Near : Level::Far);
    motion.sampleWind(wind.get(), 0.0);
    run(motion, wind.get(), 600);
    Jumps jumps, sizes;
    for (int i = 0; i < 10; ++i) {
        const Angles before = anglesOf(motion, 0);
        const Level other = motion.level(0);
        motion.setLevel(0, level);
        const Angles after = anglesOf(motion, 0);
        jumps.foot = std::max(jumps.foot, glm::length(after[0] - before[0]));
        jumps.any = std::max(jumps.any, furthest(after, before));
        sizes.foot = std::max(sizes.foot, glm::length(before[0]));
        sizes.any = std::max(sizes.any, largest(before));
        motion.setLevel(0, other);
        run(motion, wind.get(), 80, 600 + 80 * i);
    }
    return {jumps.foot / sizes.foot, jumps.any / sizes.any};
}

TEST(ModalMotion, LevelsChangeWithoutJumps) {
    for (const char* name : {"oak", "Norway spruce", "silver birch"}) {
        const GrownTree tree(name, {18, 0.3f, 0});
        for (const float speed : {3.0f, 8.0f}) {
            SCOPED_TRACE(std::string(name) + ", " + std::to_string(speed) + " m/s");
            const Jumps nearer = jumpsTo(Level::Near, tree, speed),
                        farther = jumpsTo(Level::Far, tree, speed);
            EXPECT_LT(nearer.foot, 0.05f);
            EXPECT_LT(nearer.any, 0.2f) << "thin ends of boughs did not move before";
            EXPECT_LT(farther.foot, 0.12f);
            EXPECT_LT(farther.any, 1.0f) << "twigs keep their deflection in the steady wind";
        }
    }
}

TEST(ModalMotion, SettingTheSameLevelChangesNothing) {
    const Forest forest(20, {"oak"});
    const WindFieldPtr wind = gustsOf(8);
    ModalMotion motion(forest.trees, 1.0f, runInTurn);
    run(motion, wind.get(), 60);
    const std::vector<float> before = motion.amplitudes(3);
    const TreeFactors factors = motion.factors(3);
    motion.setLevel(3, Level::Near);
    EXPECT_EQ(motion.amplitudes(3), before);
    motion.setLevel(3, Level::Far);
    const std::vector<float> far = motion.amplitudes(3);
    for (std::size_t k = 0; k < far.size(); ++k)
        EXPECT_EQ(far[k], before[k]) << "mode " << k << " is common to both";
    EXPECT_EQ(motion.factors(3).length, factors.length);
    EXPECT_EQ(motion.factors(3).cosine, factors.cosine);
}

TEST(ModalMotion, ALevelChangeDoesNotAffectOtherTrees) {
    const Forest forest(50, {"oak"});
    const WindFieldPtr wind = gustsOf(8);
    ModalMotion plain(forest.trees, 1.0f, runInTurn), changing(forest.trees, 1.0f, runInTurn);
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const std::size_t tree = 1 + random.next() % 49;
        changing.setLevel(tree, changing.level(tree) == Level::Near ? Level::Far : Level::Near);
        run(plain, wind.get(), 1, i);
        run(changing, wind.get(), 1, i);
        ASSERT_EQ(plain.amplitudes(0), changing.amplitudes(0)) << "frame " << i;
    }
}

TEST(ModalMotion, ResetReturnsToRestInCalm) {
    const Forest forest(20, {"oak"});
    const WindFieldPtr wind = gustsOf(8);
    ModalMotion motion(forest.trees, 1.0f, runInTurn), fresh(forest.trees, 1.0f, runInTurn);
    run(motion, wind.get(), 77);
    motion.reset();
    for (std::size_t tree = 0; tree < 20; ++tree) {
        EXPECT_EQ(largest(anglesOf(motion, tree)), 0.0f);
        for (const glm::vec3& wind : windsOf(motion, tree))
            EXPECT_EQ(wind, glm::vec3(0.0f));
    }
    run(motion, wind.get(), 30);
    run(fresh, wind.get(), 30);
    for (std::size_t tree = 0; tree < 20; ++tree)
        EXPECT_EQ(motion.amplitudes(tree), fresh.amplitudes(tree)) << "tree " << tree;
}

TEST(ModalMotion, SamplingTheWindMovesNothing) {
    const GrownTree oak("oak", {16, 0.3f, 0});
    ModalMotion motion({placed(oak, {3, 4, 5}, 0.7f)}, 1.0f, runInTurn);
    const UniformWind wind({5, -2, 1});
    motion.sampleWind(&wind, 0.0);
    for (const float amplitude : motion.amplitudes(0))
        EXPECT_EQ(amplitude, 0.0f);
    for (const glm::vec3& met : windsOf(motion, 0))
        EXPECT_LT(glm::length(met - glm::vec3(5, -2, 1)), 1e-5f);
}

TEST(ModalMotion, AnglesStayWithinTheLimitOfTheSpecies) {
    GrownTree birch("silver birch", {20, 0.12f, 0});
    birch.species.branch.maxAngle = 0.2f;
    ModalMotion motion({placed(birch)}, 5.0f, runInTurn);
    const UniformWind wind({40, 0, 0});
    for (int i = 0; i < 10; ++i) {
        run(motion, &wind, 30);
        for (const glm::vec2& angle : anglesOf(motion, 0)) {
            EXPECT_LE(std::abs(angle.x), 0.2f);
            EXPECT_LE(std::abs(angle.y), 0.2f);
        }
    }
}

TEST(ModalMotion, ALongStepIsSubdivided) {
    const GrownTree oak("oak", {16, 0.3f, 0});
    ModalMotion motion({placed(oak)}, 1.0f, runInTurn), slow({placed(oak)}, 1.0f, runInTurn);
    const UniformWind wind({8, 0, 0});
    motion.sampleWind(&wind, 0.0);
    slow.sampleWind(&wind, 0.0);
    run(motion, &wind, 60);
    slow.step(&wind, 1.0, 1.0f);
    const Angles a = anglesOf(motion, 0), b = anglesOf(slow, 0);
    EXPECT_LT(furthest(a, b), 0.02f * largest(a));
}

} // namespace
} // namespace osgTreeWind

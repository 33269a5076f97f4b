// SPDX-License-Identifier: MIT
// Trees added, removed and changed while others sway.
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgTreeWind {
namespace {

using Level = ModalMotion::Level;

ModalMotion::Tree placed(const GrownTree& kind, float height, const glm::vec3& foot = {0, 0, 0},
                         float heading = 0.0f) {
    ModalMotion::Tree tree;
    tree.form = kind.form();
    tree.form.scale = fitTree(kind.model, {height, 0.017f * height, 0});
    tree.foot = foot;
    tree.heading = heading;
    return tree;
}

void run(ModalMotion& motion, const WindField& wind, int frames, int from = 0) {
    for (int i = from + 1; i <= from + frames; ++i)
        motion.step(&wind, i / 60.0, 1.0f / 60.0f);
}

std::vector<glm::vec2> jointAngles(const ModalMotion& motion, std::size_t tree) {
    std::vector<glm::vec2> angles(motion.model(tree).joints / 2);
    motion.angles(tree, angles.data());
    return angles;
}

struct ModalChanges : testing::Test {
    GrownTree oak{"oak", {}}, spruce{"Norway spruce", {}};
    WindFieldPtr wind = gustsOf(8);
    Random random{3};

    ModalMotion::Tree anyTree() {
        return placed(random.next() % 2 ? oak : spruce, 6.0f + 24.0f * random.uniform(),
                      {100.0f * random.uniform(), 100.0f * random.uniform(), 0.0f}, 6.28f * random.uniform());
    }
    std::vector<ModalMotion::Tree> anyTrees(std::size_t count) {
        std::vector<ModalMotion::Tree> trees;
        while (trees.size() < count)
            trees.push_back(anyTree());
        return trees;
    }
};

TEST_F(ModalChanges, AnAddedTreeMovesLikeAnInitialOne) {
    const std::vector<ModalMotion::Tree> trees = anyTrees(30);
    ModalMotion all(trees, 1.0f, runInTurn);
    ModalMotion grown({trees.begin(), trees.begin() + 5}, 1.0f, runInTurn);
    for (std::size_t i = 5; i < trees.size(); ++i)
        grown.add(i, trees[i]);
    EXPECT_EQ(grown.treeCount(), 30u);
    EXPECT_EQ(grown.archetypeCount(), all.archetypeCount());
    run(all, *wind, 90);
    run(grown, *wind, 90);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        EXPECT_EQ(grown.amplitudes(i), all.amplitudes(i)) << "tree " << i;
        EXPECT_EQ(jointAngles(grown, i), jointAngles(all, i)) << "tree " << i;
        EXPECT_EQ(grown.lean(i), all.lean(i)) << "tree " << i;
    }
}

TEST_F(ModalChanges, TreesCanBeAddedToAnEmptyForest) {
    ModalMotion motion({}, 1.0f, runInTurn);
    run(motion, *wind, 2);
    EXPECT_FALSE(motion.holds(0));
    motion.add(0, placed(oak, 15));
    run(motion, *wind, 60);
    EXPECT_GT(glm::length(motion.lean(0)), 0.01f);
}

TEST_F(ModalChanges, TheNumberOfARemovedTreeCanBeReused) {
    const std::vector<ModalMotion::Tree> trees = anyTrees(20);
    ModalMotion plain(trees, 1.0f, runInTurn), thinned(trees, 1.0f, runInTurn);
    run(plain, *wind, 60);
    run(thinned, *wind, 60);
    for (const std::size_t tree : {3u, 19u, 0u})
        thinned.remove(tree);
    EXPECT_FALSE(thinned.holds(3));
    EXPECT_TRUE(thinned.holds(4));
    const std::size_t back = 3;
    thinned.add(back, trees[3]);
    EXPECT_EQ(thinned.treeCount(), 20u);
    for (const float amplitude : thinned.amplitudes(back))
        EXPECT_EQ(amplitude, 0.0f) << "it stands at rest";
    run(plain, *wind, 60, 60);
    run(thinned, *wind, 60, 60);
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (thinned.holds(i) && i != back) {
            EXPECT_EQ(thinned.amplitudes(i), plain.amplitudes(i)) << "tree " << i;
        }
}

TEST_F(ModalChanges, AMovedTreeKeepsSwaying) {
    const UniformWind steady({6, 2, 0});
    ModalMotion motion({placed(oak, 15)}, 1.0f, runInTurn), still({placed(oak, 15)}, 1.0f, runInTurn);
    run(motion, steady, 50);
    run(still, steady, 50);
    motion.replace(0, placed(oak, 15, {70, -20, 3}));
    EXPECT_EQ(motion.lean(0), still.lean(0));
    run(motion, steady, 50, 50);
    run(still, steady, 50, 50);
    EXPECT_EQ(motion.amplitudes(0), still.amplitudes(0)) << "the wind is the same there";
    const glm::vec2 before = motion.lean(0);
    motion.replace(0, placed(oak, 15, {70, -20, 3}, 1.5707963f));
    EXPECT_NEAR(motion.lean(0).x, -before.y, 1e-5f) << "and leans with its heading";
    EXPECT_NEAR(motion.lean(0).y, before.x, 1e-5f);
}

TEST_F(ModalChanges, ATreeOfAnotherSizeOrSpeciesKeepsSwaying) {
    const GrownTree birch("silver birch", {});
    for (const Level level : {Level::Near, Level::Far})
        for (const ModalMotion::Tree& other : {placed(oak, 15.5f), placed(oak, 25), placed(birch, 15)}) {
            ModalMotion motion({placed(oak, 15)}, 1.0f, runInTurn);
            motion.setLevel(0, level);
            run(motion, *wind, 241);
            const glm::vec2 before = motion.lean(0);
            motion.replace(0, other);
            EXPECT_EQ(motion.level(0), level);
            EXPECT_LT(glm::distance(motion.lean(0), before), 0.35f * glm::length(before))
                << other.form.species->name << " of axes " << other.form.scale.axes.z;
            ModalMotion fresh({other}, 1.0f, runInTurn);
            fresh.setLevel(0, level);
            for (int settle = 0; settle < 2; ++settle) {
                run(motion, *wind, 1800, 241 + 1800 * settle);
                run(fresh, *wind, 1800, 241 + 1800 * settle);
            }
            const glm::vec2 expected = fresh.lean(0);
            EXPECT_LT(glm::distance(motion.lean(0), expected), 0.03f * glm::length(expected))
                << "the previous tree has no effect";
        }
}

TEST_F(ModalChanges, ATreeReplacedByItselfIsTheSame) {
    const std::vector<ModalMotion::Tree> trees = anyTrees(8);
    ModalMotion plain(trees, 1.0f, runInTurn), replaced(trees, 1.0f, runInTurn);
    for (int i = 0; i < 30; ++i) {
        run(plain, *wind, 1, i);
        run(replaced, *wind, 1, i);
        for (std::size_t tree = 0; tree < 8; ++tree)
            replaced.replace(tree, trees[tree]);
    }
    for (std::size_t tree = 0; tree < 8; ++tree)
        EXPECT_EQ(replaced.amplitudes(tree), plain.amplitudes(tree));
}

TEST_F(ModalChanges, AnyOrderOfChangesKeepsEachTreesState) {
    ModalMotion motion(anyTrees(40), 1.0f, runInTurn);
    std::vector<float> lengths(40);
    std::vector<bool> there(40, true);
    for (std::size_t i = 0; i < 40; ++i)
        lengths[i] = motion.factors(i).length;
    const std::size_t archetypes = motion.archetypeCount();
    for (int i = 0; i < 3000; ++i) {
        const std::size_t tree = random.next() % 40;
        switch (random.next() % 4) {
        case 0:
            motion.remove(tree);
            there[tree] = false;
            break;
        case 1: {
            const auto number =
                static_cast<std::size_t>(std::find(there.begin(), there.end(), false) - there.begin());
            there.resize(std::max(there.size(), number + 1));
            lengths.resize(there.size());
            motion.add(number, anyTree());
            there[number] = true;
            lengths[number] = motion.factors(number).length;
            break;
        }
        case 2:
            if (there[tree]) {
                motion.replace(tree, anyTree());
                lengths[tree] = motion.factors(tree).length;
            }
            break;
        default:
            if (there[tree])
                motion.setLevel(tree, random.next() % 2 ? Level::Far : Level::Near);
            run(motion, *wind, 1, i);
        }
    }
    EXPECT_LT(motion.archetypeCount(), archetypes + 20) << "archetypes are shared";
    for (std::size_t i = 0; i < there.size(); ++i) {
        ASSERT_EQ(motion.holds(i), there[i]) << i;
        if (!there[i])
            continue;
        EXPECT_EQ(motion.factors(i).length, lengths[i]) << i;
        EXPECT_TRUE(std::isfinite(glm::length(motion.lean(i)))) << i;
        EXPECT_LT(glm::length(motion.lean(i)), 30.0f) << i;
    }
}

TEST_F(ModalChanges, ResetCopiesAreTheSameTreesAtRest) {
    ModalMotion motion(anyTrees(30), 1.0f, runInTurn);
    motion.remove(7);
    motion.setLevel(9, Level::Far);
    ModalMotion::Tree last = anyTree();
    motion.add(7, last);
    run(motion, *wind, 100);
    ModalMotion again(motion);
    again.reset();
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(again.lean(i), glm::vec2(0.0f));
        EXPECT_EQ(again.level(i), motion.level(i));
        EXPECT_EQ(&again.archetype(i), &motion.archetype(i)) << "shared";
    }
    ModalMotion fresh({last}, 1.0f, runInTurn);
    run(again, *wind, 50);
    run(fresh, *wind, 50);
    EXPECT_EQ(again.amplitudes(7), fresh.amplitudes(0));
}

} // namespace
} // namespace osgTreeWind

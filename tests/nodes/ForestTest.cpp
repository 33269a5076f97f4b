// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/wind/FunctionWind.h>

#include <osgUtil/CullVisitor>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

using namespace osgTreeWind;

namespace {

/// A forest of one tree whose wind counts its samples.
struct CountedForest {
    std::shared_ptr<std::atomic<int>> calls = std::make_shared<std::atomic<int>>(0);
    osg::ref_ptr<Forest> forest;

    CountedForest() {
        ForestDescription description = smallForest(1);
        description.law = MotionLaw::ThesisSmooth; // samples the wind once per branch unit
        auto count = calls;
        description.wind = std::make_shared<FunctionWind>([count](const glm::vec3&, double) {
            ++*count;
            return glm::vec3(5.0f, 0.0f, 0.0f);
        });
        forest = new Forest(description);
    }
    /// Samples per branch unit.
    int samples() const {
        return *calls /
               static_cast<int>(movingForest(forest->getSimulation()).branches()->windPlaces().size());
    }
};

} // namespace

TEST(ForestTest, SamplesTheWindOncePerFrameNumber) {
    CountedForest counted;
    for (unsigned frame = 1; frame <= 5; ++frame)
        for (int view = 0; view < 3; ++view)
            update(*counted.forest, frame, frame / 25.0);
    EXPECT_EQ(counted.samples(), 5);
}

TEST(ForestTest, IsUpdatedBelowAPlainGroup) {
    CountedForest counted;
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(counted.forest);
    EXPECT_EQ(scene->getNumChildrenRequiringUpdateTraversal(), 1u);
    updateFrames(*scene, 1, 3);
    EXPECT_EQ(counted.samples(), 3);
}

TEST(ForestTest, APauseHoldsTheTrees) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    updateFrames(*forest, 1, 20);
    const std::vector<glm::vec4> held = statesOf(*forest);
    for (unsigned frame = 21; frame < 30; ++frame)
        update(*forest, frame, 20 / 25.0);
    EXPECT_EQ(statesOf(*forest), held);
    update(*forest, 30, 21 / 25.0);
    EXPECT_NE(statesOf(*forest), held) << "and goes on after it";
}

TEST(ForestTest, ANewWindActsInTheNextFrame) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    updateFrames(*forest, 1, 3);
    EXPECT_TRUE(forest->setWind(std::make_shared<UniformWind>(glm::vec3(-3.0f, 2.0f, 1.0f))).empty());
    updateFrames(*forest, 4, 4);
    for (const glm::vec3& sample : windsOf(*forest))
        EXPECT_LT(glm::length(sample - glm::vec3(-3.0f, 2.0f, 1.0f)), 1e-5f);
    EXPECT_TRUE(forest->setWind(nullptr).empty());
    updateFrames(*forest, 5, 5);
    for (const glm::vec3& sample : windsOf(*forest))
        EXPECT_EQ(sample, glm::vec3(0.0f)) << "null is calm";
}

TEST(ForestTest, AnotherThreadMaySetTheWindDuringFrames) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    std::atomic<bool> running{true};
    std::thread simulator([&] {
        for (int i = 0; running; ++i)
            EXPECT_TRUE(forest
                            ->setWind(std::make_shared<UniformWind>(
                                glm::vec3(1.0f + static_cast<float>(i % 9), 0.0f, 0.0f)))
                            .empty());
    });
    for (unsigned frame = 1; frame <= 200; ++frame) {
        update(*forest, frame, frame / 25.0);
        const std::vector<glm::vec3> samples = windsOf(*forest);
        for (const glm::vec3& sample : samples)
            ASSERT_LT(glm::length(sample - samples.front()), 1e-4f) << "one frame, one wind";
    }
    running = false;
    simulator.join();
    EXPECT_GT(windsOf(*forest).front().x, 0.5f);
}

TEST(ForestTest, ANewDescriptionReplacesTheTreesAndKeepsTheHostsChildren) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    osg::ref_ptr<osg::Group> house = new osg::Group;
    forest->addChild(house);
    updateFrames(*forest, 1, 5);
    const osg::ref_ptr<InstancedTrees> former = &instancedTrees(*forest->getInstanced());
    const osg::ref_ptr<BranchTransform> branch = forest->branch(TreeId(0), 2).value();
    EXPECT_TRUE(forest->setDescription(smallForest(5)).empty());
    EXPECT_EQ(forest->getNumTrees(), 5u);
    EXPECT_EQ(former->getNumParents(), 0u);
    EXPECT_NE(forest->branch(TreeId(0), 2).value(), branch) << "of a tree that is gone";
    EXPECT_TRUE(forest->containsNode(house));
    unsigned others = 0;
    for (unsigned i = 0; i < forest->getNumChildren(); ++i)
        others += !forest->isOwnChild(forest->getChild(i));
    EXPECT_EQ(others, 1u);
    updateFrames(*forest, 6, 10);
    former->update(11, 0.4);
}

TEST(ForestTest, ANewDescriptionMayChangeTheLaw) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    ForestDescription ofBranches = smallForest(2);
    ofBranches.law = MotionLaw::ThesisSmooth;
    EXPECT_TRUE(forest->setDescription(ofBranches).empty());
    EXPECT_EQ(forest->getInstanced(), nullptr);
    ASSERT_NE(forest->getBranchwise(), nullptr);
    EXPECT_EQ(forest->branch(TreeId(1), 2).value(),
              branchwiseTrees(*forest->getBranchwise()).nodes()[1]->getBranch(2));
    EXPECT_FALSE(forest->addTree(TreePlacement()).ok()) << "under modal only";
    EXPECT_FALSE(forest->removeTree(TreeId(0)).empty());
    updateFrames(*forest, 1, 5);
    EXPECT_TRUE(forest->setDescription(smallForest(3)).empty());
    EXPECT_NE(forest->getInstanced(), nullptr);
    EXPECT_EQ(forest->getBranchwise(), nullptr);
    updateFrames(*forest, 6, 10);
}

TEST(ForestTest, ADescriptionWithoutWindKeepsTheWind) {
    const auto streamed = std::make_shared<UniformWind>(glm::vec3(-3.0f, 2.0f, 0.0f));
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    EXPECT_TRUE(forest->setWind(streamed).empty());
    ForestDescription windless = smallForest(2);
    windless.wind = nullptr;
    EXPECT_TRUE(forest->setDescription(windless).empty());
    EXPECT_EQ(forest->getWind().field, streamed);
    updateFrames(*forest, 1, 1);
    EXPECT_EQ(windsOf(*forest).front(), glm::vec3(-3.0f, 2.0f, 0.0f));

    const ForestDescription windy = smallForest(1, 7.0f);
    EXPECT_TRUE(forest->setDescription(windy).empty());
    EXPECT_EQ(forest->getWind().field, windy.wind.field) << "the wind of the description has priority";
    updateFrames(*forest, 2, 2);
    EXPECT_EQ(windsOf(*forest).front(), glm::vec3(7.0f, 0.0f, 0.0f));
}

TEST(ForestTest, AnotherThreadMaySetTheWindDuringSetDescription) {
    ForestDescription windless = smallForest(1);
    windless.wind = nullptr;
    osg::ref_ptr<Forest> forest = new Forest(windless);
    std::atomic<bool> running{true};
    WindFieldPtr last;
    std::thread simulator([&] {
        while (running) {
            last = std::make_shared<UniformWind>(glm::vec3(1.0f, 0.0f, 0.0f));
            EXPECT_TRUE(forest->setWind(last).empty());
        }
    });
    for (unsigned frame = 1; frame <= 20; ++frame) {
        EXPECT_TRUE(forest->setDescription(windless).empty());
        update(*forest, frame, frame / 25.0);
    }
    running = false;
    simulator.join();
    EXPECT_EQ(forest->getWind().field, last) << "no wind was lost";
}

TEST(ForestTest, TheHostsExecutorRunsItAndItsCopies) {
    std::atomic<int> calls{0};
    const Executor lent = [&](std::size_t count, const std::function<void(std::size_t)>& job) {
        ++calls;
        runInTurn(count, job);
    };
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    forest->setExecutor(lent);
    update(*forest, 1, 0.04);
    EXPECT_GT(calls, 0);
    osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    int before = calls;
    update(*copy, 1, 0.04);
    EXPECT_GT(calls, before);
    before = calls;
    EXPECT_TRUE(forest->setDescription(smallForest(3)).empty());
    EXPECT_GT(calls, before) << "also for a new description";
    forest->setExecutor(nullptr);
    before = calls;
    update(*forest, 2, 0.08);
    EXPECT_EQ(calls, before);
    EXPECT_TRUE(Forest::create(smallForest(1), lent));
    EXPECT_GT(calls, before) << "also in create()";
}

TEST(ForestTest, ARejectedDescriptionChangesNothing) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    const WindFieldPtr wind = forest->getWind().field;
    ForestDescription stranger = smallForest(2);
    stranger.trees[1].species = 7;
    const Diagnostics problems = forest->setDescription(stranger);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems.front().text(), "tree[1].species: there is no species 7; the forest has 1, from 0 on");
    {
        const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "10M");
        ForestDescription many = smallForest(1);
        many.trees.resize(1000, many.trees[0]);
        const Diagnostics tooLarge = forest->setDescription(many);
        ASSERT_EQ(tooLarge.size(), 1u);
        EXPECT_EQ(tooLarge.front().text().rfind("1000 trees of these species need about ", 0), 0u)
            << tooLarge.front().text();
    }
    EXPECT_EQ(forest->getNumTrees(), 3u);
    EXPECT_EQ(forest->getWind().field, wind);
    updateFrames(*forest, 1, 2);
}

TEST(ForestTest, TheConstructorWarnsOfAnInvalidDescription) {
    ForestDescription endless = smallForest(2);
    endless.trees[1].position.x = NAN;
    endless.trees[1].leaves = -1.0f;
    const ScopedMessages messages;
    osg::ref_ptr<Forest> forest = new Forest(endless);
    EXPECT_EQ(
        messages.take(),
        "osgTreeWind: the forest is left empty: tree[1].position: expected finite numbers in "
        "[-100000000, 100000000], found nan\ntree[1].leaves: expected a finite number in [0, 1], found -1\n");
    EXPECT_EQ(forest->getNumTrees(), 0u);
    EXPECT_TRUE(forest->setDescription(smallForest(2)).empty());
    EXPECT_EQ(forest->getNumTrees(), 2u) << "and may be filled again";
}

TEST(ForestTest, CreateReturnsProblems) {
    const Result<osg::ref_ptr<Forest>> made = Forest::create(smallForest(3));
    ASSERT_TRUE(made);
    EXPECT_EQ(made.value()->getNumTrees(), 3u);
    ForestDescription endless = smallForest(2);
    endless.trees[1].size.height = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(Forest::create(endless).ok()) << "check() says more";
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "10M");
    ForestDescription many = smallForest(1);
    many.trees.resize(1000, many.trees[0]);
    const Result<osg::ref_ptr<Forest>> tooLarge = Forest::create(many);
    ASSERT_FALSE(tooLarge);
    EXPECT_EQ(tooLarge.problems().front().text().rfind("1000 trees of these species need about ", 0), 0u)
        << tooLarge.problems().front().text();
}

TEST(ForestTest, ReadReturnsTheForestOfAFileOrItsProblems) {
    TemporaryFolder folder;
    const std::string species = "version = 1\n[[species]]\nname = \"a\"\n";
    const auto good =
        Forest::read(folder.write("good.treewind", species + "[[tree]]\nposition = [1, 2, 0]\n"));
    ASSERT_TRUE(good) << toString(good.problems());
    EXPECT_EQ(good.value()->getNumTrees(), 1u);
    const auto bad = Forest::read(folder.write("bad.treewind", species + "[[tree]]\nposition = 1\n"));
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.problems().front().line, 5);
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "1");
    const auto large = Forest::read(folder.path() + "/good.treewind");
    ASSERT_FALSE(large);
    EXPECT_EQ(large.problems().front().file, folder.path() + "/good.treewind");
}

TEST(ForestTest, ADefaultForestIsEmptyAndRuns) {
    osg::ref_ptr<Forest> forest = new Forest;
    updateFrames(*forest, 1, 3);
    EXPECT_EQ(forest->getNumTrees(), 0u);
    EXPECT_FALSE(forest->getBound().valid());
    EXPECT_EQ(forest->getOrigin(), osg::Vec3d());
}

TEST(ForestTest, AnUpdateWithoutFrameStampDoesNothing) {
    CountedForest counted;
    osgUtil::UpdateVisitor visitor;
    counted.forest->accept(visitor);
    EXPECT_EQ(counted.samples(), 0);
}

TEST(ForestTest, TreesOfASpeciesShareTheirShapes) {
    const auto geometries = [](int trees) {
        osg::ref_ptr<Forest> forest = new Forest(smallForest(trees));
        return movingForest(forest->getSimulation()).models().size();
    };
    EXPECT_EQ(geometries(2), 2u);
    EXPECT_EQ(geometries(40), 2u) << "memory grows with shapes, not trees";
}

TEST(ForestTest, MotionIsTheSameFarFromTheWorldOrigin) {
    ForestDescription close = smallForest(3), distant = smallForest(3);
    distant.origin = {4.3e5, 4.5e6, 1402.0};
    for (TreePlacement& tree : distant.trees)
        tree.position += distant.origin;
    osg::ref_ptr<Forest> here = new Forest(close), there = new Forest(distant);
    EXPECT_EQ(there->getOrigin(), osg::Vec3d(4.3e5, 4.5e6, 1402.0));
    updateFrames(*here, 1, 20);
    updateFrames(*there, 1, 20);
    for (unsigned i = 0; i < 3; ++i)
        EXPECT_EQ(movingForest(there->getSimulation()).trees()[i].position,
                  movingForest(here->getSimulation()).trees()[i].position);
    EXPECT_EQ(there->getBound().center(), here->getBound().center());
    EXPECT_EQ(statesOf(*there), statesOf(*here));
}

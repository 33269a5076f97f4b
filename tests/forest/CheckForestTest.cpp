// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/CheckForest.h>

#include <gtest/gtest.h>

#include <cmath>

#include <limits>

namespace osgTreeWind {

namespace {

/// The problems of a small sound forest after a change.
std::vector<std::string> problemsAfter(void (*spoil)(ForestDescription&)) {
    ForestDescription forest;
    forest.species.emplace_back().name = "oak";
    forest.species.back().tree.grown.emplace();
    forest.trees.emplace_back();
    spoil(forest);
    std::vector<std::string> texts;
    for (const Diagnostic& problem : check(forest))
        texts.push_back(problem.text());
    return texts;
}
using Texts = std::vector<std::string>;

} // namespace

TEST(CheckForest, FindsNothingInASoundForest) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].size.height = -1.0f; }), Texts())
        << "a size that is not above 0 is not given";
}

TEST(CheckForest, SaysWhatIsOutOfRangeAndWhere) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.gain = 101.0f; }),
              Texts{"motion.gain: expected a finite number in [0, 100], found 101"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  f.law = MotionLaw::Damped;
                  f.damage = true;
              }),
              Texts{"motion.damage: expected false under any law but \"modal\""});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.noiseExponent = 4.0f; }),
              Texts{"motion.noise_exponent: expected a finite number in [0, 3]"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.step = -1.0; }),
              Texts{"step: expected a finite number in [0, 60]"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.season = -1.0f; }),
              Texts{"season: expected a finite number in [0, 4]"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.drawing.budget = NAN; }),
              Texts{"drawing.budget: expected a finite number in [0, 10000], found nan"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.drawing.full = 50.0f; }),
              Texts{"drawing.reduced: expected reduced below full, found 250 and 50"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.species[0].name.clear(); }),
              Texts{"species[0].name: missing"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.species[0].shapes = 65; }),
              Texts{"species[0].shapes: expected a whole number in [1, 64], found 65"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.species[0].tree.grown->radius = 4.0f; }),
              Texts{"species[0].growth.radius: expected at most a quarter of the height"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.species[0].tree.leaves.droop = -2.0f; }),
              Texts{"species[0].leaves.droop: expected a finite number in [-1, 1], found -2"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].heading = 7.0f; }),
              Texts{"tree[0].heading: expected a finite number in [-360, 360], found 401.0704650878906"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].size.crownWidth = 151.0f; }),
              Texts{"tree[0].crown_width: expected a finite number in (0, 150], found 151"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].species = 1; }),
              Texts{"tree[0].species: no species 1"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].position.x = 100001.0; }),
              Texts{"tree[0].position: more than 100 km from the origin"});
}

TEST(CheckForest, StopsAfterAHundredProblems) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  f.trees[0].leaves = std::numeric_limits<float>::quiet_NaN();
                  f.trees.resize(1000, f.trees[0]);
              }).size(),
              100u);
}

} // namespace osgTreeWind

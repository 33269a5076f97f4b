// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/CheckForest.h>

#include <gtest/gtest.h>

#include <cmath>

#include <limits>

namespace osgTreeWind {

namespace {

/// The problems of a small valid forest after a change.
std::vector<std::string> problemsAfter(void (*spoil)(ForestDescription&)) {
    ForestDescription forest;
    forest.species.emplace_back().name = "oak";
    forest.species.back().tree.palm.emplace();
    forest.trees.emplace_back();
    spoil(forest);
    std::vector<std::string> texts;
    for (const Diagnostic& problem : check(forest))
        texts.push_back(problem.text());
    return texts;
}
using Texts = std::vector<std::string>;

} // namespace

TEST(CheckForest, AcceptsAValidForest) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].size.height = -1.0f; }), Texts())
        << "0 and less means not given";
}

TEST(CheckForest, ReportsValuesOutOfRangeWithTheirKey) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.gain = 101.0f; }),
              Texts{"motion.gain: expected a finite number in [0, 100], found 101"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  f.law = MotionLaw::ThesisSmooth;
                  f.damage = true;
              }),
              Texts{"motion.damage: expected false, since the law is not \"modal\""});
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
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.species[0].shapes = 65; }),
              Texts{"species[0].shapes: expected a whole number in [1, 64], found 65"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.species[0].tree.palm->height = 0.8f; }),
              Texts{"species[0].palm.trunk_diameter: expected at most half the height of the stem"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.species[0].tree.leaves.droop = -2.0f; }),
              Texts{"species[0].leaves.droop: expected a finite number in [-1, 1], found -2"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].heading = 2e4f; }),
              Texts{"tree[0].heading: expected a finite number in [-1000000, 1000000] degrees, found "
                    "1145915.625 degrees"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].size.crownWidth = 151.0f; }),
              Texts{"tree[0].crown_width: expected a finite number in (0, 150], found 151"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].species = 1; }),
              Texts{"tree[0].species: there is no species 1; the forest has 1, from 0 on"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].position.x = 100001.0; }),
              Texts{"tree[0].position: expected at most 100 km from the origin"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].position.z = NAN; }),
              Texts{"tree[0].position: expected finite numbers in [-100000000, 100000000], found nan"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.trees[0].size.height = -INFINITY; }),
              Texts{"tree[0].height: expected a finite number in (0, 150], found -inf"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.origin.y = 1e30; })[0],
              "origin: expected finite numbers in [-100000000, 100000000], found 1e+30");
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.canopy.height = 0.0; }),
              Texts{"wind.canopy_height: expected a finite number in [1, 150], found 0"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.wind.frame = static_cast<WindFrame>(9); }),
              Texts{"wind.frame: expected a value of the enumeration, found 9"});
}

TEST(CheckForest, ChecksTilesAndScans) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) { f.tiles.emplace().tiles.resize(3); }),
              (Texts{"tiles.columns: expected a finite number in [1, 10000], found 0",
                     "tiles.rows: expected a finite number in [1, 10000], found 0"}));
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  f.tiles.emplace().columns = 2;
                  f.tiles->tiles.resize(3);
              }),
              Texts{"tiles.trees: expected whole rows"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  f.species[0].tree.scans = std::make_shared<const std::vector<ScannedTree>>();
              }),
              Texts{"species[0].scan: expected at least one"});
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  ScannedTree scan = makeScannedTree({{{0, 0, 0}, {0, 0, 5}, 0.1, -1, 0}}).value();
                  scan.skeleton.units[0].parent = 0;
                  f.species[0].tree.scans = std::make_shared<const std::vector<ScannedTree>>(1, scan);
              }),
              Texts{"species[0].scan[0]: unit 0: expected a parent before it, found 0"});
}

TEST(CheckForest, StopsAfterAHundredProblems) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  f.trees[0].leaves = std::numeric_limits<float>::quiet_NaN();
                  f.trees.resize(1000, f.trees[0]);
              }).size(),
              100u);
}

} // namespace osgTreeWind

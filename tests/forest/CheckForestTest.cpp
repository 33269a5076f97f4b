// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/CheckForest.h>

#include <tests/base/IsProblem.h>

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
    struct Spoilt {
        const char *key, *part;
        void (*spoil)(ForestDescription&);
    };
    using F = ForestDescription;
    for (const Spoilt& spoilt : std::vector<Spoilt>{
             {"motion.gain", "[0, 100], found 101", [](F& f) { f.gain = 101.0f; }},
             {"motion.damage", "the law is not \"modal\"",
              [](F& f) {
                  f.law = MotionLaw::ThesisSmooth;
                  f.damage = true;
              }},
             {"motion.noise_exponent", "[0, 3]", [](F& f) { f.noiseExponent = 4.0f; }},
             {"step", "[0, 60]", [](F& f) { f.step = -1.0; }},
             {"season", "[0, 4]", [](F& f) { f.season = -1.0f; }},
             {"drawing.budget", "found nan", [](F& f) { f.drawing.budget = NAN; }},
             {"drawing.reduced", "below full, found 250 and 50", [](F& f) { f.drawing.full = 50.0f; }},
             {"species[0].shapes", "whole number in [1, 64], found 65",
              [](F& f) { f.species[0].shapes = 65; }},
             {"species[0].palm.trunk_diameter", "half the height",
              [](F& f) { f.species[0].tree.palm->height = 0.8f; }},
             {"species[0].leaves.droop", "[-1, 1], found -2",
              [](F& f) { f.species[0].tree.leaves.droop = -2.0f; }},
             {"species[0].name", "expected UTF-8", [](F& f) { f.species[0].name = "\xe9"; }},
             {"species[0].aliases", "expected UTF-8", [](F& f) { f.species[0].aliases = {"ch\xeane"}; }},
             {"species[0].source", "expected UTF-8", [](F& f) { f.species[0].source = "\xff"; }},
             {"host_crs", "expected UTF-8", [](F& f) { f.hostCrs = "\xd6sterreich"; }},
             {"tree[0].id", "expected UTF-8",
              [](F& f) {
                  f.trees[0].name = "Stra\xdf"
                                    "e";
              }},
             {"tree[0].heading", "[-1000000, 1000000] degrees, found 1145915.625 degrees",
              [](F& f) { f.trees[0].heading = 2e4f; }},
             {"tree[0].crown_width", "(0, 150], found 151",
              [](F& f) { f.trees[0].size.crownWidth = 151.0f; }},
             {"tree[0].species", "no species 1; the forest has 1", [](F& f) { f.trees[0].species = 1; }},
             {"tree[0].position", "100 km from the origin", [](F& f) { f.trees[0].position.x = 100001.0; }},
             {"tree[0].position", "[-100000000, 100000000], found nan",
              [](F& f) { f.trees[0].position.z = NAN; }},
             {"tree[0].height", "found -inf", [](F& f) { f.trees[0].size.height = -INFINITY; }},
             {"wind.canopy_height", "[1, 150], found 0", [](F& f) { f.canopy.height = 0.0; }},
             {"wind.frame", "found 9", [](F& f) { f.wind.frame = static_cast<WindFrame>(9); }},
             {"tiles.trees", "whole rows",
              [](F& f) {
                  f.tiles.emplace().columns = 2;
                  f.tiles->tiles.resize(3);
              }},
             {"species[0].scan", "at least one",
              [](F& f) { f.species[0].tree.scans = std::make_shared<const std::vector<ScannedTree>>(); }},
             {"species[0].scan[0]", "unit 0: expected a parent before it", [](F& f) {
                  ScannedTree scan = makeScannedTree({{{0, 0, 0}, {0, 0, 5}, 0.1, -1, 0}}).value();
                  scan.skeleton.units[0].parent = 0;
                  f.species[0].tree.scans = std::make_shared<const std::vector<ScannedTree>>(1, scan);
              }}}) {
        const Texts problems = problemsAfter(spoilt.spoil);
        ASSERT_EQ(problems.size(), 1u) << spoilt.key;
        EXPECT_TRUE(isProblem(problems[0], spoilt.key, spoilt.part));
    }
}

TEST(CheckForest, ReportsSeveralProblems) {
    const Texts tiles = problemsAfter([](ForestDescription& f) { f.tiles.emplace().tiles.resize(3); });
    ASSERT_EQ(tiles.size(), 2u);
    EXPECT_TRUE(isProblem(tiles[0], "tiles.columns", "[1, 10000], found 0"));
    EXPECT_TRUE(isProblem(tiles[1], "tiles.rows", "[1, 10000], found 0"));
    const Texts far = problemsAfter([](ForestDescription& f) { f.origin.y = 1e30; });
    EXPECT_TRUE(isProblem(far.at(0), "origin", "found 1e+30"));
}

TEST(CheckForest, StopsAfterAHundredProblems) {
    EXPECT_EQ(problemsAfter([](ForestDescription& f) {
                  f.trees[0].leaves = std::numeric_limits<float>::quiet_NaN();
                  f.trees.resize(1000, f.trees[0]);
              }).size(),
              100u);
}

} // namespace osgTreeWind

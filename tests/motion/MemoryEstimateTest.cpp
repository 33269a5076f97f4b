// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>

#include <osgTreeWind/motion/MemoryEstimate.h>

#include <gtest/gtest.h>

#include <cstdint>

namespace osgTreeWind {
namespace {

ForestDescription forestOf(std::size_t trees, MotionLaw law = MotionLaw::ThesisSmooth) {
    ForestDescription forest;
    forest.species = {Species()};
    forest.species.front().shapes = 1;
    forest.trees.resize(trees);
    forest.law = law;
    return forest;
}

TEST(MemoryEstimate, GrowsLinearlyWithTheTrees) {
    const MemoryEstimate none = estimateMemory(forestOf(0)), few = estimateMemory(forestOf(10)),
                         many = estimateMemory(forestOf(20));
    EXPECT_GT(none.simulation, 0u) << "shapes";
    EXPECT_GT(none.nodes, 0u) << "geometry";
    EXPECT_EQ(few.simulation - none.simulation, many.simulation - few.simulation);
    EXPECT_EQ(few.nodes - none.nodes, many.nodes - few.nodes);
}

/// Measured resident memory with 1000 trees: 45 kB per simulated tree, 96 kB with undrawn nodes.
TEST(MemoryEstimate, MatchesMeasurementsForTheReferenceTree) {
    const MemoryEstimate none = estimateMemory(forestOf(0)), all = estimateMemory(forestOf(1000));
    EXPECT_NEAR(static_cast<double>(all.simulation - none.simulation), 45e6, 10e6);
    EXPECT_NEAR(static_cast<double>(all.nodes - none.nodes), 80e6, 30e6);
}

TEST(MemoryEstimate, UnderModalATreeTakesFewBytes) {
    const MemoryEstimate some = estimateMemory(forestOf(10000, MotionLaw::Modal)), // fills the pose texture
        all = estimateMemory(forestOf(210000, MotionLaw::Modal));
    EXPECT_LT((all.simulation - some.simulation) / 200000, 500u);
    EXPECT_LT((all.nodes - some.nodes) / 200000, 1500u);
    EXPECT_LT(all.simulation + all.nodes, 3000000000u);
}

TEST(MemoryEstimate, ProblemStatesTheRequirementAndTheLimit) {
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "100M");
    EXPECT_EQ(problemOfMemory(forestOf(1000), false), "");
    EXPECT_EQ(problemOfMemory(forestOf(1000), true).rfind("1000 trees of these species need about 1", 0), 0u);
    const std::string problem = problemOfMemory(forestOf(1000000), false);
    EXPECT_EQ(problem.rfind("1000000 trees of these species need about ", 0), 0u) << problem;
    EXPECT_NE(problem.find(" GB of memory; the limit is 100 MB (set another with OSGTREEWIND_MAX_MEMORY)"),
              std::string::npos)
        << problem;
}

} // namespace
} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>

#include <osgTreeWind/motion/ForestMemory.h>

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

TEST(ForestMemory, GrowsEvenlyWithTheTrees) {
    const ForestMemory none = forestMemory(forestOf(0)), few = forestMemory(forestOf(10)),
                       many = forestMemory(forestOf(20));
    EXPECT_GT(none.simulation, 0u) << "shapes";
    EXPECT_GT(none.nodes, 0u) << "geometry";
    EXPECT_EQ(few.simulation - none.simulation, many.simulation - few.simulation);
    EXPECT_EQ(few.nodes - none.nodes, many.nodes - few.nodes);
}

/// Resident memory of 1000 trees was 45 kB a tree simulated, 96 kB with nodes not yet drawn.
TEST(ForestMemory, OfTheReferenceTreeIsWhatWasMeasured) {
    const ForestMemory none = forestMemory(forestOf(0)), all = forestMemory(forestOf(1000));
    EXPECT_NEAR(static_cast<double>(all.simulation - none.simulation), 45e6, 10e6);
    EXPECT_NEAR(static_cast<double>(all.nodes - none.nodes), 80e6, 30e6);
}

TEST(ForestMemory, UnderModalATreeTakesFewBytes) {
    const ForestMemory some =
                           forestMemory(forestOf(10000, MotionLaw::Modal)), // all poses that a texture holds
        all = forestMemory(forestOf(210000, MotionLaw::Modal));
    EXPECT_LT((all.simulation - some.simulation) / 200000, 500u);
    EXPECT_LT((all.nodes - some.nodes) / 200000, 1500u);
    EXPECT_LT(all.simulation + all.nodes, 3000000000u);
}

TEST(ForestMemory, ProblemNamesWhatIsNeededAndTheLimit) {
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "100M");
    EXPECT_EQ(problemOfMemory(forestOf(1000), false), "");
    EXPECT_EQ(problemOfMemory(forestOf(1000), true).rfind("1000 trees of these species need about 1", 0), 0u);
    const std::string problem = problemOfMemory(forestOf(1000000), false);
    EXPECT_EQ(problem.rfind("1000000 trees of these species need about ", 0), 0u) << problem;
    EXPECT_NE(problem.find(" GB of memory; the limit is 100 MB (OSGTREEWIND_MAX_MEMORY sets another)"),
              std::string::npos)
        << problem;
}

} // namespace
} // namespace osgTreeWind

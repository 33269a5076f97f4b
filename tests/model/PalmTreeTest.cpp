// SPDX-License-Identifier: MIT
#include <tests/model/ModelTestCases.h>

#include <osgTreeWind/model/PalmTree.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace osgTreeWind {
namespace {

float reach(const glm::vec3& point) {
    return glm::length(glm::vec2(point.x, point.y));
}

TEST(PalmTree, FrondsFillTheCrownAndDoNotExceedIt) {
    for (std::uint32_t seed = 1; seed < 9; ++seed) {
        PalmParameters p;
        p.seed = seed;
        const Skeleton palm = makePalmTree(p);
        EXPECT_EQ(palm.units.size(), 5u + 48u);
        float widest = 0.0f, highest = 0.0f;
        for (const glm::vec3& point : palm.points) {
            widest = std::max(widest, 2.0f * reach(point));
            highest = std::max(highest, point.z);
        }
        EXPECT_NEAR(widest, p.crownWidth, 0.1f);
        EXPECT_LE(highest, p.height + 1e-3f);
        EXPECT_GT(highest, 0.95f * p.height);
    }
}

TEST(PalmTree, TheStemHasTheGivenDiameterAndIsBareBelowTheFronds) {
    const PalmParameters p;
    const Skeleton palm = makePalmTree(p);
    const BranchUnit& foot = palm.units.front();
    EXPECT_NEAR(2.0f * glm::mix(foot.baseRadius, foot.tipRadius, 1.3f / foot.tip.z), p.trunkDiameter, 0.002f);
    for (const BranchUnit& unit : palm.units)
        if (unit.level == 1) {
            EXPECT_GE(unit.base.z, 0.95f * p.crownBase * p.height);
        }
}

TEST(PalmTree, OldFrondsHangAndYoungOnesStandUp) {
    const Skeleton palm = makePalmTree({});
    std::vector<glm::vec3> starts;
    for (std::size_t i = 0; i < palm.units.size(); ++i)
        if (palm.units[i].level == 1)
            starts.push_back(palm.tangent(i, 0));
    EXPECT_LT(starts.front().z, -0.4f);
    EXPECT_GT(starts.back().z, 0.8f);
    for (std::size_t i = 0; i < palm.units.size(); ++i)
        if (palm.units[i].level == 1) {
            EXPECT_LE(palm.tangent(i, palm.ringsPerBranch - 1).z, palm.tangent(i, 0).z + 0.05f);
        }
}

TEST(PalmTree, NoParametersMakeAnyPartDegenerate) {
    using Limits = std::numeric_limits<float>;
    for (const float value : {0.0f, -1e30f, 1e30f, Limits::infinity(), Limits::quiet_NaN()})
        for (const int fronds : {-3, 0, 1, 9999}) {
            PalmParameters p;
            p.height = p.trunkDiameter = p.crownWidth = p.crownBase = p.trunk = p.trunkTaper = value;
            p.trunkCrook = p.flare = p.inclination = p.inclinationEnd = p.droop = p.frondRadius = value;
            p.fronds = fronds;
            const Skeleton palm = makePalmTree(p);
            ASSERT_EQ(palm.points.size(), palm.units.size() * static_cast<std::size_t>(palm.ringsPerBranch));
            ASSERT_LE(palm.units.size(), 205u);
            for (std::size_t i = 0; i < palm.units.size(); ++i) {
                const BranchUnit& unit = palm.units[i];
                ASSERT_EQ(unit.parent < 0, i == 0);
                ASSERT_LT(unit.parent, static_cast<int>(i));
                ASSERT_EQ(palm.point(i, 0), unit.base);
                ASSERT_EQ(palm.point(i, palm.ringsPerBranch - 1), unit.tip);
                ASSERT_GT(unit.tipRadius, 0.0f);
                ASSERT_LE(unit.tipRadius, unit.baseRadius);
                ASSERT_GT(glm::distance(unit.base, unit.tip), 0.0f);
                for (int ring = 0; ring < palm.ringsPerBranch; ++ring)
                    ASSERT_TRUE(isFinite(palm.point(i, ring)) && isFinite(palm.tangent(i, ring)));
            }
        }
}

TEST(PalmTree, ASeedDeterminesThePalm) {
    PalmParameters p;
    const std::uint64_t first = fingerprint(makePalmTree(p).points);
    EXPECT_EQ(fingerprint(makePalmTree(p).points), first);
    p.seed = 2;
    EXPECT_NE(fingerprint(makePalmTree(p).points), first);
}

} // namespace
} // namespace osgTreeWind

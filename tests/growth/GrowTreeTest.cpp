// SPDX-License-Identifier: MIT
#include <tests/growth/HabitCases.h>
#include <tests/growth/SameForm.h>

#include <osgTreeWind/growth/GrowTree.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <vector>

namespace osgTreeWind {
namespace {

GrownForm makeForm(const TreeHabit& habit, const GrowthSite& site, const GrowthGoal& goal,
                   std::uint32_t seed) {
    GrowthParameters parameters;
    parameters.habit = habit;
    parameters.site = site;
    parameters.size = goal;
    parameters.seed = seed;
    return growTree(parameters);
}

float heightOf(const GrownForm& form) {
    float height = 0.0f;
    for (const GrownMetamer& metamer : form.metamers)
        if (!metamer.dead)
            height = std::max(height, metamer.position.z);
    return height;
}

/// Twice the mean reach in eight directions.
float widthOf(const GrownForm& form) {
    float sum = 0.0f;
    for (int i = 0; i < 8; ++i) {
        const float azimuth = glm::radians(45.0f * static_cast<float>(i));
        float reach = 0.0f;
        for (const GrownMetamer& metamer : form.metamers)
            if (!metamer.dead)
                reach = std::max(reach, metamer.position.x * std::cos(azimuth) +
                                            metamer.position.y * std::sin(azimuth));
        sum += reach;
    }
    return sum / 4.0f;
}

/// Radius of the stem at a height, interpolated between the adjacent nodes.
float stemRadius(const GrownForm& form, float height) {
    const GrownMetamer* below = &form.metamers.front();
    for (const GrownMetamer& metamer : form.metamers) {
        if (metamer.axis != 0)
            continue;
        if (metamer.position.z >= height && metamer.position.z > below->position.z)
            return glm::mix(below->radius, metamer.radius,
                            (height - below->position.z) / (metamer.position.z - below->position.z));
        below = &metamer;
    }
    return 0.0f;
}

/// Height below which a twentieth of the leaves are / tree height.
float lowestLeaves(const GrownForm& form) {
    float all = 0.0f, below = 0.0f, height = 0.0f;
    for (const GrownMetamer& metamer : form.metamers)
        all += metamer.leafArea;
    for (; below < 0.05f * all; height += 0.1f) {
        below = 0.0f;
        for (const GrownMetamer& metamer : form.metamers)
            below += metamer.position.z < height ? metamer.leafArea : 0.0f;
    }
    return height / heightOf(form);
}

/// Leaf area in the lowest quarter, m². @param side sign of x.
float lowLeaves(const GrownForm& form, float side) {
    float area = 0.0f;
    const float low = 0.25f * heightOf(form);
    for (const GrownMetamer& metamer : form.metamers)
        if (metamer.position.z < low && side * metamer.position.x > 0.3f)
            area += metamer.leafArea;
    return area;
}

/// Expects the properties that every form has.
void expectValid(const GrownForm& form) {
    ASSERT_FALSE(form.metamers.empty());
    ASSERT_EQ(form.metamers[0].parent, -1);
    for (std::size_t i = 0; i < form.metamers.size(); ++i) {
        const GrownMetamer& metamer = form.metamers[i];
        for (const float value : {metamer.position.x, metamer.position.y, metamer.position.z, metamer.radius,
                                  metamer.light, metamer.leafArea})
            ASSERT_TRUE(std::isfinite(value)) << "metamer " << i;
        ASSERT_GT(metamer.radius, 0.0f) << "metamer " << i;
        ASSERT_GE(metamer.light, 0.0f);
        ASSERT_LE(metamer.light, 1.001f);
        if (i == 0)
            continue;
        ASSERT_GE(metamer.parent, 0);
        ASSERT_LT(metamer.parent, static_cast<int>(i));
        const GrownMetamer& parent = form.metamers[static_cast<std::size_t>(metamer.parent)];
        ASSERT_LE(metamer.radius, parent.radius) << "metamer " << i << " is thicker than its parent";
        if (metamer.axis != parent.axis) {
            ASSERT_LT(metamer.radius, 0.9f * parent.radius) << "branch " << i;
        }
    }
}

TEST(GrowTree, OneSeedGivesOneTree) {
    const GrownForm form = makeForm(oakHabit(), {}, {12.0f, 0.4f, 9.0f}, 7);
    EXPECT_TRUE(sameBits(form, makeForm(oakHabit(), {}, {12.0f, 0.4f, 9.0f}, 7)));
    EXPECT_FALSE(sameBits(form, makeForm(oakHabit(), {}, {12.0f, 0.4f, 9.0f}, 8)));
}

TEST(GrowTree, ReachesTheSizeOfItsGoal) {
    for (const TreeHabit& habit : {oakHabit(), spruceHabit()})
        for (const float height : {8.0f, 15.0f, 22.0f})
            for (std::uint32_t seed = 1; seed <= 3; ++seed) {
                const bool spruce = habit.whorl > 0.0f;
                const GrowthGoal goal{height, 0.03f * height, (spruce ? 0.36f : 0.7f) * height};
                const GrownForm form = makeForm(habit, {}, goal, seed);
                SCOPED_TRACE(testing::Message()
                             << (spruce ? "spruce " : "oak ") << height << " m, seed " << seed);
                EXPECT_NEAR(heightOf(form) / goal.height, 1.0f, 0.03f);
                EXPECT_NEAR(widthOf(form) / goal.crownWidth, 1.0f, 0.03f);
                EXPECT_NEAR(form.heightFactor / form.widthFactor, 1.0f, 0.1f) << "it is distorted";
                EXPECT_NEAR(2.0f * stemRadius(form, std::min(1.3f, 0.1f * height)) / goal.trunkDiameter, 1.0f,
                            0.02f);
            }
}

TEST(GrowTree, IsValidForAnyHabit) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(testing::Message() << "habit " << seed);
        Random random(seed);
        GrowthSite site;
        site.shade = seed % 3 == 0 ? random.uniform() : 0.0f;
        if (seed % 2 == 0)
            site.openSide = random.symmetric();
        const GrowthGoal goal{2.0f + 18.0f * random.uniform(), 0.05f + 0.5f * random.uniform(),
                              1.0f + 11.0f * random.uniform()};
        expectValid(makeForm(anyHabit(seed), site, goal, seed));
    }
}

TEST(GrowTree, ClampsParametersToTheirRanges) {
    for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity(), -1e30f, 0.0f}) {
        TreeHabit habit = oakHabit();
        habit.annualShoot.fill(bad);
        habit.internode.fill(bad);
        habit.lightNeed = habit.leafArea = habit.trunkTop = habit.whorl = bad;
        habit.limbs = habit.deepest = std::isnan(bad) || bad < 0.0f ? INT_MIN : INT_MAX;
        GrowthSite site;
        site.shade = site.distance = bad;
        site.openSide = bad;
        GrowthGoal goal{bad, bad, bad};
        if (bad > 0.0f)
            goal.height = 10.0f;
        expectValid(makeForm(habit, site, goal, 1));
    }
}

TEST(GrowTree, RadiiDecreaseAlongAxesAndInBranches) {
    expectValid(makeForm(oakHabit(), {}, {15.0f, 0.5f, 10.0f}, 3));
    expectValid(makeForm(spruceHabit(), {}, {18.0f, 0.4f, 6.5f}, 3));
}

TEST(GrowTree, StemHasAFormFactorOfOneHalf) {
    const GrowthGoal goal{20.0f, 0.4f, 6.5f};
    const GrownForm form = makeForm(spruceHabit(), {}, goal, 3);
    float volume = 0.0f;
    for (const GrownMetamer& metamer : form.metamers)
        if (metamer.axis == 0 && metamer.parent >= 0) {
            const GrownMetamer& below = form.metamers[static_cast<std::size_t>(metamer.parent)];
            const float mean = 0.5f * (metamer.radius + below.radius);
            volume += 3.14159f * mean * mean * glm::distance(metamer.position, below.position);
        }
    EXPECT_NEAR(volume / (3.14159f * 0.04f * goal.height), 0.5f, 0.03f);
}

TEST(GrowTree, BranchesStartAtTheirAngle) {
    for (const float degrees : {30.0f, 55.0f, 80.0f}) {
        TreeHabit habit = spruceHabit();
        habit.branchAngle[0] = glm::radians(degrees);
        habit.sink.fill(0.0f);
        habit.hang.fill(0.0f);
        habit.rise = {3.0f, 0.0f, 0.0f, 0.0f};
        habit.levelling.fill(0.0f);
        habit.lightSeeking.fill(0.0f);
        habit.wander.fill(0.0f);
        const GrownForm form = makeForm(habit, {}, {10.0f, 0.2f, 5.0f}, 2);
        double sum = 0.0;
        int count = 0;
        for (const GrownMetamer& metamer : form.metamers) {
            if (metamer.order != 1 || form.metamers[static_cast<std::size_t>(metamer.parent)].order != 0)
                continue;
            glm::vec3 way =
                metamer.position - form.metamers[static_cast<std::size_t>(metamer.parent)].position;
            way /= glm::vec3(form.widthFactor, form.widthFactor, form.heightFactor);
            sum += std::acos(static_cast<double>(glm::normalize(way).z));
            ++count;
        }
        ASSERT_GT(count, 20);
        EXPECT_NEAR(glm::degrees(sum / count), static_cast<double>(degrees), 3.0);
    }
}

TEST(GrowTree, ClosedStandMakesABareStem) {
    for (const TreeHabit& habit : {oakHabit(), spruceHabit()}) {
        GrowthSite wood;
        wood.shade = 1.0f;
        wood.distance = 3.0f;
        const GrowthGoal open{18.0f, 0.4f, 6.0f}, closed{18.0f, 0.25f, 3.5f};
        const float free = lowestLeaves(makeForm(habit, {}, open, 1));
        const float shaded = lowestLeaves(makeForm(habit, wood, closed, 1));
        EXPECT_LT(free, 0.2f);
        EXPECT_GT(shaded, 0.4f);
    }
}

TEST(GrowTree, ClosedStandMakesStraightStemsWithHighCrowns) {
    GrowthSite wood;
    wood.shade = 1.0f;
    wood.distance = 6.0f;
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const GrownForm form = makeForm(oakHabit(), wood, {24.0f, 0.34f, 6.5f}, seed);
        EXPECT_NEAR(form.heightFactor / form.widthFactor, 1.0f, 0.1f) << "it is distorted";
        const float green = lowestLeaves(form);
        EXPECT_GT(green, 0.4f);
        EXPECT_LT(green, 0.72f);
        glm::vec3 middle(0.0f), top(0.0f);
        for (const GrownMetamer& metamer : form.metamers)
            if (metamer.axis == 0 && metamer.position.z < 12.0f)
                (metamer.position.z < 6.0f ? middle : top) = metamer.position;
        EXPECT_GT(top.z, 10.0f) << "the trunk divides too low";
        EXPECT_LT(glm::length(glm::vec2(top)) / top.z, 0.35f) << "leans";
        const glm::vec2 bow = glm::vec2(middle) - glm::vec2(top) * (middle.z / top.z);
        EXPECT_LT(glm::length(bow) / top.z, 0.08f);
    }
}

TEST(GrowTree, EdgeTreeIsGreenToTheGroundOnTheOpenSide) {
    GrowthSite edge;
    edge.shade = 1.0f;
    edge.distance = 3.0f;
    edge.openSide = 0.0f;
    const GrownForm form = makeForm(spruceHabit(), edge, {18.0f, 0.3f, 5.0f}, 1);
    EXPECT_GT(lowLeaves(form, 1.0f), 3.0f * lowLeaves(form, -1.0f));
    EXPECT_GT(lowLeaves(form, 1.0f), 2.0f);
}

} // namespace
} // namespace osgTreeWind

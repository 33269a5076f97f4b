// SPDX-License-Identifier: MIT
#include <tests/model/ModelTestCases.h>

#include <osgTreeWind/model/TreeModel.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <deque>
#include <set>

namespace osgTreeWind {
namespace {

std::vector<int> childrenOf(const Skeleton& skeleton, int parent) {
    std::vector<int> children;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        if (skeleton.units[unit].parent == parent)
            children.push_back(static_cast<int>(unit));
    return children;
}

float angleBetween(const glm::vec3& a, const glm::vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::uint64_t unitsOf(const RecursiveTreeParameters& parameters) {
    TreeParameters tree;
    tree.wood = parameters;
    return countTree(tree).units;
}

TEST(RecursiveTree, ReferenceTreeHas122UnitsAnd1952Points) {
    const Skeleton skeleton = makeRecursiveTree({});
    EXPECT_EQ(skeleton.units.size(), 122u);
    EXPECT_EQ(skeleton.points.size(), 1952u);
    EXPECT_EQ(unitsOf({}), 122u);
}

TEST(RecursiveTree, UnitCountIsTrunkPlusGeometricSum) {
    for (int levels = 0; levels <= 6; ++levels)
        for (int children = 1; children <= 5; ++children)
            for (const int trunk : {1, 2, 7}) {
                RecursiveTreeParameters p;
                p.levels = levels, p.childrenPerBranch = children, p.trunkUnits = trunk, p.ringsPerBranch = 2;
                p.bareUnits = trunk - 1;
                double branches = levels;
                if (children > 1)
                    branches = (std::pow(children, levels + 1) - children) / (children - 1);
                const auto expected = static_cast<std::uint64_t>(trunk + branches + 0.5);
                EXPECT_EQ(unitsOf(p), expected) << levels << " levels of " << children;
                EXPECT_EQ(makeRecursiveTree(p).units.size(), expected) << levels << " levels of " << children;
            }
}

// Thesis Fig 4.5: units numbered breadth first, read in access order.
TEST(RecursiveTree, AccessOrderIsThatOfFigure4_5) {
    RecursiveTreeParameters p;
    p.levels = 2;
    const Skeleton skeleton = makeRecursiveTree(p);
    std::vector<int> breadthNumber(skeleton.units.size(), -1);
    std::deque<int> queue{p.trunkUnits - 1};
    for (int number = 0; !queue.empty(); queue.pop_front())
        for (const int child : childrenOf(skeleton, queue.front())) {
            breadthNumber[static_cast<std::size_t>(child)] = number++;
            queue.push_back(child);
        }
    breadthNumber.erase(breadthNumber.begin(), breadthNumber.begin() + p.trunkUnits);
    EXPECT_EQ(breadthNumber, (std::vector<int>{0, 3, 4, 5, 1, 6, 7, 8, 2, 9, 10, 11}));
}

TEST(RecursiveTree, TrunkUnitsAreStacked) {
    RecursiveTreeParameters p;
    p.trunkUnits = 5;
    p.bareUnits = 4;
    const Skeleton skeleton = makeRecursiveTree(p);
    for (int unit = 0; unit < 5; ++unit) {
        EXPECT_EQ(skeleton.units[static_cast<std::size_t>(unit)].parent, unit - 1);
        EXPECT_EQ(skeleton.units[static_cast<std::size_t>(unit)].level, 0);
    }
    EXPECT_EQ(skeleton.units[0].base, glm::vec3(0.0f));
    EXPECT_EQ(skeleton.units[5].level, 1);
}

TEST(RecursiveTree, EveryBranchStartsBitExactlyAtItsParentsTip) {
    for (const NamedParameters& c : extremeTrees()) {
        const Skeleton skeleton = makeRecursiveTree(c.parameters);
        for (std::size_t unit = 1; unit < skeleton.units.size(); ++unit) {
            const BranchUnit& own = skeleton.units[unit];
            ASSERT_GE(own.parent, 0) << c.name;
            ASSERT_LT(own.parent, static_cast<int>(unit)) << c.name;
            const BranchUnit& parent = skeleton.units[static_cast<std::size_t>(own.parent)];
            ASSERT_EQ(own.base, parent.tip) << c.name << ", unit " << unit;
            ASSERT_TRUE(own.level == parent.level + 1 || own.level == 0) << c.name << ", unit " << unit;
        }
    }
}

TEST(RecursiveTree, PointsRunBitExactlyFromBaseToTip) {
    for (const NamedParameters& c : extremeTrees()) {
        const Skeleton skeleton = makeRecursiveTree(c.parameters);
        for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
            ASSERT_EQ(skeleton.point(unit, 0), skeleton.units[unit].base) << c.name << ", unit " << unit;
            ASSERT_EQ(skeleton.point(unit, skeleton.ringsPerBranch - 1), skeleton.units[unit].tip)
                << c.name << ", unit " << unit;
        }
    }
}

TEST(RecursiveTree, BreaksAreOffsetByAtMostCrook) {
    RecursiveTreeParameters p;
    p.crook = 0.3f;
    const Skeleton skeleton = makeRecursiveTree(p);
    float furthest = 0.0f;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        const glm::vec3 along = skeleton.units[unit].tip - skeleton.units[unit].base;
        for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring) {
            const float t = static_cast<float>(ring) / static_cast<float>(skeleton.ringsPerBranch - 1);
            const glm::vec3 offset = skeleton.point(unit, ring) - (skeleton.units[unit].base + t * along);
            const float stray = glm::length(offset) / glm::length(along);
            ASSERT_LE(stray, p.crook) << "unit " << unit << " ring " << ring;
            furthest = std::max(furthest, stray);
        }
    }
    EXPECT_GT(furthest, 0.1f * p.crook) << "the breaks should be random";
}

TEST(RecursiveTree, WithoutCrookPointsAreEvenlySpacedOnAStraightLine) {
    const Skeleton skeleton = makeRecursiveTree(regularTree());
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        for (int ring = 0; ring < 16; ++ring) {
            const glm::vec3 expected =
                skeleton.units[unit].base +
                static_cast<float>(ring) / 15.0f * (skeleton.units[unit].tip - skeleton.units[unit].base);
            ASSERT_LT(glm::distance(skeleton.point(unit, ring), expected), 2e-6f);
        }
}

TEST(RecursiveTree, RegularTreeHasExactInclinationsAndLengths) {
    for (const float growth : {1.0f, 1.25f}) {
        RecursiveTreeParameters p = regularTree();
        p.inclinationGrowth = growth;
        const Skeleton skeleton = makeRecursiveTree(p);
        for (const BranchUnit& unit : skeleton.units) {
            const glm::vec3 along = unit.tip - unit.base;
            if (unit.level == 0) {
                EXPECT_EQ(along, glm::vec3(0, 0, p.length));
                continue;
            }
            const double inclination = 0.6 * std::pow(growth, unit.level - 1);
            const double length = 4.8 * 0.36 * std::pow(0.72, unit.level - 1);
            EXPECT_NEAR(angleBetween(along, {0, 0, 1}), inclination, 1e-5);
            EXPECT_NEAR(glm::length(along), length, 1e-5);
        }
    }
}

TEST(RecursiveTree, EveryTrunkUnitThatIsNotBareHasBoughs) {
    RecursiveTreeParameters p = regularTree();
    p.trunkUnits = 5;
    p.bareUnits = 2;
    p.crownTaper = 0.5f;
    p.levels = 1;
    const Skeleton skeleton = makeRecursiveTree(p);
    EXPECT_EQ(skeleton.units.size(), 5u + 3u * 3u);
    const double lowest = 12.0 * 0.36;
    for (const BranchUnit& unit : skeleton.units)
        if (unit.level == 1) {
            const double height = unit.base.z / 2.4; // 3, 4 or 5 trunk units
            EXPECT_NEAR(glm::distance(unit.base, unit.tip), lowest * (1.0 - 0.25 * (height - 3.0)), 1e-4);
        }
}

TEST(RecursiveTree, ALeaderContinuesStraight) {
    RecursiveTreeParameters p = regularTree();
    p.leader = 1.0f;
    const Skeleton skeleton = makeRecursiveTree(p);
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        const std::vector<int> children = childrenOf(skeleton, static_cast<int>(unit));
        if (children.size() < 3)
            continue;
        const BranchUnit& leader = skeleton.units[static_cast<std::size_t>(children.front())];
        EXPECT_NEAR(angleBetween(leader.tip - leader.base, {0, 0, 1}), 0.0f, 1e-3f);
    }
}

TEST(RecursiveTree, InclinationNeverExceedsItsLimit) {
    RecursiveTreeParameters p;
    p.follow = 0.0f;
    p.inclination = maxInclination;
    p.inclinationGrowth = 3.0f;
    p.jitter = 1.0f;
    for (const BranchUnit& unit : makeRecursiveTree(p).units)
        EXPECT_LE(angleBetween(unit.tip - unit.base, {0, 0, 1}), maxInclination + 1e-4f);
}

TEST(RecursiveTree, SiblingsOfARegularTreeSpreadEvenlyRoundTheVertical) {
    for (const int children : {2, 3, 5}) {
        RecursiveTreeParameters p = regularTree();
        p.levels = 3;
        p.childrenPerBranch = children;
        const Skeleton skeleton = makeRecursiveTree(p);
        const float spacing = glm::two_pi<float>() / static_cast<float>(children);
        for (std::size_t unit = 1; unit < skeleton.units.size(); ++unit) {
            const std::vector<int> siblings = childrenOf(skeleton, static_cast<int>(unit));
            if (skeleton.units[unit].level == p.levels)
                continue;
            ASSERT_EQ(siblings.size(), static_cast<std::size_t>(children));
            for (std::size_t i = 0; i < siblings.size(); ++i) {
                const BranchUnit& own = skeleton.units[static_cast<std::size_t>(siblings[i])];
                const BranchUnit& next =
                    skeleton.units[static_cast<std::size_t>(siblings[(i + 1) % siblings.size()])];
                const glm::vec3 a = own.tip - own.base, b = next.tip - next.base;
                float turn = std::atan2(b.y, b.x) - std::atan2(a.y, a.x);
                turn += turn < 0.0f ? glm::two_pi<float>() : 0.0f;
                EXPECT_NEAR(turn, spacing, 2e-5f) << "unit " << siblings[i];
            }
        }
    }
}

TEST(RecursiveTree, FollowingBranchesInclineFromTheirParent) {
    RecursiveTreeParameters p = regularTree();
    p.follow = 1.0f;
    const Skeleton skeleton = makeRecursiveTree(p);
    for (const BranchUnit& unit : skeleton.units)
        if (unit.level > 0) {
            const BranchUnit& parent = skeleton.units[static_cast<std::size_t>(unit.parent)];
            EXPECT_NEAR(angleBetween(unit.tip - unit.base, parent.tip - parent.base),
                        0.6 * std::pow(1.25, unit.level - 1), 1e-4);
        }
}

TEST(RecursiveTree, RadiiFollowTaperAndRatio) {
    RecursiveTreeParameters p;
    p.trunkUnits = 3;
    p.bareUnits = 2;
    const Skeleton skeleton = makeRecursiveTree(p);
    EXPECT_EQ(skeleton.units[0].baseRadius, p.radius);
    EXPECT_NEAR(skeleton.units[2].tipRadius, p.radius * p.taper, 1e-6f) << "taper is over the whole trunk";
    for (const BranchUnit& unit : skeleton.units)
        if (unit.level > 0) {
            const float parentTip = skeleton.units[static_cast<std::size_t>(unit.parent)].tipRadius;
            EXPECT_FLOAT_EQ(unit.baseRadius, parentTip * p.radiusRatio);
            EXPECT_FLOAT_EQ(unit.tipRadius, unit.baseRadius * p.taper);
        }
}

TEST(RecursiveTree, RadiiNeverGrowTowardsTheTip) {
    for (const NamedParameters& c : extremeTrees()) {
        const Skeleton skeleton = makeRecursiveTree(c.parameters);
        for (const BranchUnit& unit : skeleton.units) {
            ASSERT_GT(unit.tipRadius, 0.0f) << c.name;
            ASSERT_LE(unit.tipRadius, unit.baseRadius) << c.name;
            if (unit.parent >= 0) {
                ASSERT_LE(unit.baseRadius, skeleton.units[static_cast<std::size_t>(unit.parent)].tipRadius)
                    << c.name;
            }
        }
    }
}

TEST(RecursiveTree, ASeedDeterminesTheTree) {
    EXPECT_EQ(fingerprint(makeRecursiveTree({}).points), fingerprint(makeRecursiveTree({}).points));
}

// A stored value, which compares compilers, optimization levels and machines.
TEST(RecursiveTree, ReferenceTreeIsTheSameOnEveryMachine) {
    EXPECT_EQ(fingerprint(makeRecursiveTree({}).points), 0x3f1d0478e13ab991ull);
}

TEST(RecursiveTree, SeedsMakeDifferentTrees) {
    std::set<std::uint64_t> trees;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        RecursiveTreeParameters p;
        p.seed = seed;
        trees.insert(fingerprint(makeRecursiveTree(p).points));
    }
    EXPECT_EQ(trees.size(), 100u);
}

TEST(RecursiveTree, AnyParametersMakeAFiniteTreeOfReasonableSize) {
    for (const NamedParameters& c : extremeTrees()) {
        const Skeleton skeleton = makeRecursiveTree(c.parameters);
        ASSERT_FALSE(skeleton.units.empty()) << c.name;
        ASSERT_EQ(skeleton.units.size(), unitsOf(c.parameters)) << c.name;
        for (const glm::vec3& point : skeleton.points) {
            ASSERT_TRUE(isFinite(point)) << c.name;
            ASSERT_LT(glm::length(point), 1e5f) << c.name;
        }
    }
}

TEST(RecursiveTree, TangentsAreUnitVectorsEvenInExtremeTrees) {
    for (const NamedParameters& c : extremeTrees()) {
        const Skeleton skeleton = makeRecursiveTree(c.parameters);
        for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
            for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring)
                ASSERT_NEAR(glm::length(skeleton.tangent(unit, ring)), 1.0f, 1e-5f)
                    << c.name << ", unit " << unit << " ring " << ring;
    }
}

TEST(RecursiveTree, NaNMeansTheDefault) {
    RecursiveTreeParameters p;
    p.length = p.radius = p.twist = p.inclination = std::nanf("");
    EXPECT_EQ(fingerprint(makeRecursiveTree(p).points), fingerprint(makeRecursiveTree({}).points));
}

TEST(RecursiveTree, LevelsAreLoweredUntilTheSkeletonFits) {
    RecursiveTreeParameters p;
    p.levels = p.childrenPerBranch = 8; // 19 million units
    EXPECT_EQ(clamped(p).levels, 5);    // 2 + 8 + ... + 8^5 = 37,450 units, 599,200 points
    EXPECT_LE(unitsOf(p) * 16, maxSkeletonPoints);
    p.childrenPerBranch = 3;
    EXPECT_EQ(clamped(p).levels, 8) << "9,842 units fit";
}

} // namespace
} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/model/ModelTestCases.h>

#include <osgTreeWind/model/CrownOutline.h>
#include <osgTreeWind/model/GrownTree.h>
#include <osgTreeWind/model/RecursiveTree.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace osgTreeWind {
namespace {

using NamedForm = Named<GrownTreeParameters>;

/// Parameters at and beyond the edges of what is allowed.
std::vector<NamedForm> extremeForms() {
    std::vector<NamedForm> cases;
    const auto add = [&](const char* name, auto change) {
        cases.push_back({name, {}});
        change(cases.back().parameters);
    };
    using P = GrownTreeParameters;
    const auto all = [](P& p, float value) {
        p.height = p.radius = p.trunk = p.trunkTaper = p.trunkCrook = p.forkInclination = p.crownBase = value;
        p.crownWidth = value;
        for (GrownBranches* kind : {&p.boughs, &p.branches, &p.twigs}) {
            kind->start = kind->length = kind->lengthVariation = kind->inclination = value;
            kind->inclinationEnd = kind->inclinationVariation = kind->flat = kind->rise = value;
            kind->riseOutside = kind->crook = kind->sections = kind->power = kind->taper = value;
        }
    };
    add("usual", [](P&) {});
    add("bare pole", [](P& p) { p.boughs.count = -3, p.trunkUnits = -3, p.ringsPerBranch = -1; });
    add("forks alone", [](P& p) { p.boughs.count = 3, p.forks = 99; });
    add("too many", [](P& p) {
        p.boughs.count = p.branches.count = p.twigs.count = 9999, p.ringsPerBranch = 2, p.boughs.units = 3;
    });
    add("all 0", [&](P& p) { all(p, 0.0f); });
    add("all NaN", [&](P& p) { all(p, std::nanf("")); });
    add("all infinite", [&](P& p) { all(p, std::numeric_limits<float>::infinity()); });
    add("all negative", [&](P& p) { all(p, -1e30f); });
    add("two rings", [](P& p) { p.ringsPerBranch = 2, p.boughs.units = 3; });
    add("wild", [](P& p) {
        p.trunkCrook = p.boughs.crook = p.branches.crook = p.twigs.crook = 1.0f;
        p.boughs.rise = -3.0f, p.boughs.riseOutside = 3.0f;
    });
    return cases;
}

/// A tree of boughs that all are as long as the outline lets them.
GrownTreeParameters boughsAlone(int count) {
    GrownTreeParameters p;
    p.boughs.count = count;
    p.boughs.lengthVariation = 0.0f;
    p.branches.count = p.twigs.count = 0;
    return p;
}

float distanceFromLine(const Skeleton& skeleton, std::size_t unit, const glm::vec3& point) {
    float nearest = 1e9f;
    for (int ring = 0; ring + 1 < skeleton.ringsPerBranch; ++ring) {
        const glm::vec3 a = skeleton.point(unit, ring), ab = skeleton.point(unit, ring + 1) - a;
        const float t = glm::clamp(glm::dot(point - a, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
        nearest = std::min(nearest, glm::distance(point, a + t * ab));
    }
    return nearest;
}

TEST(CrownOutline, WidthsAreThoseOfWeberAndPenn) {
    // Weber and Penn 1995, appendix; r = 0 at the top.
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::Cone, 0.0f), 0.2f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::Cone, 1.0f), 1.0f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::Sphere, 0.5f), 1.0f);
    EXPECT_NEAR(crownWidth(CrownOutline::Sphere, 1.0f), 0.2f, 1e-6f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::Hemisphere, 1.0f), 1.0f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::Cylinder, 0.3f), 1.0f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::TaperedCylinder, 0.5f), 0.75f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::Flame, 0.35f), 0.5f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::Flame, 0.85f), 0.5f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::InverseCone, 1.0f), 0.2f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::TendFlame, 0.7f), 1.0f);
    EXPECT_FLOAT_EQ(crownWidth(CrownOutline::TendFlame, 0.0f), 0.5f);
}

TEST(GrownTree, BoughsEndOnTheOutlineOfTheCrown) {
    for (const CrownOutline shape : {CrownOutline::Cone, CrownOutline::Sphere, CrownOutline::Hemisphere,
                                     CrownOutline::Cylinder, CrownOutline::TendFlame}) {
        GrownTreeParameters p = boughsAlone(60);
        p.shape = shape;
        p.boughs.crook = 0.0f;
        const Skeleton skeleton = makeGrownTree(p);
        const float depth = p.height * (1.0f - p.crownBase);
        for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
            if (skeleton.units[i].level == 0)
                continue;
            const auto room = [&](const glm::vec3& point) {
                return 0.5f * p.crownWidth * crownWidth(shape, (p.height - point.z) / depth) -
                       glm::length(glm::vec2(point.x, point.y));
            };
            const glm::vec3& tip = skeleton.units[i].tip;
            ASSERT_LT(std::min(std::abs(room(tip)), p.height - tip.z), 0.02f) << "unit " << i;
            for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring)
                ASSERT_GT(room(skeleton.point(i, ring)), -0.01f) << "unit " << i;
        }
    }
}

TEST(GrownTree, BranchesSpringFromTheLineOfTheirParent) {
    for (const NamedForm& c : extremeForms()) {
        const Skeleton skeleton = makeGrownTree(c.parameters);
        bool along = false;
        for (std::size_t i = 1; i < skeleton.units.size(); ++i) {
            const BranchUnit& unit = skeleton.units[i];
            const auto parent = static_cast<std::size_t>(unit.parent);
            ASSERT_GT(unit.attach, 0.0f) << c.name;
            ASSERT_LE(unit.attach, 1.0f) << c.name;
            const float reach = glm::length(unit.base) + 1.0f;
            ASSERT_LT(distanceFromLine(skeleton, parent, unit.base), 2e-6f * reach) << c.name << " " << i;
            const float ring = unit.attach * static_cast<float>(skeleton.ringsPerBranch - 1);
            const int below = std::min(static_cast<int>(ring), skeleton.ringsPerBranch - 2);
            const glm::vec3 place = glm::mix(skeleton.point(parent, below), skeleton.point(parent, below + 1),
                                             ring - static_cast<float>(below));
            const float length = glm::distance(skeleton.units[parent].base, skeleton.units[parent].tip);
            ASSERT_LT(glm::distance(place, unit.base), 2e-3f * length + 1e-5f * reach) << c.name << " " << i;
            along = along || (unit.attach > 0.1f && unit.attach < 0.9f);
        }
        if (c.name == "usual") {
            EXPECT_TRUE(along);
        }
    }
}

TEST(GrownTree, UnitsStandInAccessOrderAndEachCarriesOneRun) {
    for (const NamedForm& c : extremeForms()) {
        const Skeleton skeleton = makeGrownTree(c.parameters);
        std::vector<std::size_t> end(skeleton.units.size());
        for (std::size_t i = skeleton.units.size(); i-- > 0;) {
            end[i] = std::max(end[i], i + 1);
            const BranchUnit& unit = skeleton.units[i];
            ASSERT_LT(unit.parent, static_cast<int>(i)) << c.name;
            ASSERT_EQ(unit.parent < 0, i == 0) << c.name;
            if (unit.parent >= 0) {
                const BranchUnit& parent = skeleton.units[static_cast<std::size_t>(unit.parent)];
                ASSERT_TRUE(unit.level == parent.level || unit.level == parent.level + 1) << c.name;
                end[static_cast<std::size_t>(unit.parent)] =
                    std::max(end[static_cast<std::size_t>(unit.parent)], end[i]);
            }
        }
        for (std::size_t i = 0; i < skeleton.units.size(); ++i)
            for (std::size_t j = i + 1; j < end[i]; ++j)
                ASSERT_GE(skeleton.units[j].parent, static_cast<int>(i)) << c.name << ", run of " << i;
    }
}

TEST(GrownTree, NoPartDegeneratesWhateverTheParameters) {
    for (const NamedForm& c : extremeForms()) {
        const Skeleton skeleton = makeGrownTree(c.parameters);
        ASSERT_LE(skeleton.points.size(), maxSkeletonPoints) << c.name;
        ASSERT_EQ(skeleton.points.size(),
                  skeleton.units.size() * static_cast<std::size_t>(skeleton.ringsPerBranch));
        for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
            const BranchUnit& unit = skeleton.units[i];
            ASSERT_EQ(skeleton.point(i, 0), unit.base) << c.name;
            ASSERT_EQ(skeleton.point(i, skeleton.ringsPerBranch - 1), unit.tip) << c.name;
            ASSERT_GT(unit.baseRadius, 0.0f) << c.name;
            ASSERT_GT(unit.tipRadius, 0.0f) << c.name;
            ASSERT_LE(unit.tipRadius, unit.baseRadius) << c.name;
            ASSERT_GT(glm::distance(unit.base, unit.tip), 0.0f) << c.name << " " << i;
            for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring) {
                ASSERT_TRUE(isFinite(skeleton.point(i, ring))) << c.name;
                ASSERT_TRUE(isFinite(skeleton.tangent(i, ring))) << c.name << " " << i;
            }
        }
    }
}

TEST(GrownTree, AzimuthsOfBoughsAreUniform) {
    // Beyer 2020: beech, spruce and pine.
    std::array<int, 12> sectors{};
    int boughs = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        GrownTreeParameters p = boughsAlone(10);
        p.forks = 0;
        p.trunkCrook = p.boughs.crook = 0.0f;
        p.boughs.units = 1;
        p.seed = seed;
        for (const BranchUnit& unit : makeGrownTree(p).units)
            if (unit.level == 1) {
                const glm::vec3 way = unit.tip - unit.base;
                const float turn = std::atan2(way.y, way.x) / 6.2831853f + 0.5f;
                ++sectors[static_cast<std::size_t>(12.0f * turn) % 12];
                ++boughs;
            }
    }
    EXPECT_EQ(boughs, 600);
    double chiSquare = 0.0;
    for (const int count : sectors)
        chiSquare += (count - boughs / 12.0) * (count - boughs / 12.0) / (boughs / 12.0);
    EXPECT_LT(chiSquare, 24.7) << "1 % of 11 degrees of freedom";
}

TEST(GrownTree, BranchesRiseAndHangAsTold) {
    for (const float rise : {-1.0f, 0.0f, 1.0f}) {
        GrownTreeParameters p = boughsAlone(12);
        p.forks = 0;
        p.boughs.inclination = p.boughs.inclinationEnd = 1.5708f;
        p.boughs.inclinationVariation = p.boughs.crook = p.trunkCrook = 0.0f;
        p.boughs.units = 1;
        p.boughs.rise = p.boughs.riseOutside = 0.5f * rise;
        const Skeleton skeleton = makeGrownTree(p);
        for (std::size_t i = 0; i < skeleton.units.size(); ++i)
            if (skeleton.units[i].level == 1) {
                const glm::vec3 end = skeleton.tangent(i, skeleton.ringsPerBranch - 1);
                EXPECT_NEAR(std::asin(end.z), rise * 13.0f / 14.0f, 1e-3f)
                    << "in the middle of the last segment";
            }
    }
}

TEST(GrownTree, SpruceLikeBoughsHangAndTurnUpAtTheirEnds) {
    GrownTreeParameters p = boughsAlone(12);
    p.forks = 0;
    p.boughs.inclination = p.boughs.inclinationEnd = 1.5708f;
    p.boughs.rise = -0.6f;
    p.boughs.riseOutside = 1.0f;
    p.boughs.crook = p.boughs.inclinationVariation = 0.0f;
    p.boughs.units = 1;
    const Skeleton skeleton = makeGrownTree(p);
    for (std::size_t i = 0; i < skeleton.units.size(); ++i)
        if (skeleton.units[i].level == 1) {
            EXPECT_LT(skeleton.point(i, 4).z, skeleton.units[i].base.z);
            EXPECT_GT(skeleton.tangent(i, 7).z, 0.1f);
        }
}

TEST(GrownTree, CrossSectionsOfSistersAddUp) {
    // Leonardo's rule: those of the boughs make up the trunk's at the crown's base.
    GrownTreeParameters p = boughsAlone(20);
    p.forks = 0;
    p.boughs.units = 1;
    p.boughs.power = 1.5f;
    const Skeleton skeleton = makeGrownTree(p);
    float sections = 0.0f, longest = 0.0f, thickest = 0.0f, ofLongest = 0.0f;
    for (const BranchUnit& unit : skeleton.units)
        if (unit.level == 1) {
            sections += unit.baseRadius * unit.baseRadius;
            thickest = std::max(thickest, unit.baseRadius);
            if (glm::distance(unit.base, unit.tip) > longest) {
                longest = glm::distance(unit.base, unit.tip);
                ofLongest = unit.baseRadius;
            }
        }
    const float trunk = p.radius * (1.0f - (1.0f - p.trunkTaper) * p.crownBase / p.trunk);
    EXPECT_NEAR(sections, trunk * trunk, 1e-3f * trunk * trunk);
    EXPECT_GT(ofLongest, 0.95f * thickest);
}

TEST(GrownTree, OneSeedIsOneTree) {
    GrownTreeParameters p;
    const std::uint64_t first = fingerprint(makeGrownTree(p).points);
    EXPECT_EQ(fingerprint(makeGrownTree(p).points), first);
    p.seed = 2;
    EXPECT_NE(fingerprint(makeGrownTree(p).points), first);
}

} // namespace
} // namespace osgTreeWind

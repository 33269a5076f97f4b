// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>

#include <glm/gtc/constants.hpp>

#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/model/ScanAxes.h>
#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/WoodVolume.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

namespace {

const glm::dvec3 field(4.3e5, 4.5e6, 253.0); // map coordinates

ScanCylinder cylinder(const glm::dvec3& start, const glm::dvec3& end, double radius, int parent) {
    return {field + start, field + end, radius, parent, 0};
}

/// An upright pole of 1 m cylinders.
ScanCylinders pole(int count, double radius = 0.1) {
    ScanCylinders cylinders;
    for (int i = 0; i < count; ++i)
        cylinders.push_back(cylinder({0, 0, i}, {0, 0, i + 1}, radius, i - 1));
    return cylinders;
}

/// The pole with two branches of 2 m toward the east, 3.5 and 5 m up, and a twig on the lower one.
ScanCylinders littleTree() {
    ScanCylinders cylinders = pole(8);
    cylinders.push_back(cylinder({0.1, 0, 3.5}, {2, 0, 3.5}, 0.04, 3));
    cylinders.push_back(cylinder({0, 0, 5}, {2, 0, 5.5}, 0.05, 4));
    cylinders.push_back(cylinder({1.5, 0, 3.5}, {1.5, 0, 4}, 0.01, 8));
    return cylinders;
}

Skeleton skeletonOf(const ScanCylinders& cylinders, const WoodDetail& detail = {}) {
    const auto tree = makeScannedTree(cylinders, detail);
    EXPECT_TRUE(tree) << firstProblem(tree);
    return tree.value().skeleton;
}

const BranchUnit& firstOn(const Skeleton& skeleton, int level) {
    for (const BranchUnit& unit : skeleton.units)
        if (unit.level == level)
            return unit;
    ADD_FAILURE() << "no unit on level " << level;
    return skeleton.units.front();
}

/// Requirements on every skeleton.
void expectWellFormed(const Skeleton& skeleton) {
    const auto rings = static_cast<std::size_t>(skeleton.ringsPerBranch);
    ASSERT_EQ(skeleton.points.size(), skeleton.units.size() * rings);
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        EXPECT_EQ(unit.parent < 0, i == 0);
        EXPECT_EQ(skeleton.point(i, 0), unit.base);
        EXPECT_EQ(skeleton.point(i, skeleton.ringsPerBranch - 1), unit.tip);
        EXPECT_GT(unit.tipRadius, 0.0f);
        EXPECT_GE(unit.baseRadius, unit.tipRadius);
        for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring)
            EXPECT_NEAR(glm::length(skeleton.tangent(i, ring)), 1.0f, 1e-4f) << i << ' ' << ring;
        if (i == 0)
            continue;
        const auto parent = static_cast<std::size_t>(unit.parent);
        ASSERT_LT(parent, i);
        EXPECT_GT(unit.attach, 0.0f);
        EXPECT_LE(unit.attach, 1.0f);
        const float place = unit.attach * static_cast<float>(rings - 1);
        const int ring = std::min(static_cast<int>(place), skeleton.ringsPerBranch - 2);
        const glm::vec3 on = glm::mix(skeleton.point(parent, ring), skeleton.point(parent, ring + 1),
                                      place - static_cast<float>(ring));
        EXPECT_NEAR(glm::distance(unit.base, on), 0.0f, 1e-4f) << "not on its parent's centre line: " << i;
        const BranchUnit& carrier = skeleton.units[parent];
        EXPECT_LE(unit.baseRadius,
                  glm::mix(carrier.baseRadius, carrier.tipRadius, unit.attach) * 1.0001f + 1e-6f);
        // Depth first: the previous unit is the parent or one of its descendants.
        for (std::size_t before = i - 1; before != parent;) {
            ASSERT_GE(skeleton.units[before].parent, static_cast<int>(parent));
            before = static_cast<std::size_t>(skeleton.units[before].parent);
        }
    }
}

} // namespace

TEST(ScannedTree, APoleStandsAtTheOriginWithItsVolume) {
    const auto tree = makeScannedTree(pole(8));
    ASSERT_TRUE(tree) << firstProblem(tree);
    const Skeleton& skeleton = tree.value().skeleton;
    expectWellFormed(skeleton);
    EXPECT_EQ(skeleton.units.front().base, glm::vec3(0.0f));
    EXPECT_NEAR(skeleton.units.back().tip.z, 8.0f, 1e-5f);
    EXPECT_EQ(skeleton.units.size(), 8u) << "none longer than an eighth of the height";
    EXPECT_NEAR(woodVolume(skeleton), 8.0 * glm::pi<double>() * 0.01, 1e-5);
    const ScanReport& report = tree.value().report;
    EXPECT_EQ(report.cylinders, 8u);
    EXPECT_EQ(report.usedCylinders, 8u);
    EXPECT_EQ(report.units, 8u);
    EXPECT_NEAR(report.height, 8.0, 1e-6);
    EXPECT_NEAR(report.cylinderVolume, 8.0 * glm::pi<double>() * 0.01, 1e-8);
    EXPECT_NEAR(report.woodVolume, 8.0 * glm::pi<double>() * 0.01, 1e-5);
    EXPECT_NEAR(report.baseDiameter, 0.2, 1e-6);
}

TEST(ScannedTree, BranchesSpringAlongTheirParentsCentreLine) {
    const Skeleton skeleton = skeletonOf(littleTree());
    expectWellFormed(skeleton);
    const BranchUnit& lower = firstOn(skeleton, 1);
    EXPECT_NEAR(glm::distance(lower.base, glm::vec3(0.0f, 0.0f, 3.5f)), 0.0f, 1e-5f);
    EXPECT_NEAR(lower.attach, 0.5f, 1e-5f);
    EXPECT_EQ(skeleton.units[static_cast<std::size_t>(lower.parent)].level, 0);
    EXPECT_NEAR(glm::distance(firstOn(skeleton, 2).base, glm::vec3(1.5f, 0.0f, 3.5f)), 0.0f, 1e-5f);
}

TEST(ScannedTree, OrderOfCylindersDoesNotMatter) {
    const ScanCylinders sorted = littleTree();
    ScanCylinders reversed(sorted.rbegin(), sorted.rend());
    for (ScanCylinder& each : reversed)
        if (each.parent >= 0)
            each.parent = static_cast<int>(sorted.size()) - 1 - each.parent;
    const Skeleton a = skeletonOf(sorted), b = skeletonOf(reversed);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i)
        EXPECT_EQ(a.points[i], b.points[i]);
}

TEST(ScannedTree, TheTrunkContinuesWithTheChildThatCarriesMostWood) {
    ScanCylinders cylinders = pole(3);
    cylinders.push_back(cylinder({0, 0, 3}, {0, 0, 5}, 0.05, 2)); // upright, without branches
    cylinders.push_back(cylinder({0, 0, 3}, {1, 0, 4}, 0.05, 2)); // carries more wood
    cylinders.push_back(cylinder({1, 0, 4}, {2, 0, 4.5}, 0.05, 4));
    const std::vector<WoodAxis> axes = axesOfScan(cylinders);
    ASSERT_EQ(axes.size(), 2u);
    EXPECT_NEAR(axes[0].line.points.back().x, 2.0, 1e-6);
    EXPECT_EQ(axes[1].order, 1);
}

TEST(ScannedTree, AChildThatStartsBesideTheEndDoesNotContinueTheAxis) {
    ScanCylinders cylinders = pole(3);
    cylinders.push_back(cylinder({0, 0, 3}, {0, 0, 4}, 0.1, 2));
    cylinders.push_back(cylinder({0, 0, 2.4}, {3, 0, 3.4}, 0.1, 2)); // longer, from the middle
    const std::vector<WoodAxis> axes = axesOfScan(cylinders);
    ASSERT_EQ(axes.size(), 2u);
    EXPECT_NEAR(axes[0].line.points.back().z, 4.0, 1e-6);
    EXPECT_NEAR(axes[1].attach, 2.4, 1e-6);
}

TEST(ScannedTree, RadiiTaperAndKeepTheVolume) {
    ScanCylinders cylinders = pole(8);
    const double radii[] = {0.2, 0.15, 0.18, 0.12, 0.14, 0.1, 0.05, 0.06};
    double volume = 0.0;
    for (std::size_t i = 0; i < 8; ++i) {
        cylinders[i].radius = radii[i];
        volume += glm::pi<double>() * radii[i] * radii[i];
    }
    const Skeleton skeleton = skeletonOf(cylinders);
    expectWellFormed(skeleton);
    EXPECT_NEAR(woodVolume(skeleton) / volume, 1.0, 0.005);
    for (std::size_t i = 1; i < skeleton.units.size(); ++i)
        EXPECT_EQ(skeleton.units[i].baseRadius, skeleton.units[i - 1].tipRadius) << "bark goes on";
}

TEST(ScannedTree, NoBranchIsThickerThanItsParent) {
    ScanCylinders cylinders = littleTree();
    cylinders[8].radius = 0.5;
    expectWellFormed(skeletonOf(cylinders));
}

TEST(ScannedTree, ThinTwigsBecomeShootsOfTheirUnit) {
    WoodDetail detail;
    detail.minRadius = 0.02;
    const auto tree = makeScannedTree(littleTree(), detail);
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree.value().report.usedCylinders, 11u);
    EXPECT_EQ(tree.value().report.shoots, 1u);
    const Skeleton& skeleton = tree.value().skeleton;
    for (const BranchUnit& unit : skeleton.units)
        EXPECT_LT(unit.level, 2);
    ASSERT_EQ(skeleton.shoots.size(), 1u);
    const Shoot& shoot = skeleton.shoots.front();
    EXPECT_EQ(shoot.level, 2);
    EXPECT_FLOAT_EQ(shoot.baseRadius, 0.01f);
    EXPECT_NEAR(glm::distance(skeleton.shootPoint(shoot, 0), glm::vec3(1.5f, 0.0f, 3.5f)), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(skeleton.shootPoint(shoot, 1), glm::vec3(1.5f, 0.0f, 4.0f)), 0.0f, 1e-5f);
    const BranchUnit& bearer = skeleton.units[static_cast<std::size_t>(shoot.unit)];
    EXPECT_LE(bearer.base.x, 1.5f);
    EXPECT_GE(bearer.tip.x, 1.5f);
    EXPECT_NEAR(bearer.base.z, 3.5f, 1e-5f);
    EXPECT_EQ(problemOfSkeleton(skeleton), "");
}

TEST(ScannedTree, ShootsBeyondTheirLimitArePruned) {
    WoodDetail detail;
    detail.minRadius = 0.045;
    detail.maxShoots = 1;
    const auto tree = makeScannedTree(littleTree(), detail);
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree.value().report.shoots, 1u);
    EXPECT_EQ(tree.value().report.usedCylinders, 10u);
    EXPECT_NEAR(tree.value().skeleton.shoots.front().baseRadius, 0.04f, 0.002f);
}

TEST(ScannedTree, ShootsKeepTheirWoodAndLoadTheirUnit) {
    WoodDetail detail;
    detail.minRadius = 0.045;
    const Skeleton all = skeletonOf(littleTree()), some = skeletonOf(littleTree(), detail);
    EXPECT_NEAR(woodVolume(some) / woodVolume(all), 1.0, 1e-3);
    const std::vector<ShootWood> shoots = shootWoodOf(some);
    ASSERT_EQ(shoots.size(), some.units.size());
    float volume = 0.0f, outline = 0.0f;
    for (const ShootWood& wood : shoots) {
        volume += wood.volume;
        outline += wood.outline;
    }
    EXPECT_NEAR(volume, glm::pi<float>() * (0.04f * 0.04f * 1.9f + 0.01f * 0.01f * 0.5f), 2e-5f);
    EXPECT_NEAR(outline, 0.08f * 1.9f + 0.02f * 0.5f, 0.005f); // extends to the middle of the trunk
    EXPECT_TRUE(shootWoodOf(all).empty());
}

TEST(ShootWood, ScalesWithTheLengthOfShootsOnAStretchedTree) {
    const ShootWood level{2.0f, 3.0f, 0.0f}, upright{2.0f, 3.0f, 1.0f};
    const glm::vec3 axes{3.0f, 3.0f, 5.0f};
    EXPECT_FLOAT_EQ(level.scaled(axes, 2.0f).volume, 2.0f * 3.0f * 4.0f);
    EXPECT_FLOAT_EQ(level.scaled(axes, 2.0f).outline, 3.0f * 3.0f * 2.0f);
    EXPECT_FLOAT_EQ(upright.scaled(axes, 2.0f).volume, 2.0f * 5.0f * 4.0f);
}

TEST(ScannedTree, TheThinnestBecomeShootsFirstExceptOnThePathToTheTop) {
    ScanCylinders cylinders = pole(8);
    for (int i = 0; i < 7; ++i) // thicker ones lower
        cylinders.push_back(cylinder({0, 0, i + 0.5}, {3.0, 0, i + 0.5}, 0.08 - 0.01 * i, i));
    cylinders.push_back(cylinder({3, 0, 6.5}, {3.2, 0, 9.5}, 0.005, 14)); // leads to the top
    WoodDetail detail;
    detail.maxUnits = 20;
    const auto tree = makeScannedTree(cylinders, detail);
    ASSERT_TRUE(tree);
    const Skeleton& skeleton = tree.value().skeleton;
    expectWellFormed(skeleton);
    EXPECT_LE(skeleton.units.size(), 20u);
    EXPECT_GT(skeleton.shoots.size(), 0u);
    EXPECT_EQ(tree.value().report.usedCylinders, cylinders.size());
    float top = 0.0f;
    bool thickest = false;
    for (const BranchUnit& unit : skeleton.units) {
        top = std::max(top, unit.tip.z);
        thickest |= unit.level == 1 && unit.base.z < 1.0f;
    }
    EXPECT_NEAR(top, 9.5f, 1e-4f);
    EXPECT_TRUE(thickest);
}

TEST(ScannedTree, FoldedAndTinyCylindersStillHaveADirection) {
    ScanCylinders cylinders = pole(4);
    cylinders.push_back(cylinder({0, 0, 4}, {0, 0, 3}, 0.05, 3)); // straight back
    cylinders.push_back(cylinder({0, 0, 3}, {0, 0, 4}, 0.05, 4));
    cylinders.push_back(cylinder({0, 0, 1}, {1e-5, 0, 1}, 0.05, 0)); // tiny
    cylinders.push_back(cylinder({0, 0, 2}, {1, 0, 2}, 0.05, 1));
    cylinders.push_back(cylinder({1, 0, 2}, {0, 0, 2}, 0.05, 7)); // back to the start
    expectWellFormed(skeletonOf(cylinders));
}

TEST(ScannedTree, ALongChainOfBranchesIsCutOff) {
    ScanCylinders cylinders = pole(1);
    for (int i = 0; i < 100000; ++i) { // each has the next branch at its middle, and a continuation
        const int parent = 2 * i;
        const double z = 1.0 + 1e-3 * i;
        cylinders.push_back(cylinder({0, 0, z}, {0, 0, z + 1e-3}, 0.1, parent));
        cylinders.push_back(cylinder({0.3, 0, z}, {0.3, 0, z + 1e-3}, 0.1, parent));
    }
    const Skeleton skeleton = skeletonOf(cylinders);
    EXPECT_LE(skeleton.units.size(), 400u);
    EXPECT_EQ(skeleton.shoots.size(), 20000u);
}

TEST(ScannedTree, MakesATreeModel) {
    TreeParameters parameters;
    auto scans = std::make_shared<std::vector<ScannedTree>>();
    scans->push_back(makeScannedTree(littleTree()).value());
    scans->push_back(makeScannedTree(pole(5)).value());
    parameters.scans = scans;
    for (std::uint32_t variant = 0; variant < 4; ++variant) {
        const TreeModel model = makeTreeModel(parameters, variant);
        EXPECT_EQ(model.skeleton.units.size(), (*scans)[variant % 2].skeleton.units.size());
        const TreeCounts made = countTree(model), counted = countTree(parameters, variant);
        EXPECT_EQ(made.units, counted.units);
        EXPECT_EQ(made.branches, counted.branches);
        EXPECT_EQ(made.skinVertices, counted.skinVertices);
        EXPECT_EQ(made.leafVertices, counted.leafVertices);
        EXPECT_LE(made.totalTriangles(), countLargest(parameters, 2).totalTriangles());
    }
}

TEST(ScanProblem, InvalidScansAreRefused) {
    EXPECT_EQ(firstProblem(makeScannedTree({})), "expected at least one cylinder");
    ScanCylinders tree = pole(3);
    tree[1].end.x = NAN;
    EXPECT_EQ(firstProblem(makeScannedTree(tree)), "expected a cylinder of at least a micrometre");
    tree = pole(3);
    tree[1].radius = 0.0;
    EXPECT_NE(firstProblem(makeScannedTree(tree)), "");
    tree = pole(3);
    tree[1].parent = 3;
    EXPECT_EQ(firstProblem(makeScannedTree(tree)), "expected a parent among the cylinders");
    tree = pole(3);
    tree[1].parent = 2;
    EXPECT_EQ(firstProblem(makeScannedTree(tree)), "expected parents that lead to the root, found a loop");
}

} // namespace osgTreeWind

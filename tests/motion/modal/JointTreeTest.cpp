// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/JointTree.h>

#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/motion/modal/TreeModes.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

constexpr float length = 8.0f, radius = 0.05f;

/// A uniform upright pole.
TreeModel poleOf(int units) {
    TreeModel model;
    for (int i = 0; i < units; ++i) {
        const float step = length / static_cast<float>(units);
        BranchUnit unit;
        unit.parent = i - 1;
        unit.base.z = static_cast<float>(i) * step;
        unit.tip.z = static_cast<float>(i + 1) * step;
        unit.baseRadius = unit.tipRadius = radius;
        model.skeleton.units.push_back(unit);
    }
    return model;
}

/// First angular frequency of a uniform cantilever: 3.516 sqrt(E I / (m L^4)).
double cantileverOmega(const WoodParameters& wood) {
    const double r = radius, l = length;
    const double section = glm::pi<double>() * r * r, moment = glm::pi<double>() * std::pow(r, 4.0) / 4.0;
    return 3.516 * std::sqrt(static_cast<double>(wood.elasticModulus) * moment /
                             (static_cast<double>(wood.density) * section * std::pow(l, 4.0)));
}

double massOf(const JointTree& tree) {
    double mass = 0.0;
    for (const JointTree::Point& point : tree.points)
        mass += point.mass;
    return mass;
}

TEST(JointTree, APoleOfOneUnitHasTheFrequencyOfACantilever) {
    const Species species; // clear wood on rigid ground
    const JointTree tree = makeJointTree(poleOf(1), {}, species);
    EXPECT_NEAR(lowestModes(tree, 1)[0].omega / cantileverOmega(species.wood), 1.0, 0.02);
}

TEST(JointTree, APoleOfManyUnitsHasNearlyTheFrequencyOfACantilever) {
    // Joints that are exact for a tip force are slightly too soft under the pole's own mass.
    const Species species;
    const double exact = cantileverOmega(species.wood);
    double before = 0.0;
    for (const int units : {3, 6, 12, 24}) {
        const double ratio = lowestModes(makeJointTree(poleOf(units), {}, species), 1)[0].omega / exact;
        EXPECT_NEAR(ratio, 1.0, 0.07) << units << " units";
        EXPECT_GT(ratio, before) << units << " units should do better than fewer";
        before = ratio;
    }
}

/// Frequency of a pole with a heavy stub at a height, at the end of one of many units or along a single unit.
double omegaWithStub(int units, float height) {
    TreeModel model = poleOf(units);
    const float at = height / length * static_cast<float>(units);
    BranchUnit stub;
    stub.parent = std::min(static_cast<int>(at), units - 1);
    stub.attach = at - static_cast<float>(stub.parent);
    stub.level = 1;
    stub.base = {0.0f, 0.0f, height};
    stub.tip = {0.5f, 0.0f, height};
    stub.baseRadius = stub.tipRadius = 2.0f * radius;
    model.skeleton.units.push_back(stub);
    return lowestModes(makeJointTree(model, {}, Species()), 1)[0].omega;
}

TEST(JointTree, ABranchAlongAUnitActsAsAtTheEndOfAUnit) {
    for (const float height : {1.7f, 4.3f, 6.7f})
        EXPECT_NEAR(omegaWithStub(6, height) / omegaWithStub(80, height), 1.0, 0.06) << height << " m up";
}

TEST(JointTree, JointsHaveTheStiffnessOfTheLoads) {
    const GrownTree oak("oak", {15, 0.3f, 0});
    const JointTree tree = oak.joints();
    const std::vector<UnitLoad> loads = makeUnitLoads(oak.model, oak.scale, oak.species, oak.leaves);
    ASSERT_EQ(tree.links.size(), loads.size());
    for (std::size_t i = 0; i < loads.size(); ++i)
        ASSERT_FLOAT_EQ(static_cast<float>(tree.links[i].stiffness), loads[i].stiffness) << "unit " << i;
}

TEST(JointTree, AxesArePerpendicularToTheLinkAndEachOther) {
    const GrownTree oak("oak", {15, 0.3f, 0});
    const JointTree tree = oak.joints();
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
        const glm::dvec3 along = oak.tipOf(i) - tree.links[i].base;
        const auto& axes = tree.links[i].axes;
        EXPECT_NEAR(glm::dot(axes[0], along) / glm::length(along), 0.0, 1e-5) << "unit " << i;
        EXPECT_NEAR(glm::dot(axes[1], along) / glm::length(along), 0.0, 1e-5) << "unit " << i;
        EXPECT_NEAR(glm::dot(axes[0], axes[1]), 0.0, 1e-5) << "unit " << i;
        EXPECT_NEAR(glm::length(axes[0]), 1.0, 1e-5) << "unit " << i;
    }
}

TEST(JointTree, HasTheMassOfWoodAndLeaves) {
    const GrownTree spruce("Norway spruce", {20, 0.3f, 0});
    double expected = 0.0;
    for (const UnitLoad& load : makeUnitLoads(spruce.model, spruce.scale, spruce.species))
        expected += static_cast<double>(load.mass());
    EXPECT_NEAR(massOf(spruce.joints()) / expected, 1.0, 1e-6);
}

TEST(JointTree, APoleHasTheMassOfItsVolume) {
    const Species species;
    const double expected =
        static_cast<double>(species.wood.density) * glm::pi<double>() * radius * radius * length;
    EXPECT_NEAR(massOf(makeJointTree(poleOf(3), {}, species)) / expected, 1.0, 1e-5);
}

TEST(JointTree, LeavesAddMassAndDragByTheirShare) {
    GrownTree oak("oak", {15, 0.3f, 0});
    double mass[3], drag[3], still[3];
    for (int half = 0; half < 3; ++half) {
        oak.leaves = 0.5f * static_cast<float>(half);
        const JointTree tree = oak.joints();
        mass[half] = massOf(tree);
        drag[half] = still[half] = 0.0;
        for (const JointTree::Point& point : tree.points) {
            drag[half] += point.leafDrag;
            still[half] += point.stillDrag;
        }
    }
    const double leaves = static_cast<double>(leafArea(oak.model, oak.scale, oak.species));
    EXPECT_NEAR((mass[2] - mass[0]) / (leaves * static_cast<double>(oak.species.wood.leafMass)), 1.0, 1e-3);
    EXPECT_NEAR((mass[1] - mass[0]) / (mass[2] - mass[0]), 0.5, 1e-3);
    EXPECT_EQ(drag[0], 0.0) << "bare wood has no leaves";
    EXPECT_GT(drag[2], 1.0);
    EXPECT_NEAR(drag[1] / drag[2], 0.5, 1e-5);
    EXPECT_NEAR(still[2] / (leaves * static_cast<double>(oak.species.wood.stillDrag)), 1.0, 1e-5);
    EXPECT_NEAR(still[1] / still[2], 0.5, 1e-5);
}

TEST(JointTree, EveryCarrierOfAPointMovesIt) {
    const JointTree tree = makeJointTree(poleOf(3), {}, Species());
    const JointTree::Point& point = tree.points.back();
    const glm::dvec3 moved = tree.displacement(point, 0, 0);
    EXPECT_NEAR(std::abs(moved.x), point.place.z, 1e-6);
    EXPECT_NEAR(std::abs(tree.displacement(point, 2, 0).x), point.lever.z, 1e-6);
}

} // namespace
} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
// Against the closed forms of cantilevers (Blevins, Formulas for Natural Frequency and Mode Shape).
#include <osgTreeWind/motion/laws/AxisPaces.h>

#include <glm/gtc/constants.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// An upright pole along z, diameters d0 to d1, in equal units.
TreeModel pole(int units, double length, double d0, double d1) {
    TreeModel model;
    for (int i = 0; i < units; ++i) {
        const double a = static_cast<double>(i) / units, b = static_cast<double>(i + 1) / units;
        BranchUnit unit;
        unit.parent = i - 1;
        unit.base.z = static_cast<float>(length * a);
        unit.tip.z = static_cast<float>(length * b);
        unit.baseRadius = static_cast<float>(0.5 * (d0 + (d1 - d0) * a));
        unit.tipRadius = static_cast<float>(0.5 * (d0 + (d1 - d0) * b));
        model.skeleton.units.push_back(unit);
    }
    return model;
}

/// Bare wood of 10 GPa and 1000 kg/m^3.
std::vector<UnitLoad> bare(const TreeModel& model, const TreeScale& scale = {}) {
    Species species;
    species.wood.elasticModulus = 1.0e10f;
    species.wood.density = 1000.0f;
    return makeUnitLoads(model, scale, species, 0.0f);
}

double speed(const TreeModel& model, double gravity = 0.0) {
    return axisPaces(model, {}, bare(model), gravity)[0];
}

} // namespace

TEST(AxisPaces, AnEvenPoleSwaysAsACantilever) {
    const double expected = 3.5160 * std::sqrt(1.0e7) * 0.05 / 100.0; // beta^2 sqrt(EI / rho A) / L^2
    EXPECT_NEAR(speed(pole(4, 10, 0.2, 0.2)) / expected, 1.0, 0.005);
    EXPECT_NEAR(speed(pole(1, 10, 0.2, 0.2)) / expected, 1.0, 0.04);
}

TEST(AxisPaces, AConeSwaysAsACone) {
    // 8.719 for a full cone; this one ends at a hundredth of its diameter.
    EXPECT_NEAR(speed(pole(12, 10, 0.2, 0.002)) / (8.719 * std::sqrt(1.0e7) * 0.05 / 100.0), 1.0, 0.03);
}

TEST(AxisPaces, AHeavyTipSwaysAsAMassOnASpring) {
    TreeModel model = pole(4, 10, 0.2, 0.2);
    model.skeleton.units.push_back({3, 1, {0, 0, 10}, {0, 0, 10.001f}, 0.001f, 0.001f});
    const double mass = 1.0e5, own = 33.0 / 140.0 * 1000.0 * glm::pi<double>() * 0.01 * 10.0;
    const double stiffness = 3.0 * 1.0e10 * glm::pi<double>() * std::pow(0.2, 4) / 64.0 / 1000.0;
    std::vector<UnitLoad> loads = bare(model);
    loads[4].leafMass = static_cast<float>(mass);
    EXPECT_NEAR(axisPaces(model, {}, loads, 0.0)[0] / std::sqrt(stiffness / (mass + own)), 1.0, 0.002);
}

TEST(AxisPaces, FrequencyGoesAsDiameterOverLengthSquared) {
    const double one = speed(pole(5, 8, 0.2, 0.1));
    EXPECT_NEAR(speed(pole(5, 8, 0.4, 0.2)) / one, 2.0, 0.02);
    EXPECT_NEAR(speed(pole(5, 16, 0.2, 0.1)) / one, 0.25, 0.0025);
}

TEST(AxisPaces, AWholeBareTreeScalesAsItsPoles) {
    const TreeModel model = makeTreeModel({});
    TreeScale thick, tall;
    thick.radius = 2.0f;
    tall.axes = glm::vec3(3.0f);
    const auto one = axisPaces(model, {}, bare(model), 0.0);
    const auto two = axisPaces(model, thick, bare(model, thick), 0.0),
               three = axisPaces(model, tall, bare(model, tall), 0.0);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_NEAR(two[i] / one[i], 2.0, 0.02);
        EXPECT_NEAR(three[i] / one[i], 1.0 / 9.0, 0.01 / 9.0);
    }
}

TEST(AxisPaces, WeightSlowsAPoleByItsShareOfTheBucklingLoad) {
    // Self-buckling of an even pole: rho g A L^3 / (E I) = 7.837 (Greenhill 1881).
    const double length = 12.0, d = 0.1;
    const double share = 1000.0 * 9.81 * std::pow(length, 3) / (7.837 * 1.0e10 * d * d / 16.0);
    const TreeModel slender = pole(6, length, d, d);
    EXPECT_NEAR(speed(slender, 9.81) / speed(slender), std::sqrt(1.0 - share), 0.01);
}

TEST(AxisPaces, WeightQuickensWhatHangs) {
    TreeModel model = pole(6, 15, 0.1, 0.1);
    for (BranchUnit& unit : model.skeleton.units) {
        unit.base.z = -unit.base.z;
        unit.tip.z = -unit.tip.z;
    }
    EXPECT_GT(speed(model, 9.81), 1.05 * speed(model));
}

TEST(AxisPaces, ALimpTwigDoesNotSetThePaceOfItsTrunk) {
    TreeModel model = pole(4, 10, 0.2, 0.1);
    const double alone = speed(model);
    model.skeleton.units.push_back({3, 1, {0, 0, 10}, {2, 0, 10}, 0.001f, 0.001f});
    std::vector<UnitLoad> loads = bare(model);
    loads[4].leafMass = 0.05f;
    const auto both = axisPaces(model, {}, loads, 0.0);
    EXPECT_LT(both[4], 0.2 * alone);
    EXPECT_NEAR(both[0] / alone, 1.0, 0.02);
}

TEST(AxisPaces, WhatSpringsAlongAUnitSwaysAsIfTheUnitEndedThere) {
    const auto withStub = [](int units, float parent, float attach) {
        TreeModel model = pole(units, 10, 0.2, 0.2);
        BranchUnit stub{static_cast<int>(parent), 1, {0, 0, 5}, {0.5f, 0, 5}, 0.2f, 0.2f};
        stub.attach = attach;
        model.skeleton.units.push_back(stub);
        return axisPaces(model, {}, bare(model), 0.0)[0];
    };
    const double exact = withStub(40, 19, 1.0f);
    EXPECT_NEAR(withStub(5, 2, 0.5f) / exact, 1.0, 0.01);
    EXPECT_NEAR(withStub(1, 0, 0.5f) / exact, 1.0, 0.04);
}

TEST(AxisPaces, JointsOfAnAxisBendAsItsWoodUnderAForceAtTheTip) {
    // An even pole in three: together they must move the tip by F L^3 / (3 E I).
    double shift = 0.0;
    for (const double base : {0.0, 2.0, 5.0}) {
        const double length = base == 0.0 ? 2.0 : base == 2.0 ? 3.0 : 5.0, reach = 10.0 - base;
        shift += reach * reach / jointStiffness(1.0e10, 0.2, 0.2, length, reach);
    }
    EXPECT_NEAR(shift / (1000.0 / (3.0 * 1.0e10 * glm::pi<double>() * std::pow(0.2, 4) / 64.0)), 1.0, 1e-9);
}

TEST(AxisPaces, AStiffPoleOnASpringSwaysAsAPendulumOnASpring) {
    // A rigid pole that turns about its foot: omega^2 = k / (m L^2 / 3); its weight takes g m L / 2 of k.
    const TreeModel model = pole(12, 10, 0.2, 0.2);
    std::vector<UnitLoad> loads = bare(model);
    for (UnitLoad& load : loads)
        load.modulus *= 1.0e5f;
    const double mass = 1000.0 * glm::pi<double>() * 0.01 * 10.0, spring = 1.0e5;
    loads[0].rootGive = static_cast<float>(1.0 / spring);
    const double expected = std::sqrt(spring / (mass * 100.0 / 3.0));
    EXPECT_NEAR(axisPaces(model, {}, loads, 0.0)[0] / expected, 1.0, 0.003);
    const double share = 9.81 * mass * 5.0 / spring;
    EXPECT_NEAR(axisPaces(model, {}, loads)[0] / expected, std::sqrt(1.0 - share), 0.003);
}

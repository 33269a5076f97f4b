// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/branchwise/DampedBranches.h>

#include <osgTreeWind/motion/laws/AxisPaces.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// A pole of 4 m and 20 cm that carries one of 2 m and 10 cm.
TreeModel twoPoles() {
    TreeModel model;
    model.skeleton.units = {{-1, 0, {0, 0, 0}, {0, 0, 4}, 0.1f, 0.1f},
                            {0, 1, {0, 0, 4}, {2, 0, 4}, 0.05f, 0.05f}};
    return model;
}

Species bare() {
    Species species;
    species.wood.elasticModulus = 10.0e9f;
    species.wood.density = 1000.0f;
    return species;
}

} // namespace

TEST(DampedBranches, StiffnessIsThatOfARoundCantilever) {
    // 3 E I / L with I = pi d^4 / 64.
    const auto p = makeDampedBranches(twoPoles(), {}, bare());
    EXPECT_NEAR(p[1].stiffness / (3.0 * 10.0e9 * 3.14159265 * 1.0e-4 / 64.0 / 2.0), 1.0, 1e-5);
}

TEST(DampedBranches, EveryUnitOfAnAxisSwingsAtTheSpeedOfTheAxis) {
    TreeModel model = twoPoles();
    model.skeleton.units.insert(model.skeleton.units.begin(), {-1, 0, {0, 0, -4}, {0, 0, 0}, 0.1f, 0.1f});
    model.skeleton.units[1].parent = 0;
    model.skeleton.units[2].parent = 1;
    const auto p = makeDampedBranches(model, {}, bare());
    const auto speeds = axisPaces(model, {}, makeUnitLoads(model, {}, bare()));
    EXPECT_EQ(speeds[0], speeds[1]);
    EXPECT_LT(speeds[1], speeds[2]);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(std::sqrt(p[i].stiffness / p[i].inertia) / speeds[i], 1.0, 1e-5);
}

TEST(DampedBranches, DoublingTheModulusHalvesTheStaticAngle) {
    Species stiff = bare();
    stiff.wood.elasticModulus *= 2.0f;
    const auto soft = makeDampedBranches(twoPoles(), {}, bare()),
               hard = makeDampedBranches(twoPoles(), {}, stiff);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR((hard[i].drag * hard[i].lever / hard[i].stiffness) /
                        (soft[i].drag * soft[i].lever / soft[i].stiffness),
                    0.5, 1e-4);
}

TEST(DampedBranches, BarkBringsNoStiffness) {
    Species species = bare();
    species.wood.underBark = 0.9f;
    EXPECT_NEAR(makeDampedBranches(twoPoles(), {}, species)[1].stiffness /
                    makeDampedBranches(twoPoles(), {}, bare())[1].stiffness,
                0.6561, 1e-5);
}

TEST(DampedBranches, AnExaggeratedAnswerHasTheSameDampingAndMoreTorque) {
    const Laws::DampedBranch p = makeDampedBranches(twoPoles(), {}, bare())[0], more = exaggerated(p, 3.0f);
    EXPECT_NEAR(more.drag * more.lever / (p.drag * p.lever), 3.0f, 1e-5f);
    EXPECT_NEAR(more.drag * more.lever * more.lever / (p.drag * p.lever * p.lever), 1.0f, 1e-5f);
}

TEST(DampedBranches, WindIsTakenAtTheHeightOfTheDrag) {
    // 0.8 m^2 around 2 m, 0.2 m^2 at 4 m.
    const auto p = makeDampedBranches(twoPoles(), {}, bare());
    EXPECT_NEAR(p[0].windHeight, (0.8f * 2.0f + 0.2f * 4.0f) / 1.0f, 1e-5f);
    EXPECT_NEAR(p[1].windHeight, 4.0f, 1e-5f);
}

TEST(DampedBranches, DragOfAnEvenPoleActsAtThreeEighths) {
    const auto p = makeDampedBranches(twoPoles(), {}, bare());
    EXPECT_NEAR(p[1].lever, 0.75f, 1e-5f);
    EXPECT_NEAR(p[1].drag, 0.5f * 1.225f * 0.1f * 2.0f, 1e-5f);
}

TEST(DampedBranches, DragOfATaperedPoleActsLower) {
    TreeModel model = twoPoles();
    model.skeleton.units[1].tipRadius = 0.025f;
    EXPECT_NEAR(makeDampedBranches(model, {}, bare())[1].lever, 2.0f * 0.263f, 1e-3f);
}

TEST(DampedBranches, CarriedDragAddsItsTorqueAndDamping) {
    // Own 0.8 m^2 at 1.5 m, carried 0.2 m^2 at 4 m.
    const auto p = makeDampedBranches(twoPoles(), {}, bare());
    EXPECT_NEAR(p[0].drag * p[0].lever, 0.5f * 1.225f * (0.8f * 1.5f + 0.2f * 4.0f), 1e-4f);
    EXPECT_NEAR(p[0].drag * p[0].lever * p[0].lever, 0.5f * 1.225f * (0.8f * 2.25f + 0.2f * 16.0f), 1e-4f);
}

TEST(DampedBranches, LeavesAddMassAndDrag) {
    // All of them on the branch: 1800 times the trunk's section.
    TreeModel model = twoPoles();
    model.leaves.resize(3);
    for (LeafCluster& leaf : model.leaves)
        leaf.unit = 1;
    const Species species = bare();
    const float area = 1800.0f * 3.14159265f * 0.01f;
    const auto without = makeDampedBranches(twoPoles(), {}, species),
               with = makeDampedBranches(model, {}, species);
    EXPECT_NEAR(with[1].drag / without[1].drag, (0.2f + 0.25f * area) / 0.2f, 1e-3f);
    const double tip = 0.2 * area, wood = 1000.0 * 3.14159265 * 0.0025 * 2.0;
    // Both are spread evenly along the branch; it lies level, so that weight does nothing.
    EXPECT_NEAR((with[1].inertia / without[1].inertia) / ((wood + tip) / wood), 1.0, 1e-3);
}

TEST(DampedBranches, AMeasuredCrownDragStandsForLeavesAndBranches) {
    TreeModel model = twoPoles();
    model.leaves.resize(2);
    model.leaves[0].unit = model.leaves[1].unit = 1;
    model.leaves[0].anchor = {-1, -1, 3};
    model.leaves[1].anchor = {1, 1, 7};
    Species species = bare();
    species.wood.crownDrag = 2.0f;
    species.wood.streamlining = 0.5f;
    const auto p = makeDampedBranches(model, {}, species);
    // 2 m wide and 4 m deep: a rhombus of 4 m^2, C 10^-n at 10 m/s.
    EXPECT_NEAR(p[1].drag / (0.5f * 1.225f * 2.0f * std::pow(10.0f, -0.5f) * 4.0f), 1.0f, 1e-4f);
    EXPECT_FLOAT_EQ(p[1].streamlining, 0.5f);
    EXPECT_LT(p[0].streamlining, 0.5f); // the trunk does not streamline
}

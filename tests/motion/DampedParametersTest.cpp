// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/DampedParameters.h>

#include <gtest/gtest.h>

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

TEST(DampedParameters, StiffnessIsThatOfARoundCantilever) {
    // 3 E I / L with I = pi d^4 / 64.
    const auto p = makeDampedParameters(twoPoles(), {}, bare());
    EXPECT_NEAR(p[1].stiffness / (3.0 * 10.0e9 * 3.14159265 * 1.0e-4 / 64.0 / 2.0), 1.0, 1e-5);
}

TEST(DampedParameters, InertiaOfARodIsAThirdAndOfWhatItCarriesTheWhole) {
    const double small = 1000.0 * 3.14159265 * 0.05 * 0.05 * 2.0,
                 large = 1000.0 * 3.14159265 * 0.1 * 0.1 * 4.0;
    const auto p = makeDampedParameters(twoPoles(), {}, bare());
    EXPECT_NEAR(p[1].inertia / (small * 4.0 / 3.0), 1.0, 1e-5);
    EXPECT_NEAR(p[0].inertia / ((large / 3.0 + small) * 16.0), 1.0, 1e-5);
}

TEST(DampedParameters, DragOfAnEvenPoleActsAtThreeEighths) {
    const auto p = makeDampedParameters(twoPoles(), {}, bare());
    EXPECT_NEAR(p[1].lever, 0.75f, 1e-5f);
    EXPECT_NEAR(p[1].drag, 0.5f * 1.225f * 0.1f * 2.0f, 1e-5f);
}

TEST(DampedParameters, DragOfATaperedPoleActsLower) {
    TreeModel model = twoPoles();
    model.skeleton.units[1].tipRadius = 0.025f;
    EXPECT_NEAR(makeDampedParameters(model, {}, bare())[1].lever, 2.0f * 0.263f, 1e-3f);
}

TEST(DampedParameters, CarriedDragAddsItsTorqueAndDamping) {
    // Own 0.8 m^2 at 1.5 m, carried 0.2 m^2 at 4 m.
    const auto p = makeDampedParameters(twoPoles(), {}, bare());
    EXPECT_NEAR(p[0].drag * p[0].lever, 0.5f * 1.225f * (0.8f * 1.5f + 0.2f * 4.0f), 1e-4f);
    EXPECT_NEAR(p[0].drag * p[0].lever * p[0].lever, 0.5f * 1.225f * (0.8f * 2.25f + 0.2f * 16.0f), 1e-4f);
}

TEST(DampedParameters, LeavesAddMassAndDrag) {
    TreeModel model = twoPoles();
    model.leaves.resize(3);
    for (LeafCluster& leaf : model.leaves)
        leaf.unit = 1;
    Species species = bare();
    species.tree.leaves.length = species.tree.leaves.width = 1.0f;
    const auto without = makeDampedParameters(twoPoles(), {}, species),
               with = makeDampedParameters(model, {}, species);
    EXPECT_NEAR(with[1].inertia - without[1].inertia, 3.0f * 0.2f / 3.0f * 4.0f, 1e-4f);
    EXPECT_NEAR(with[1].drag / without[1].drag, (0.2f + 0.25f * 3.0f) / 0.2f, 1e-4f);
}

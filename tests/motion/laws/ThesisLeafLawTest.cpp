// SPDX-License-Identifier: MIT
// shaders/law/thesis_leaf.glsl against numbers calculated from appendix D of the thesis.
#include <osgTreeWind/motion/laws/Laws.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

const glm::vec4 restingLeaf(0.0f);

Laws::ThesisLeaf leaf(float partialSteps = 1.0f) {
    return {0.5f, 0.2f, 1.0f, partialSteps, 1.0f, 0.7f};
}

} // namespace

TEST(ThesisLeafLaw, TargetsComeFromTheNoise) {
    const glm::vec4 state = Laws().thesisLeafStep(restingLeaf, 0.4f, 0.5f, leaf());
    EXPECT_FLOAT_EQ(state.x, 0.2f); // 0.5 * 0.4
    EXPECT_FLOAT_EQ(state.y, 0.1f); // 0.2 * 0.5
    EXPECT_FLOAT_EQ(state.z, 0.5f); // 1 * 0.45 + 0.7 * 0.2 = 0.59, limited
    EXPECT_FLOAT_EQ(state.w, 0.4f);
}

TEST(ThesisLeafLaw, RotationIsNoisePlusTheLinkedMotion) {
    EXPECT_NEAR(Laws().thesisLeafStep(restingLeaf, 0.1f, 0.3f, leaf()).z, 0.2f + 0.7f * 0.05f, 1e-6f);
}

TEST(ThesisLeafLaw, SinkingAnglesAreLimitedByMaxZ) {
    EXPECT_FLOAT_EQ(Laws().thesisLeafStep(restingLeaf, -0.5f, 0.3f, leaf()).x, -0.2f); // target -0.25
}

TEST(ThesisLeafLaw, GrowingAnglesAreLimitedByMaxX) {
    EXPECT_FLOAT_EQ(Laws().thesisLeafStep(restingLeaf, 1.0f, 1.0f, leaf()).z, 0.5f); // target 1.35
}

TEST(ThesisLeafLaw, TakesOnePartialStep) {
    const glm::vec4 state = Laws().thesisLeafStep({0.1f, 0.1f, 0, 0}, 0.4f, -0.5f, leaf(10.0f));
    EXPECT_NEAR(state.x, 0.1f + 0.01f, 1e-6f);
    EXPECT_NEAR(state.y, 0.1f - 0.02f, 1e-6f);
}

TEST(ThesisLeafLaw, FirstNoiseOfZeroBecomesOneAndLeavesTheOtherTarget) {
    const glm::vec4 state = Laws().thesisLeafStep(restingLeaf, 0.0f, -0.5f, leaf());
    EXPECT_FLOAT_EQ(state.x, 0.5f);
    EXPECT_FLOAT_EQ(state.y, 0.01f);
    EXPECT_FLOAT_EQ(state.w, 0.0f);
}

TEST(ThesisLeafLaw, SecondNoiseOfZeroBecomesOneAndLeavesTheOtherTarget) {
    const glm::vec4 state = Laws().thesisLeafStep(restingLeaf, 0.5f, 0.0f, leaf());
    EXPECT_FLOAT_EQ(state.x, 0.01f);
    EXPECT_FLOAT_EQ(state.y, 0.2f);
}

TEST(ThesisLeafLaw, BothNoisesOfZeroSetBothTargets) {
    const glm::vec4 state = Laws().thesisLeafStep(restingLeaf, 0.0f, 0.0f, leaf());
    EXPECT_FLOAT_EQ(state.x, 0.5f);
    EXPECT_FLOAT_EQ(state.y, 0.2f);
}

TEST(ThesisLeafLaw, FactorScalesTheMotion) {
    Laws::ThesisLeaf calm = leaf();
    calm.factor = 0.25f;
    EXPECT_FLOAT_EQ(Laws().thesisLeafStep(restingLeaf, 0.4f, 0.4f, calm).x, 0.05f);
}

TEST(ThesisLeafLaw, AReachedTargetIsKept) {
    const Laws::ThesisLeaf still = leaf(3.0f);
    const glm::vec4 there(0.2f, 0.08f, 0.2f, 0.4f);
    const glm::vec4 state = Laws().thesisLeafStep(there, 0.4f, 0.4f, still);
    EXPECT_NEAR(state.x, there.x, 1e-6f);
    EXPECT_NEAR(state.y, there.y, 1e-6f);
}

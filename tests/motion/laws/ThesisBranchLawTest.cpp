// SPDX-License-Identifier: MIT
// shaders/law/thesis_branch.glsl against numbers calculated from appendix B and §3.1 of the thesis.
#include <osgTreeWind/motion/laws/Laws.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace osgTreeWind;

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
const glm::vec4 restingBranch(0.0f);

/// k = 1 and L = 1, so that loads are deflections over length.
Laws::ThesisBranch unitBranch(float maxAngle = 0.5f) {
    return {1.0f, 1.0f, maxAngle, 24.0f, 0.0f};
}

glm::vec4 thesis(const glm::vec4& state, const glm::vec3& wind, float noise,
                 const Laws::ThesisBranch& branch) {
    return Laws().thesisBranchStep(state, wind, glm::vec3(noise), branch);
}

glm::vec4 smooth(const glm::vec4& state, const glm::vec3& wind, float noise,
                 const Laws::ThesisBranch& branch) {
    return Laws().thesisSmoothBranchStep(state, wind, glm::vec3(noise), branch);
}

} // namespace

TEST(ThesisBranchLaw, SpringIsARectangularCantilever) {
    // 12 GPa, 5 cm by 5 cm, 2 m: k = 12e9 * 0.05^4 / 32.
    EXPECT_NEAR(Laws().cantileverSpring(12.0e9f, 0.05f, 0.05f, 2.0f), 2343.75f, 0.01f);
    // Width counts once, thickness three times.
    EXPECT_FLOAT_EQ(Laws().cantileverSpring(4.0f, 3.0f, 2.0f, 1.0f), 24.0f);
}

TEST(ThesisBranchLaw, MatchesAHandCalculationInALightWind) {
    const glm::vec4 state = thesis(restingBranch, glm::vec3(0.1f), 0.3f, unitBranch());
    EXPECT_NEAR(state.x, 0.07217f, 1e-5f);
    EXPECT_NEAR(state.y, 0.08250f, 1e-5f);
}

TEST(ThesisBranchLaw, MatchesAHandCalculationBeyondTheArcSine) {
    // In vertical wind only, the substitute angles are asin 0.6 and asin 0.3; the first one is limited.
    const glm::vec4 state = thesis(restingBranch, {0, 9, 0}, 0.3f, unitBranch(0.5f));
    EXPECT_NEAR(state.x, 0.5f, 1e-5f);
    EXPECT_NEAR(state.y, 0.3046f, 1e-3f);
    EXPECT_NEAR(state.y, std::asin(0.3f), 1e-6f);
}

TEST(ThesisBranchLaw, EachAxisBeyondTheArcSineSubstitutesAllAngles) {
    for (const glm::vec3 wind : {glm::vec3(2, 0, 0), glm::vec3(0, 2, 0), glm::vec3(0, 0, 2)}) {
        const glm::vec4 state = thesis(restingBranch, wind, 0.3f, unitBranch(1.5f));
        EXPECT_NEAR(state.x, std::asin(0.6f), 1e-6f);
        EXPECT_NEAR(state.y, std::asin(0.3f), 1e-6f);
    }
}

TEST(ThesisBranchLaw, ArcSineIsClampedBelow) {
    // The thesis' listing would give NaN for a share of -7.
    const glm::vec4 state = thesis(restingBranch, {-10, 0, -10}, 0.3f, unitBranch(0.4f));
    EXPECT_FLOAT_EQ(state.x, -0.4f);
    EXPECT_FLOAT_EQ(state.y, -0.4f);
}

TEST(ThesisBranchLaw, StateContainsTheWind) {
    const glm::vec4 state = thesis(restingBranch, {1, 2, 3}, 0.3f, unitBranch());
    EXPECT_EQ(state.z, 1.0f);
    EXPECT_EQ(state.w, 3.0f);
}

TEST(ThesisBranchLaw, AnglesAddUpToTheLimitUnderConstantWind) {
    glm::vec4 state = restingBranch;
    for (int frame = 0; frame < 100; ++frame)
        state = thesis(state, {0.05f, 0, -0.05f}, 0.3f, unitBranch());
    EXPECT_EQ(state.x, 0.5f);
    EXPECT_EQ(state.y, -0.5f);
}

TEST(ThesisBranchLaw, SpeedFollowsTheNumberOfFrames) {
    glm::vec4 slow = restingBranch, fast = restingBranch;
    for (int frame = 0; frame < 4; ++frame) {
        fast = thesis(fast, {0.05f, 0, 0}, 0.3f, unitBranch());
        if (frame % 2 == 0)
            slow = thesis(slow, {0.05f, 0, 0}, 0.3f, unitBranch());
    }
    EXPECT_NEAR(fast.x, 2.0f * slow.x, 1e-6f);
}

TEST(ThesisBranchLaw, CalmFreezesTheState) {
    const glm::vec4 bent(0.3f, -0.2f, 4.0f, 5.0f);
    const glm::vec4 state = thesis(bent, glm::vec3(0.0f), 0.3f, unitBranch());
    EXPECT_EQ(state.x, 0.3f);
    EXPECT_EQ(state.y, -0.2f);
}

TEST(ThesisBranchLaw, NearlyNoWindIsCalmAlongZOnly) {
    const glm::vec4 state = thesis(restingBranch, {5e-6f, 0, 5e-6f}, 0.3f, unitBranch());
    EXPECT_NEAR(state.x, 0.7f * 0.003005f, 1e-7f);
    EXPECT_EQ(state.y, 0.0f);
}

TEST(ThesisBranchLaw, NoiseOfZeroCountsAsOneEvenInCalm) {
    const glm::vec4 state = thesis(restingBranch, glm::vec3(0.0f), 0.0f, unitBranch());
    EXPECT_NEAR(state.x, std::asin(0.007f), 1e-7f);
    EXPECT_NEAR(state.y, std::asin(0.008f), 1e-7f);
}

TEST(ThesisBranchLaw, PartialStepsAndLevelHaveNoEffectAsPublished) {
    Laws::ThesisBranch other = unitBranch();
    other.partialSteps = 2.0f;
    other.levelLoad = 5.0f;
    EXPECT_EQ(thesis(restingBranch, glm::vec3(0.1f), 0.3f, unitBranch()),
              thesis(restingBranch, glm::vec3(0.1f), 0.3f, other));
}

TEST(ThesisBranchLaw, WindTowardPositiveAxesMakesPositiveAngles) {
    const glm::vec4 state = thesis(restingBranch, {0.2f, 0, 0.2f}, -0.5f, unitBranch());
    EXPECT_GT(state.x, 0.0f);
    EXPECT_GT(state.y, 0.0f);
}

TEST(ThesisSmoothBranchLaw, TakesOnePartialStep) {
    const glm::vec4 state = smooth({0.1f, 0.2f, 0, 0}, glm::vec3(0.1f), 0.3f, unitBranch());
    EXPECT_NEAR(state.x, 0.1f + 0.07217f / 24.0f, 1e-6f);
    EXPECT_NEAR(state.y, 0.2f + 0.08250f / 24.0f, 1e-6f);
}

TEST(ThesisSmoothBranchLaw, TheTargetIsLimitedBeforeThePartialStep) {
    // 0.49 + asin 0.6 is limited to 0.5; a twenty-fourth of the remaining 0.01 is taken.
    const glm::vec4 state = smooth({0.49f, 0, 0, 0}, {9, 0, 0}, 0.3f, unitBranch(0.5f));
    EXPECT_NEAR(state.x, 0.49f + 0.01f / 24.0f, 1e-6f);
}

TEST(ThesisSmoothBranchLaw, LevelAddsToTheLoad) {
    Laws::ThesisBranch branch = unitBranch();
    branch.partialSteps = 1.0f;
    branch.levelLoad = 0.25f;
    EXPECT_NEAR(smooth(restingBranch, glm::vec3(0.1f), 0.3f, branch).x, std::asin(0.7f * 0.353f), 1e-6f);
}

TEST(ThesisSmoothBranchLaw, CalmFreezesTheStateForAnyNoiseAndLevel) {
    Laws::ThesisBranch branch = unitBranch();
    branch.levelLoad = 0.25f;
    for (const float noise : {0.0f, 0.3f, -1.0f})
        EXPECT_EQ(smooth({0.3f, -0.2f, 0, 0}, glm::vec3(0.0f), noise, branch), glm::vec4(0.3f, -0.2f, 0, 0));
}

TEST(ThesisSmoothBranchLaw, WithOnePartialStepIsTheThesisLaw) {
    Laws::ThesisBranch branch = unitBranch();
    branch.partialSteps = 1.0f;
    for (const glm::vec3 wind : {glm::vec3(0.1f), glm::vec3(-0.4f, 0, 0.2f), glm::vec3(0, 9, 0.1f)}) {
        const glm::vec4 a = smooth({0.1f, 0.1f, 0, 0}, wind, 0.3f, branch);
        const glm::vec4 b = thesis({0.1f, 0.1f, 0, 0}, wind, 0.3f, branch);
        EXPECT_NEAR(a.y, b.y, 1e-6f);
        EXPECT_EQ(a.z, b.z);
    }
}

TEST(ThesisBranchLaw, NaNWindIsCalm) {
    EXPECT_EQ(thesis({0.3f, 0.1f, 0, 0}, glm::vec3(notANumber), 0.3f, unitBranch()),
              glm::vec4(0.3f, 0.1f, 0, 0));
}

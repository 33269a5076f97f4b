// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/Rotations.h>

#include <tests/Near.h>

#include <osgTreeWind/model/ThesisAxes.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

const glm::vec3 up(0, 0, 1);

/// Rotation about an axis in the thesis' frame.
glm::quat thesisTurn(const glm::vec3& axis, float angle) {
    return glm::angleAxis(angle, fromThesis(axis));
}

} // namespace

TEST(Rotations, WindTowardPlusXMovesATipTowardPlusX) {
    expectNear(branchRotation({0.4f, 0, 0, 0}) * up, {std::sin(0.4f), 0, std::cos(0.4f)});
}

TEST(Rotations, WindTowardThesisPlusZMovesATipThere) {
    const glm::vec3 tip = toThesis(branchRotation({0, 0.4f, 0, 0}) * up);
    expectNear(tip, {0, std::cos(0.4f), std::sin(0.4f)});
}

TEST(Rotations, BranchTurnsAboutZFirstThenAboutX) {
    const glm::quat expected = thesisTurn({1, 0, 0}, 0.3f) * thesisTurn({0, 0, 1}, -0.7f);
    for (const glm::vec3 v : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), up})
        expectNear(branchRotation({0.7f, 0.3f, 0, 0}) * v, expected * v);
}

TEST(Rotations, LeafTurnsAboutThePetioleThenZThenX) {
    const glm::quat expected =
        thesisTurn({1, 0, 0}, 0.3f) * thesisTurn({0, 0, 1}, 0.2f) * thesisTurn({0, 1, 0}, 0.9f);
    for (const glm::vec3 v : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), up})
        expectNear(leafRotation({0.2f, 0.3f, 0.9f, 0}) * v, expected * v);
}

TEST(Rotations, LeafRotationKeepsThePetiole) {
    expectNear(leafRotation({0, 0, 1.0f, 0}) * up, up);
}

TEST(Rotations, ShaderArithmeticMatchesGlm) {
    Laws laws;
    const glm::vec4 q = laws.branchRotation(0.7f, -0.4f);
    const glm::quat g(q.w, q.x, q.y, q.z);
    EXPECT_NEAR(glm::length(q), 1.0f, 1e-6f);
    expectNear(laws.turnVector(q, {0.3f, -2.0f, 1.5f}), g * glm::vec3(0.3f, -2.0f, 1.5f));
}

TEST(Rotations, AxesOfAnUprightBranchAreThoseOfTheThesis) {
    EXPECT_EQ(Laws().branchAxis1({0, 0, 1}), glm::vec3(1, 0, 0));
    EXPECT_EQ(Laws().branchAxis3({0, 0, 1}), glm::vec3(0, -1, 0));
}

TEST(Rotations, APositiveAngleMovesTheTipAlongItsAxis) {
    Laws laws;
    for (const glm::vec3 given : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0),
                                  glm::vec3(0.3f, -0.5f, 0.7f), glm::vec3(-1, 0.01f, 0)}) {
        const glm::vec3 d = glm::normalize(given);
        const glm::vec3 e1 = laws.branchAxis1(d), e3 = laws.branchAxis3(d);
        EXPECT_NEAR(glm::dot(e1, d), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(e3), 1.0f, 1e-6f);
        expectNear(swungRotation({0.3f, 0.0f}, d) * d, std::cos(0.3f) * d + std::sin(0.3f) * e1);
        expectNear(swungRotation({0.0f, 0.3f}, d) * d, std::cos(0.3f) * d + std::sin(0.3f) * e3);
    }
    EXPECT_EQ(laws.swungRotation(0, 0, {0, 0, 1}), glm::vec4(0, 0, 0, 1));
}

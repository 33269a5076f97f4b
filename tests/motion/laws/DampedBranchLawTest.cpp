// SPDX-License-Identifier: MIT
// shaders/law/damped_branch.glsl against closed forms.
#include <osgTreeWind/motion/laws/Laws.h>

#include <osgTreeWind/model/Random.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace osgTreeWind;

namespace {

/// 1 Hz, lightly damped, no air.
Laws::DampedBranch vacuum(float ratio) {
    const float omega = 6.2831853f, inertia = 2.0f;
    const float stiffness = inertia * omega * omega, damping = 2.0f * ratio * omega * inertia;
    return {stiffness, inertia, damping, 0.0f, 0.4f, 1.5f, 0.0f, 25.0f, {0, 0, 1}, 0.0f};
}

Laws::DampedBranch inAir() {
    Laws::DampedBranch branch = vacuum(0.05f);
    branch.drag = 1.2f;
    return branch;
}

glm::vec4 run(glm::vec4 state, const glm::vec2& wind, const Laws::DampedBranch& branch, double seconds,
              int rate) {
    const int frames = static_cast<int>(std::lround(seconds * rate));
    for (int i = 0; i < frames; ++i)
        state = Laws().dampedBranchStep(state, wind, wind, branch, 1.0f / static_cast<float>(rate));
    return state;
}

/// Free oscillation from `start` at rest with gamma = ratio * omega.
double decay(double start, double omega, double ratio, double t) {
    const double gamma = ratio * omega;
    if (ratio < 1.0) {
        const double d = omega * std::sqrt(1.0 - ratio * ratio);
        return start * std::exp(-gamma * t) * (std::cos(d * t) + gamma / d * std::sin(d * t));
    }
    if (ratio > 1.0) {
        const double q = omega * std::sqrt(ratio * ratio - 1.0);
        return 0.5 * start *
               ((1.0 + gamma / q) * std::exp((q - gamma) * t) +
                (1.0 - gamma / q) * std::exp(-(q + gamma) * t));
    }
    return start * std::exp(-gamma * t) * (1.0 + gamma * t);
}

} // namespace

TEST(DampedBranchLaw, SettlesAtTheStaticDeflection) {
    for (const float wind : {3.0f, -3.0f}) {
        const Laws::DampedBranch branch = inAir();
        const glm::vec4 state = run(glm::vec4(0.0f), {wind, 0.5f * wind}, branch, 60.0, 60);
        const float expected = branch.lever * branch.drag * wind * std::abs(wind) / branch.stiffness;
        EXPECT_NEAR(state.x / expected, 1.0f, 1e-5f);
        EXPECT_NEAR(state.y / expected, 0.25f, 1e-5f);
        EXPECT_NEAR(state.z, 0.0f, 1e-6f);
    }
}

TEST(DampedBranchLaw, FreeDecayFollowsTheClosedForm) {
    for (const float ratio : {0.0f, 0.05f, 0.7f, 1.0f, 1.0001f, 1.5f, 8.0f})
        for (int tenth = 1; tenth <= 30; ++tenth) {
            const double t = tenth / 10.0;
            const glm::vec4 state = run({0.3f, 0, 0, 0}, glm::vec2(0.0f), vacuum(ratio), t, 60);
            EXPECT_NEAR(state.x, decay(0.3, 6.2831853, ratio, t), 1.1e-5) << "ratio " << ratio << " at " << t;
        }
}

TEST(DampedBranchLaw, QuadraticDragAloneSlowsHyperbolically) {
    // J w' = -drag l^3 w |w|: w = w0 / (1 + drag l^3 w0 t / J). No spring to speak of.
    const Laws::DampedBranch branch{1e-6f, 2.0f, 0.0f, 40.0f, 0.5f, 1.5f, 0.0f, 25.0f, {0, 0, 1}, 0.0f};
    const glm::vec4 state = run({-1.0f, 0, 1.5f, 0}, glm::vec2(0.0f), branch, 1.0, 120);
    EXPECT_NEAR(state.z, 1.5 / (1.0 + 40.0 * 0.125 * 1.5 / 2.0), 2e-4);
}

TEST(DampedBranchLaw, EnergyDoesNotRiseInACalm) {
    for (const Laws::DampedBranch& branch : {vacuum(0.0f), vacuum(0.05f), inAir()}) {
        glm::vec4 state(0.5f, 0, 1.0f, 0);
        double before = 1e30;
        for (int i = 0; i < 2000; ++i) {
            state = Laws().dampedBranchStep(state, glm::vec2(0.0f), glm::vec2(0.0f), branch, 1.0f / 50.0f);
            const double energy =
                0.5 * branch.inertia * state.z * state.z + 0.5 * branch.stiffness * state.x * state.x;
            ASSERT_LE(energy, before * (1.0 + 1e-5));
            before = energy;
        }
    }
}

TEST(DampedBranchLaw, IsIndependentOfTheFrameRate) {
    const Laws::DampedBranch branch = inAir();
    float peak = 0.0f;
    std::vector<float> reference;
    for (int tenth = 1; tenth <= 30; ++tenth) {
        reference.push_back(run(glm::vec4(0.0f), {6, 0}, branch, tenth / 10.0, 1000).x);
        peak = std::max(peak, std::abs(reference.back()));
    }
    for (const int rate : {10, 20, 30, 60, 120, 240})
        for (int tenth = 1; tenth <= 30; ++tenth)
            EXPECT_NEAR(run(glm::vec4(0.0f), {6, 0}, branch, tenth / 10.0, rate).x,
                        reference[static_cast<std::size_t>(tenth - 1)], 1e-4f * peak)
                << rate << " Hz at " << tenth / 10.0;
}

TEST(DampedBranchLaw, NoTimeIsNoMotion) {
    const glm::vec4 state(0.2f, -0.1f, 1.0f, 2.0f);
    EXPECT_EQ(Laws().dampedBranchStep(state, {9, 9}, {9, 9}, inAir(), 0.0f), state);
    EXPECT_EQ(Laws().dampedBranchStep(state, {9, 9}, {9, 9}, inAir(), -1.0f), state);
}

TEST(DampedBranchLaw, AtTheLimitNothingMovesOutward) {
    const glm::vec4 state = run(glm::vec4(0.0f), {400, -400}, inAir(), 2.0, 60);
    EXPECT_EQ(state, glm::vec4(1.5f, -1.5f, 0.0f, 0.0f));
}

TEST(DampedBranchLaw, LeavesTheLimitWhenTheWindDrops) {
    const glm::vec4 bent = run(glm::vec4(0.0f), {400, 0}, inAir(), 2.0, 60);
    EXPECT_LT(run(bent, {0, 0}, inAir(), 0.1, 60).x, 1.4f);
}

TEST(DampedBranchLaw, AxesOfAnUprightBranchAreThoseOfTheThesis) {
    EXPECT_EQ(Laws().branchAxis1({0, 0, 1}), glm::vec3(1, 0, 0));
    EXPECT_EQ(Laws().branchAxis3({0, 0, 1}), glm::vec3(0, -1, 0));
}

TEST(DampedBranchLaw, APositiveAngleMovesTheTipAlongItsAxis) {
    Laws laws;
    for (const glm::vec3 given : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0),
                                  glm::vec3(0.3f, -0.5f, 0.7f), glm::vec3(-1, 0.01f, 0)}) {
        const glm::vec3 d = glm::normalize(given);
        const glm::vec3 e1 = laws.branchAxis1(d), e3 = laws.branchAxis3(d);
        EXPECT_NEAR(glm::dot(e1, d), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(e3), 1.0f, 1e-6f);
        EXPECT_LT(glm::length(laws.turnVector(laws.dampedRotation(0.3f, 0, d), d) -
                              (std::cos(0.3f) * d + std::sin(0.3f) * e1)),
                  1e-6f);
        EXPECT_LT(glm::length(laws.turnVector(laws.dampedRotation(0, 0.3f, d), d) -
                              (std::cos(0.3f) * d + std::sin(0.3f) * e3)),
                  1e-6f);
    }
    EXPECT_EQ(laws.dampedRotation(0, 0, {0, 0, 1}), glm::vec4(0, 0, 0, 1));
}

TEST(DampedBranchLaw, StepResponseFollowsTheClosedFormForAnyDamping) {
    // Air at rest far away pushes through drag alone, too weakly here to damp: b l v is a constant torque.
    for (const float ratio : {0.02f, 0.1f, 0.5f, 0.99f, 1.0f, 1.01f, 3.0f, 50.0f}) {
        Laws::DampedBranch branch = vacuum(ratio);
        branch.drag = 1e-9f;
        branch.lever = 1e-3f;
        branch.stiffness = 1e-6f * 39.478418f;
        branch.inertia = 1e-6f;
        branch.damping = 2.0f * ratio * 6.2831853f * branch.inertia;
        const double settled = 1e-9 * 1e-3 * 1e6 / branch.stiffness;
        double peak = 0.0, off = 0.0;
        for (int tenth = 1; tenth <= 40; ++tenth) {
            const double t = tenth / 10.0;
            const double x = run(glm::vec4(0.0f), {1000.0f, 0.0f}, branch, t, 60).x / settled;
            peak = std::max(peak, std::abs(x));
            off = std::max(off, std::abs(x - (1.0 - decay(1.0, 6.2831853, ratio, t))));
        }
        EXPECT_LT(off, 1e-4 * std::max(peak, 1.0)) << "ratio " << ratio;
    }
}

TEST(DampedBranchLaw, TwoHundredThousandRandomStepsStayFinite) {
    Random random(7);
    glm::vec4 state(0.0f);
    glm::vec2 wind(0.0f);
    for (int i = 0; i < 200000; ++i) {
        const float seconds = std::pow(10.0f, -5.0f + 8.0f * random.uniform());
        Laws::DampedBranch branch = inAir();
        branch.streamlining = random.uniform();
        const glm::vec2 before = wind;
        wind = {75.0f * random.symmetric(), 75.0f * random.symmetric()};
        state = Laws().dampedBranchStep(state, before, wind, branch, seconds);
        for (int k = 0; k < 4; ++k)
            ASSERT_TRUE(std::isfinite(state[k])) << "step " << i;
        ASSERT_LE(std::max(std::abs(state.x), std::abs(state.y)), branch.maxAngle);
    }
}

TEST(DampedBranchLaw, GustsAreFollowedAtAnyFrameRate) {
    // Three sines for gusts; each frame knows the wind of its start and of its end, as the forest does.
    const auto gusty = [](double t) {
        return static_cast<float>(6.0 + 2.0 * std::sin(1.1 * t) + 1.0 * std::sin(2.7 * t + 1.0) +
                                  0.5 * std::sin(5.3 * t + 2.0));
    };
    const auto path = [&](int rate) {
        std::vector<float> tenths;
        glm::vec4 state(0.0f);
        for (int i = 1; i <= 20 * rate; ++i) {
            state = Laws().dampedBranchStep(state, {gusty((i - 1.0) / rate), 0},
                                            {gusty(static_cast<double>(i) / rate), 0}, inAir(),
                                            1.0f / static_cast<float>(rate));
            if (i % (rate / 10) == 0)
                tenths.push_back(state.x);
        }
        return tenths;
    };
    const std::vector<float> reference = path(3840);
    float peak = 0.0f;
    for (const float x : reference)
        peak = std::max(peak, std::abs(x));
    const auto worst = [&](int rate) {
        const std::vector<float> tenths = path(rate);
        float off = 0.0f;
        for (std::size_t i = 0; i < tenths.size(); ++i)
            off = std::max(off, std::abs(tenths[i] - reference[i]));
        return off / peak;
    };
    RecordProperty("offAt30Hz", std::to_string(worst(30)));
    RecordProperty("offAt120Hz", std::to_string(worst(120)));
    EXPECT_LT(worst(30), 6e-3f);
    EXPECT_LT(worst(120), 5e-4f);
}

TEST(DampedBranchLaw, StreamliningIsThePowerLawBetweenTenAndItsEnd) {
    Laws laws;
    EXPECT_EQ(laws.streamlinedShare(0.75f, 0.0f, 25.0f, 3.0f), 1.0f);
    EXPECT_NEAR(laws.streamlinedShare(0.75f, 0.0f, 25.0f, 20.0f), std::pow(2.0f, -0.75f), 1e-6f);
    EXPECT_NEAR(laws.streamlinedShare(0.75f, 0.0f, 25.0f, 60.0f), std::pow(2.5f, -0.75f), 1e-6f);
    EXPECT_EQ(laws.streamlinedShare(0.0f, 0.0f, 25.0f, 60.0f), 1.0f);
}

TEST(DampedBranchLaw, StreamliningGoesOnDownToALightBreeze) {
    Laws laws;
    EXPECT_EQ(laws.streamlinedShare(0.75f, 0.35f, 25.0f, 10.0f), 1.0f) << "where it is anchored";
    EXPECT_NEAR(laws.streamlinedShare(0.75f, 0.35f, 25.0f, 20.0f), std::pow(2.0f, -0.75f), 1e-6f);
    EXPECT_NEAR(laws.streamlinedShare(0.75f, 0.35f, 25.0f, 5.0f), std::pow(2.0f, 0.35f), 2e-6f);
    EXPECT_NEAR(laws.streamlinedShare(0.75f, 0.35f, 25.0f, 1.6f), std::pow(6.25f, 0.35f), 4e-6f);
    EXPECT_EQ(laws.streamlinedShare(0.75f, 0.35f, 25.0f, 0.0f),
              laws.streamlinedShare(0.75f, 0.35f, 25.0f, 1.6f));
}

// SPDX-License-Identifier: MIT
// Every law, for any input, stays finite and within limits, and recovers when the input is valid again.
#include <osgTreeWind/motion/laws/Laws.h>

#include <osgTreeWind/base/Random.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace osgTreeWind;

namespace {

using Limits = std::numeric_limits<float>;

constexpr std::array<float, 14> hostile = {0.0f,
                                           -0.0f,
                                           Limits::denorm_min(),
                                           -Limits::denorm_min(),
                                           1.0e-30f,
                                           1.0e30f,
                                           -1.0e30f,
                                           Limits::max(),
                                           Limits::lowest(),
                                           Limits::infinity(),
                                           -Limits::infinity(),
                                           Limits::quiet_NaN(),
                                           0.3f,
                                           -5.0f};
constexpr float quarterTurn = 1.5707964f;

using Step = glm::vec4 (*)(const std::array<float, 16>&);

/// Slots: state 0-3, wind or noise 4-9, parameters 10-15.
glm::vec4 state(const std::array<float, 16>& v) {
    return {v[0], v[1], v[2], v[3]};
}
glm::vec4 thesis(const std::array<float, 16>& v) {
    return Laws().thesisBranchStep(state(v), {v[4], v[5], v[6]}, {v[7], v[8], v[9]},
                                   {v[10], v[11], v[12], v[13], v[14]});
}
glm::vec4 smooth(const std::array<float, 16>& v) {
    return Laws().thesisSmoothBranchStep(state(v), {v[4], v[5], v[6]}, {v[7], v[8], v[9]},
                                         {v[10], v[11], v[12], v[13], v[14]});
}
glm::vec4 leaf(const std::array<float, 16>& v) {
    return Laws().thesisLeafStep(state(v), v[7], v[8], {v[12], v[12], v[13], v[14], v[15], v[11]});
}

struct Case {
    const char* name;
    Step step;
    std::array<float, 16> sane;
};

class LawRobustness : public testing::TestWithParam<Case> {};

/// Requirements on every step; maxAngle is slot 12.
testing::AssertionResult holds(const glm::vec4& result, float maxAngle) {
    const float limit = maxAngle >= 0.0f && maxAngle <= quarterTurn ? maxAngle : quarterTurn;
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(result[i]))
            return testing::AssertionFailure() << "component " << i << " is " << result[i];
    for (int i = 0; i < 2; ++i)
        if (std::abs(result[i]) > limit)
            return testing::AssertionFailure() << "angle " << result[i] << " beyond " << limit;
    return testing::AssertionSuccess();
}

/// Whether valid steps after a bad one lead to the same state as without it.
testing::AssertionResult recovers(const Case& law, const glm::vec4& result) {
    std::array<float, 16> disturbed = law.sane, clean = law.sane;
    for (int i = 0; i < 4; ++i)
        disturbed[static_cast<std::size_t>(i)] = result[i];
    for (int frame = 0; frame < 400; ++frame) {
        const glm::vec4 a = law.step(disturbed), b = law.step(clean);
        for (int i = 0; i < 4; ++i) {
            disturbed[static_cast<std::size_t>(i)] = a[i];
            clean[static_cast<std::size_t>(i)] = b[i];
        }
        if (const auto ok = holds(a, law.sane[12]); !ok)
            return ok;
    }
    for (std::size_t i = 0; i < 4; ++i)
        if (std::abs(disturbed[i] - clean[i]) > 1e-4f)
            return testing::AssertionFailure()
                   << "component " << i << ": " << disturbed[i] << " against " << clean[i];
    return testing::AssertionSuccess();
}

} // namespace

TEST_P(LawRobustness, OneBadInputAtATime) {
    const Case& law = GetParam();
    for (std::size_t slot = 0; slot < 16; ++slot)
        for (const float value : hostile) {
            std::array<float, 16> input = law.sane;
            input[slot] = value;
            const glm::vec4 result = law.step(input);
            EXPECT_TRUE(holds(result, input[12])) << "slot " << slot << " = " << value;
            EXPECT_TRUE(recovers(law, result)) << "slot " << slot << " = " << value;
        }
}

TEST_P(LawRobustness, AnyMixtureOfBadInputs) {
    const Case& law = GetParam();
    Random random(11);
    for (int trial = 0; trial < 200000; ++trial) {
        std::array<float, 16> input = law.sane;
        for (float& value : input)
            if (random.uniform() < 0.5f)
                value = hostile[random.next() % hostile.size()];
        ASSERT_TRUE(holds(law.step(input), input[12])) << "trial " << trial;
    }
}

INSTANTIATE_TEST_SUITE_P(
    , LawRobustness,
    testing::Values(
        Case{"Thesis", thesis, {0.1f, 0.1f, 0, 0, 3, 1, 2, 0.3f, 0.2f, 0.1f, 50, 1, 0.5f, 4, 0.1f, 1}},
        Case{"ThesisSmooth", smooth, {0.1f, 0.1f, 0, 0, 3, 1, 2, 0.3f, 0.2f, 0.1f, 50, 1, 0.5f, 4, 0.1f, 1}},
        Case{"ThesisLeaf", leaf, {0.1f, 0.1f, 0, 0, 0, 0, 0, 0.3f, 0.2f, 0, 0, 0.7f, 0.4f, 0.6f, 4, 1}}),
    [](const testing::TestParamInfo<Case>& info) { return info.param.name; });

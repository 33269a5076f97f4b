// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/StandFlow.h>

#include <tests/TestData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

using namespace osgTreeWind;

namespace {

float at(const std::vector<float>& levels, float z) {
    const float position = z * static_cast<float>(levels.size() - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(position), levels.size() - 2);
    return levels[low] + (position - static_cast<float>(low)) * (levels[low + 1] - levels[low]);
}

/// A stand of Katul et al. 2004: "key = numbers" lines.
std::map<std::string, std::vector<float>> readStand(const std::string& path) {
    std::map<std::string, std::vector<float>> numbers;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream text(line);
        std::string key, word;
        if (line.empty() || line[0] == '%' || !(text >> key >> word))
            continue;
        while (text >> word)
            if (word != "z0h")
                numbers[key].push_back(std::stof(word));
    }
    return numbers;
}

struct Errors {
    float mean, stress;
};

/// Rms errors of mean wind and stress at the measured heights. The leaf area densities of the files are
/// m^2/m^3: their sums give indices of 4.9 (hardwood) and 2.4 (Scots pine).
Errors errorsOf(const std::string& leavesFile, const std::string& windFile) {
    auto leaves = readStand(leavesFile), wind = readStand(windFile);
    constexpr std::size_t layers = 64;
    std::vector<float> drag(layers, 0.0f);
    float below = 0.0f;
    for (std::size_t row = 0; row < leaves["fodist"].size(); ++row) {
        const float top = leaves["zh"][row];
        for (std::size_t i = 0; i < layers; ++i) {
            const float foot = static_cast<float>(i) / layers, head = static_cast<float>(i + 1) / layers;
            drag[i] += leaves["cdh"][0] * leaves["fodist"][row] * leaves["h"][0] *
                       std::max(std::min(top, head) - std::max(below, foot), 0.0f);
        }
        below = top;
    }
    const StandFlow flow = solveStandFlow(drag);
    Errors sum{0.0f, 0.0f};
    const std::size_t count = wind["zzm"].size();
    for (std::size_t i = 0; i < count; ++i) {
        const float mean = at(flow.mean, wind["zzm"][i]) - wind["umm"][i] / wind["ummd"][0],
                    stress = at(flow.stress, wind["zzm"][i]) - wind["uwm"][i] / wind["uwmd"][0];
        sum.mean += mean * mean / static_cast<float>(count);
        sum.stress += stress * stress / static_cast<float>(count);
    }
    return {std::sqrt(sum.mean), std::sqrt(sum.stress)};
}

/// Expects rms errors of mean wind and stress of at most these in a measured stand.
void expectErrors(const std::string& stand, float mean, float stress) {
    REQUIRE_REAL_DATA(leaves, "canopy/" + stand + "_canopy_distribution.txt");
    REQUIRE_REAL_DATA(wind, "canopy/" + stand + "_Wind.txt");
    const Errors errors = errorsOf(leaves, wind);
    EXPECT_LE(errors.mean, mean);
    EXPECT_LE(errors.stress, stress);
}

TEST(StandFlow, IsThatMeasuredInScotsPines) {
    expectErrors("Scots_Pine", 0.08f, 0.12f);
}

/// The measured stress falls by 0.74 u*^2 within 0.05 h. The drag of the measured wind on the measured
/// leaves, for any factor, has errors of 0.18.
TEST(StandFlow, IsNearlyThatMeasuredInAHardwoodForest) {
    expectErrors("Hardwood", 0.11f, 0.16f);
}

/// u*^2 over the squared wind at the top is the drag of the leaves and of the ground.
TEST(StandFlow, LeavesAndGroundTakeTheMomentum) {
    for (const float all : {0.05f, 0.3f, 1.0f}) {
        constexpr std::size_t layers = 64;
        const StandFlow flow = solveStandFlow(std::vector<float>(layers, all / layers));
        float taken = 0.0f;
        for (std::size_t i = 0; i < layers; ++i) {
            const float wind = 0.5f * (flow.mean[i] + flow.mean[i + 1]);
            taken += all / layers * wind * wind;
        }
        const float absorbed = flow.friction * flow.friction * (1.0f - flow.stress.front());
        EXPECT_NEAR(taken / absorbed, 1.0f, 0.03f) << all;
    }
}

/// Without leaves the wind is logarithmic and the stress the same at all heights (Raupach 1994: u*^2 =
/// 0.003).
TEST(StandFlow, IsLogarithmicWithoutLeaves) {
    const StandFlow flow = solveStandFlow(std::vector<float>(64, 0.0f));
    EXPECT_NEAR(flow.friction, std::sqrt(0.003f), 0.004f);
    EXPECT_NEAR(flow.displacement, 0.0f, 1e-6f);
    for (const float z : {0.25f, 0.5f, 0.75f}) {
        EXPECT_NEAR(at(flow.mean, z), 1.0f + flow.friction / 0.4f * std::log(z), 0.02f) << z;
        EXPECT_NEAR(at(flow.stress, z), 1.0f, 1e-4f) << z;
    }
}

/// Deep in a uniform stand the mixing length is constant: the wind falls exponentially, and the drag of each
/// level is the divergence of the stress.
TEST(StandFlow, FallsExponentiallyInADenseUniformStand) {
    const StandFlow flow = solveStandFlow(std::vector<float>(64, 4.0f / 64.0f));
    const float upper = std::log(at(flow.mean, 0.7f) / at(flow.mean, 0.55f)),
                lower = std::log(at(flow.mean, 0.55f) / at(flow.mean, 0.4f));
    EXPECT_NEAR(upper / lower, 1.0f, 0.15f);
    EXPECT_LT(at(flow.stress, 0.5f), 0.02f);
    EXPECT_NEAR(flow.turbulence.back(), 1.0f, 1e-6f);
}

/// Crowns above bare stems, as in the hardwood forest: a second maximum of the wind (Shaw 1977).
TEST(StandFlow, HasASecondMaximumBelowCrowns) {
    std::vector<float> drag(16, 0.0f);
    std::fill(drag.begin() + 8, drag.end(), 0.1f);
    const StandFlow flow = solveStandFlow(drag, 4);
    EXPECT_GT(at(flow.mean, 0.35f), at(flow.mean, 0.6f));
}

TEST(StandFlow, IsFiniteForAnyLeaves) {
    for (const float all : {0.0f, 0.002f, 0.05f, 1.0f, 5.0f, 1e30f, NAN, INFINITY, -1.0f})
        for (const std::size_t first : {0u, 4u, 7u})
            for (const std::size_t end : {std::size_t(8), first + 1}) {
                std::vector<float> drag(8, 0.0f);
                std::fill(drag.begin() + static_cast<std::ptrdiff_t>(first),
                          drag.begin() + static_cast<std::ptrdiff_t>(end),
                          all / static_cast<float>(end - first));
                const StandFlow flow = solveStandFlow(drag, 2);
                ASSERT_EQ(flow.mean.size(), 17u);
                EXPECT_GT(flow.friction, 0.0f);
                EXPECT_LT(flow.friction, 1.0f);
                for (const std::vector<float>* levels : {&flow.mean, &flow.stress, &flow.turbulence})
                    for (const float number : *levels)
                        EXPECT_TRUE(number >= 0.0f && number < 2.0f) << all << ' ' << first << ' ' << end;
            }
}

} // namespace

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/DetailBudget.h>

#include <osg/ref_ptr>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace osgTreeWind;

namespace {

constexpr float budget = 20.0f; // milliseconds

/// Detail of each frame of a view whose frames take `seconds(detail)`, measured `late` frames later.
std::vector<float> simulateDetail(const std::function<double(float)>& seconds, unsigned late = 1,
                                  unsigned frames = 300, const char* gpu = nullptr) {
    const osg::ref_ptr<osg::Stats> stats = new osg::Stats("Camera");
    stats->collectStats("gpu", gpu != nullptr);
    DetailBudget view;
    std::vector<float> details;
    for (unsigned frame = 1; frame <= frames; ++frame) {
        if (frame > late) {
            const double took = seconds(details[frame - late - 1]);
            stats->setAttribute(frame - late, "Cull traversal time taken", gpu ? 1e-3 : 0.25 * took);
            stats->setAttribute(frame - late, "Draw traversal time taken", gpu ? 1e-3 : 0.75 * took);
            if (gpu)
                stats->setAttribute(frame - late, gpu, took);
        }
        details.push_back(view.updateDetail(*stats, frame, budget));
    }
    return details;
}

/// Seconds of a frame: a constant part, and a part proportional to the pixels of the trees.
double forestCost(float detail) {
    return 0.005 + 0.045 * static_cast<double>(detail * detail);
}

} // namespace

TEST(DetailBudgetTest, KeepsFullDetailWithinTheBudget) {
    for (const float detail : simulateDetail([](float) { return 0.019; }))
        EXPECT_EQ(detail, 1.0f);
}

TEST(DetailBudgetTest, DropsToTheMinimumIfDetailDoesNotMatter) {
    const std::vector<float> details = simulateDetail([](float) { return 10.0; });
    EXPECT_EQ(details.front(), 1.0f);
    EXPECT_EQ(details[60], DetailBudget::minDetail);
    EXPECT_EQ(details.back(), DetailBudget::minDetail);
    for (std::size_t i = 1; i < details.size(); ++i)
        EXPECT_GE(details[i], 0.85f * details[i - 1] - 1e-6f) << "a jump at " << i;
}

TEST(DetailBudgetTest, SettlesWithinTheBudget) {
    for (const unsigned late : {1u, 2u, 5u}) {
        const std::vector<float> details = simulateDetail(forestCost, late);
        EXPECT_LE(forestCost(details.back()), 0.020) << late;
        EXPECT_GT(forestCost(details.back()), 0.75 * 0.020) << late;
        for (std::size_t i = 150; i < details.size(); ++i)
            EXPECT_EQ(details[i], details.back()) << late << " frames late, frame " << i;
        EXPECT_EQ(*std::min_element(details.begin(), details.end()), details.back()) << "detail overshot";
    }
}

TEST(DetailBudgetTest, DoesNotOscillateAroundACostJump) {
    const auto jump = [](float detail) { return detail > 0.6f ? 0.022 : 0.0175; };
    const std::vector<float> details = simulateDetail(jump);
    EXPECT_LE(details.back(), 0.6f);
    for (std::size_t i = 150; i < details.size(); ++i)
        EXPECT_EQ(details[i], details.back()) << i;
}

TEST(DetailBudgetTest, DetailRecoversWhenFramesGetCheap) {
    int call = 0;
    const std::vector<float> details =
        simulateDetail([&](float detail) { return ++call < 100 ? forestCost(detail) : 0.003; });
    EXPECT_LT(details[90], 0.7f);
    EXPECT_EQ(details.back(), 1.0f);
}

TEST(DetailBudgetTest, OneLongFrameHasLittleEffect) {
    int call = 0;
    const std::vector<float> details = simulateDetail([&](float) { return ++call == 50 ? 3.0 : 0.01; });
    EXPECT_GE(*std::min_element(details.begin(), details.end()), 0.85f);
    EXPECT_EQ(details.back(), 1.0f);
}

TEST(DetailBudgetTest, UsesTheGpuTimeIfItIsLonger) {
    const std::vector<float> details = simulateDetail(forestCost, 3, 300, "GPU draw time taken");
    EXPECT_LE(forestCost(details.back()), 0.020);
    EXPECT_GT(forestCost(details.back()), 0.75 * 0.020);
}

TEST(DetailBudgetTest, KeepsDetailWithoutMeasurements) {
    const osg::ref_ptr<osg::Stats> stats = new osg::Stats("Camera");
    DetailBudget view;
    for (unsigned frame = 0; frame < 100; ++frame)
        EXPECT_EQ(view.updateDetail(*stats, frame, budget), 1.0f);
}

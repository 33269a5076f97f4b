// SPDX-License-Identifier: MIT
// Several processes show one forest at different frame rates, some of them started later.
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>

using namespace osgTreeWind;

namespace {

constexpr double now = 140.0; // seconds

ForestDescription wood() {
    std::istringstream text("version = 1\n[wind]\nkind = \"gusts\"\nspeed = 10.0\ndirection_from = 250.0\n"
                            "[[scatter]]\ncount = 40\narea = [0.0, 0.0, 120.0, 120.0]\n"
                            "species = [\"oak\", \"birch\", \"Norway spruce\"]\nheight = [8.0, 28.0]\n");
    return readForest(text).value();
}

/// Leans of all trees at the time `now`.
std::vector<glm::vec2> leans(ModalLevel level, int framesASecond, double started = 0.0) {
    SimulationOptions options;
    options.distant = level == ModalLevel::Far;
    ForestSimulation simulation(wood(), options);
    for (int i = 0; i <= static_cast<int>((now - started) * framesASecond); ++i)
        simulation.advance(started + i / static_cast<double>(framesASecond));
    std::vector<glm::vec2> all;
    for (std::size_t slot = 0; slot < movingForest(simulation).trees().size(); ++slot)
        all.push_back(movingForest(simulation).modal()->lean(slot));
    return all;
}

/// Rms difference over the rms of `b`.
double relativeDifference(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
    double difference = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference += static_cast<double>(glm::dot(a[i] - b[i], a[i] - b[i]));
        whole += static_cast<double>(glm::dot(b[i], b[i]));
    }
    EXPECT_GT(whole, 0.0);
    return std::sqrt(difference / whole);
}

class Channels : public ::testing::TestWithParam<ModalLevel> {};

} // namespace

TEST_P(Channels, ShowTheSameAtAnyFrameRate) {
    const std::vector<glm::vec2> usual = leans(GetParam(), 60);
    for (const int framesASecond : {20, 144}) {
        const double difference = relativeDifference(leans(GetParam(), framesASecond), usual);
        EXPECT_LT(difference, GetParam() == ModalLevel::Near ? 1e-3 : 1e-5) << framesASecond;
    }
}

TEST_P(Channels, OneStartedLaterShowsTheSameAfterFortySeconds) {
    const std::vector<glm::vec2> usual = leans(GetParam(), 60);
    EXPECT_LT(relativeDifference(leans(GetParam(), 60, 100.0), usual), 0.01);
    EXPECT_GT(relativeDifference(leans(GetParam(), 60, 137.0), usual), 0.01) << "the test needs a difference";
}

INSTANTIATE_TEST_SUITE_P(, Channels, ::testing::Values(ModalLevel::Near, ModalLevel::Far),
                         [](const auto& info) {
                             return std::string(info.param == ModalLevel::Near ? "near" : "far");
                         });

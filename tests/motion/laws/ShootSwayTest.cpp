// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace osgTreeWind;

namespace {

glm::vec3 swayAt(double time, float reach, float speed, const glm::vec3& place = {1.0f, 2.0f, 9.0f}) {
    return Laws().shootSway(place, reach, speed, flutterPhases(time, LeafMotion()), 0.3f);
}

/// Rms speed, m/s.
double rootMeanSquare(float reach, float speed) {
    constexpr double step = 0.01;
    double sum = 0.0;
    for (int i = 0; i < 6000; ++i) {
        const double moved = static_cast<double>(
            glm::distance(swayAt(step * i, reach, speed), swayAt(step * (i + 1), reach, speed)));
        sum += moved * moved / (step * step);
    }
    return std::sqrt(sum / 6000);
}

} // namespace

TEST(ShootSway, IsZeroForThickWoodAndInCalm) {
    EXPECT_EQ(swayAt(3.0, 0.0f, 12.0f), glm::vec3(0.0f));
    EXPECT_EQ(swayAt(3.0, 1.5f, 0.0f), glm::vec3(0.0f));
}

TEST(ShootSway, GrowsWithReachAndWindAndStaysBounded) {
    EXPECT_GT(rootMeanSquare(1.0f, 8.0f), 2.0 * rootMeanSquare(0.5f, 8.0f));
    EXPECT_GT(rootMeanSquare(1.0f, 8.0f), 8.0 * rootMeanSquare(1.0f, 2.0f));
    for (const float speed : {90.0f, 1e30f, std::numeric_limits<float>::infinity()})
        EXPECT_LT(glm::length(swayAt(3.0, 1e6f, speed)), 3.0f);
}

TEST(ShootSway, IsContinuousAfterMonths) {
    for (const double time : {0.0, 12.34, 1e7})
        for (int i = 0; i < 2000; ++i)
            EXPECT_LT(glm::distance(swayAt(time + 0.001 * i, 1.0f, 8.0f),
                                    swayAt(time + 0.001 * (i + 1), 1.0f, 8.0f)),
                      0.004f);
}

TEST(ShootSway, NeighboursMoveAgainstEachOther) {
    double together = 0.0, all = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 a = swayAt(0.02 * i, 1.0f, 8.0f),
                        b = swayAt(0.02 * i, 1.0f, 8.0f, {1.5f, 2.2f, 9.1f});
        together += static_cast<double>(glm::dot(a, b));
        all += 0.5 * static_cast<double>(glm::dot(a, a) + glm::dot(b, b));
    }
    EXPECT_LT(together / all, 0.5);
}

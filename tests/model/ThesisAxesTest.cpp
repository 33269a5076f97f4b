// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/ThesisAxes.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

namespace osgTreeWind {
namespace {

// Design section 4: thesis Y-up (x, y, z) is OSG (x, -z, y).
TEST(ThesisAxes, MapsUpToUpAndKeepsHandedness) {
    EXPECT_EQ(fromThesis({1, 2, 3}), glm::vec3(1, -3, 2));
    EXPECT_EQ(fromThesis({0, 1, 0}), glm::vec3(0, 0, 1));
    EXPECT_EQ(glm::cross(fromThesis({1, 0, 0}), fromThesis({0, 1, 0})), fromThesis({0, 0, 1}));
}

TEST(ThesisAxes, RoundTripIsTheIdentity) {
    EXPECT_EQ(toThesis(fromThesis({1, 2, 3})), glm::vec3(1, 2, 3));
}

} // namespace
} // namespace osgTreeWind

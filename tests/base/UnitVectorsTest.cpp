// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/UnitVectors.h>

#include <gtest/gtest.h>

namespace osgTreeWind {
namespace {

TEST(UnitVectors, DirectionOfAZeroVectorIsTheFallback) {
    EXPECT_EQ(directionOr({0, 0, 0}, {0, 1, 0}), glm::vec3(0, 1, 0));
    EXPECT_EQ(directionOr({0, 0, -3}, {0, 1, 0}), glm::vec3(0, 0, -1));
}

TEST(UnitVectors, PerpendicularIsAUnitVectorNormalToTheAxis) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        glm::vec3 axis{random.symmetric(), random.symmetric(), random.symmetric()};
        if (i < 3)
            axis = glm::vec3(i == 0, i == 1, i == 2);
        axis = glm::normalize(axis);
        const glm::vec3 across = perpendicular(axis);
        EXPECT_NEAR(glm::dot(across, axis), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(across), 1.0f, 1e-6f);
    }
}

} // namespace
} // namespace osgTreeWind

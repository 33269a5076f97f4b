// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/motion/laws/Rotations.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace osgTreeWind;

namespace {

using Limits = std::numeric_limits<float>;

/// Typical of the broadleaves in the catalogue.
Reconfiguration broadleaf() {
    Reconfiguration foliage;
    foliage.streamlining = 0.877f;
    foliage.breezeStreamlining = 0.35f;
    foliage.streamlinedTo = 20.0f;
    foliage.maxPull = 1.2f;
    return foliage;
}

/// Directions distributed evenly over the sphere.
std::vector<glm::vec3> petioles(int count) {
    std::vector<glm::vec3> petioles;
    for (int i = 0; i < count; ++i) {
        const float z = (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(count) - 1.0f;
        const float turn = 2.3999632f * static_cast<float>(i), level = std::sqrt(1.0f - z * z);
        petioles.emplace_back(level * std::cos(turn), level * std::sin(turn), z);
    }
    return petioles;
}

glm::vec3 drawn(const glm::vec3& petiole, const glm::vec3& pull) {
    return Laws().turnVector(Laws().downwindTurn(petiole, pull), petiole);
}

/// Drag of petioles and their cones in a wind toward +x, over that in calm: projected length times the open
/// width, times the sine of the half-angle.
float dragLeft(const glm::vec4& pull) {
    float calm = 0.0f, now = 0.0f;
    for (const glm::vec3& petiole : petioles(4000)) {
        const glm::vec3 turned = drawn(petiole, glm::vec3(pull));
        calm += std::hypot(petiole.y, petiole.z);
        now += std::hypot(turned.y, turned.z);
    }
    return now / calm * pull.w * pull.w;
}

} // namespace

TEST(Reconfiguration, CalmMovesNothing) {
    const glm::vec4 pull = broadleaf().pull(glm::vec3(0.0f));
    EXPECT_EQ(pull, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    const glm::vec3 corner(0.123f, -0.456f, 0.789f);
    EXPECT_EQ(closedCorner(corner, pull), corner);
    for (const glm::vec3& petiole : petioles(200))
        EXPECT_EQ(Laws().turnVector(Laws().downwindTurn(petiole, glm::vec3(pull)), corner), corner);
}

TEST(Reconfiguration, PetiolesTurnDownwindMoreInStrongerWind) {
    for (const glm::vec3& petiole : petioles(300)) {
        const glm::vec3 way = glm::normalize(glm::vec3(1.0f, 0.0f, 0.3f)); // downwind, and a little up
        float before = glm::dot(petiole, way);
        for (const float speed : {2.0f, 5.0f, 8.0f, 12.0f, 20.0f, 30.0f}) {
            const glm::vec3 turned = drawn(petiole, glm::vec3(broadleaf().pull({speed, 0.0f, 0.0f})));
            EXPECT_NEAR(glm::length(turned), 1.0f, 1e-5f);
            EXPECT_GE(glm::dot(turned, way), before - 1e-5f);
            before = glm::dot(turned, way);
        }
    }
}

TEST(Reconfiguration, PullIsHalfItsMaximumAtTenMetresPerSecond) {
    const float at10 = glm::length(glm::vec3(broadleaf().pull({0.0f, 10.0f, 0.0f})));
    EXPECT_NEAR(at10, 0.6f, 1e-5f);
    EXPECT_LT(glm::length(glm::vec3(broadleaf().pull({0.0f, 2.0f, 0.0f}))), 0.05f);
    EXPECT_NEAR(glm::length(glm::vec3(broadleaf().pull({0.0f, 200.0f, 0.0f}))), 1.2f, 0.01f);
}

TEST(Reconfiguration, ClosesAsTheDragOfTheLawFalls) {
    Laws laws;
    const Reconfiguration foliage = broadleaf();
    const auto left = [&](float speed) { return dragLeft(foliage.pull({speed, 0.0f, 0.0f})); };
    const auto law = [&](float speed) {
        return laws.streamlinedShare(foliage.streamlining, foliage.breezeStreamlining, foliage.streamlinedTo,
                                     speed);
    };
    EXPECT_EQ(left(0.0f), 1.0f);
    for (const float speed : {1.0f, 2.0f, 4.0f, 7.0f, 10.0f, 12.0f, 15.0f, 20.0f, 30.0f})
        EXPECT_NEAR(left(speed), law(speed) / law(0.0f), 0.03f) << speed;
}

TEST(Reconfiguration, DragFallsFromTheFirstBreezeOn) {
    // Oak leaves have u^-0.35 (Angelou et al. 2019): half of it is left at 1.6 * 2^(1 / 0.35) m/s.
    Laws laws;
    const auto drag = [&](float speed) { return laws.foliageDrag(0.8f, 0.35f, 25.0f, speed); };
    EXPECT_EQ(drag(0.0f), 1.0f);
    EXPECT_EQ(drag(1.5f), 1.0f);
    EXPECT_NEAR(drag(3.2f), std::pow(2.0f, -0.35f), 1e-5f);
    EXPECT_NEAR(drag(10.0f), std::pow(6.25f, -0.35f), 1e-5f);
    for (float speed = 1.7f; speed < 25.0f; speed += 0.1f) {
        EXPECT_LT(drag(speed), drag(speed - 0.1f)) << speed;
        EXPECT_GT(drag(speed), 0.97f * drag(speed - 0.1f)) << speed << ": no step";
    }
}

TEST(Reconfiguration, FoliageWithoutStreamliningTurnsAndDoesNotClose) {
    Reconfiguration foliage;
    foliage.maxPull = 0.7f;
    for (const float speed : {3.0f, 10.0f, 40.0f})
        EXPECT_EQ(foliage.pull({speed, 0.0f, 0.0f}).w, 1.0f);
    EXPECT_GT(foliage.pull({20.0f, 0.0f, 0.0f}).x, 0.4f);
}

TEST(Reconfiguration, TurnIsContinuousForEveryPetiole) { // under small changes of wind direction
    constexpr float strongest =
        1.7320508f * 1.45f; // max_downwind of 60 degrees times the maximum of pullOfGusts()
    for (const glm::vec3& petiole : petioles(500))
        for (const glm::vec3& wind : petioles(200)) {
            const glm::vec3 other = glm::normalize(wind + glm::vec3(0.001f, -0.002f, 0.001f));
            ASSERT_LT(glm::distance(drawn(petiole, strongest * wind), drawn(petiole, strongest * other)),
                      0.03f);
        }
}

TEST(Reconfiguration, GustsTravelDownwindSmoothly) {
    Laws laws;
    const glm::vec3 pull(1.0f, 0.0f, 0.0f);
    for (int i = 0; i < 1000; ++i) {
        const float t = 0.001f * static_cast<float>(i);
        const float here = laws.pullOfGusts({0.0f, 1.0f, 3.0f}, pull, {t, 0.3f, 0.4f}, 0.3f, 7.0f);
        const float downwind =
            laws.pullOfGusts({1.0f, 1.0f, 3.0f}, pull, {t + 0.2f, 0.3f, 0.75f}, 0.3f, 7.0f);
        ASSERT_NEAR(here, downwind, 1e-5f);
        ASSERT_GE(here, 0.549f);
        ASSERT_LE(here, 1.451f);
    }
}

TEST(Reconfiguration, StaysInBoundsForAnyInput) {
    const std::vector<float> hostile = {0.0f,
                                        -5.0f,
                                        0.4f,
                                        1e30f,
                                        -1e30f,
                                        Limits::max(),
                                        Limits::max(),
                                        Limits::infinity(),
                                        Limits::quiet_NaN()};
    for (const float a : hostile)
        for (const float b : hostile)
            for (const float c : hostile) {
                Species species;
                species.wood.streamlining = a;
                species.wood.streamlinedTo = b;
                species.leaf.maxDownwind = c;
                const glm::vec4 pull = Reconfiguration(species).pull({a, b, c});
                ASSERT_LE(glm::length(glm::vec3(pull)), 1.733f);
                ASSERT_GT(pull.w, 0.0f);
                ASSERT_LE(pull.w, 1.0f);
                ASSERT_NEAR(glm::length(drawn({0.6f, 0.0f, -0.8f}, glm::vec3(pull))), 1.0f, 1e-5f);
            }
}

TEST(Reconfiguration, AClusterFluttersBeforeItTurnsDownwind) {
    const glm::quat orientation = glm::normalize(glm::quat(0.3f, 0.5f, -0.2f, 0.6f));
    const glm::vec4 state(0.2f, -0.1f, 0.4f, 1.3f), calm(0.0f, 0.0f, 0.0f, 1.0f);
    const glm::vec3 corner(0.1f, 0.2f, 0.5f), petiole = orientation * glm::vec3(0.0f, 0.0f, 1.0f);
    const glm::quat flutter = orientation * leafRotation(state);
    EXPECT_LT(glm::distance(downwindLeafTurn(orientation, state, calm) * corner, flutter * corner), 1e-6f);
    const glm::vec3 pull(0.9f, 0.3f, 0.2f);
    const glm::vec3 expected = Laws().turnVector(Laws().downwindTurn(petiole, 1.3f * pull), flutter * corner);
    EXPECT_LT(glm::distance(downwindLeafTurn(orientation, state, glm::vec4(pull, 0.7f)) * corner, expected),
              1e-5f);
}

// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/wind/Extremes.h>

#include <osgTreeWind/wind/GridWind.h>

#include <numeric>

using namespace osgTreeWind;

namespace {

/// An array of 4 x 3 cells with value i at index i.
WindFieldPtr countingWind(const glm::dvec3& origin = glm::dvec3(0.0)) {
    std::vector<float> values(4 * 3 * 3);
    std::iota(values.begin(), values.end(), 0.0f);
    auto wind = GridWind::fromForestWind(4, 3, std::move(values), origin);
    EXPECT_TRUE(wind) << firstProblem(wind);
    return wind.value();
}

} // namespace

// Thesis §4.2: windIndex = (x1 + z1 * width) * 3. Thesis (x, y, z) is OSG (x, -z, y).
TEST(ThesisWind, IndexesLikeTheThesis) {
    // Thesis position (2.7, 5, 1.2): index (2 + 1 * 4) * 3 = 18, thesis wind (18, 19, 20).
    EXPECT_EQ(countingWind()->velocity({2.7f, -1.2f, 5.0f}, 0), glm::vec3(18, -20, 19));
    EXPECT_EQ(countingWind()->velocity({0, 0, 0}, 0), glm::vec3(0, -2, 1));
    EXPECT_EQ(countingWind()->velocity({3, -2, 0}, 0), glm::vec3(33, -35, 34));
}

TEST(ThesisWind, DoesNotInterpolate) {
    EXPECT_EQ(countingWind()->velocity({1.999f, 0, 0}, 0).x, 3.0f);
    EXPECT_EQ(countingWind()->velocity({2.0f, 0, 0}, 0).x, 6.0f);
    EXPECT_EQ(countingWind()->velocity({0, -0.999f, 0}, 0).x, 0.0f);
    EXPECT_EQ(countingWind()->velocity({0, -1.0f, 0}, 0).x, 12.0f);
}

TEST(ThesisWind, ClampsToTheEdgeOutside) {
    EXPECT_EQ(countingWind()->velocity({-50, 50, 0}, 0).x, 0.0f);
    EXPECT_EQ(countingWind()->velocity({4.0f, 0, 0}, 0).x, 9.0f);
    EXPECT_EQ(countingWind()->velocity({1e30f, -1e30f, 0}, 0).x, 33.0f);
    EXPECT_EQ(countingWind()->velocity({-1e30f, -3.0f, 0}, 0).x, 24.0f);
    expectFiniteEverywhere(*countingWind());
}

TEST(ThesisWind, IgnoresHeightAndTime) {
    EXPECT_EQ(countingWind()->velocity({2.7f, -1.2f, -5}, 0),
              countingWind()->velocity({2.7f, -1.2f, 80}, 1e6));
}

TEST(ThesisWind, IsPlacedAtItsOrigin) {
    EXPECT_EQ(countingWind({10, 20, 0})->velocity({12.7f, 18.8f, 0}, 0), glm::vec3(18, -20, 19));
}

TEST(ThesisWind, RefusesBadArrays) {
    EXPECT_EQ(firstProblem(GridWind::fromForestWind(4, 3, std::vector<float>(12))),
              "values: expected 36 numbers (width 4 x length 3 x 3), found 12");
    EXPECT_EQ(firstProblem(GridWind::fromForestWind(0, 3, {})), "width: expected at least 1 cell, found 0");
    EXPECT_EQ(firstProblem(GridWind::fromForestWind(1, -2, {})),
              "length: expected at least 1 cell, found -2");
    EXPECT_EQ(firstProblem(GridWind::fromForestWind(1, 1, {0, std::numeric_limits<float>::infinity(), 0})),
              "values: expected finite m/s, found inf at index 1");
    EXPECT_EQ(firstProblem(GridWind::fromForestWind(1, 1, {0, 0, 0}, glm::dvec3(std::nan("")))),
              "origin: expected finite metres");
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/CrownEllipsoid.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

CrownEllipsoid crown() { // 4 wide, 6 high, its middle at (1, 0, 5)
    std::vector<LeafCluster> leaves(2);
    leaves[0].anchor = {-1.0f, -2.0f, 2.0f};
    leaves[1].anchor = {3.0f, 2.0f, 8.0f};
    return CrownEllipsoid(leaves);
}

} // namespace

TEST(CrownEllipsoid, IsDeepestInTheMiddle) {
    EXPECT_FLOAT_EQ(crown().at({1.0f, 0.0f, 5.0f}).w, 0.0f);
    EXPECT_FLOAT_EQ(crown().at({1.0f, 0.0f, 6.5f}).w, 0.5f);
    EXPECT_FLOAT_EQ(crown().at({1.0f, 2.0f, 5.0f}).w, 1.0f);
    EXPECT_FLOAT_EQ(crown().at({9.0f, 9.0f, 9.0f}).w, 1.0f);
}

TEST(CrownEllipsoid, OutwardIsAwayFromTheMiddle) {
    EXPECT_LT(glm::distance(glm::vec3(crown().at({3.0f, 0.0f, 5.0f})), glm::vec3(1, 0, 0)), 1e-2f);
    EXPECT_LT(glm::distance(glm::vec3(crown().at({1.0f, 0.0f, 2.0f})), glm::vec3(0, 0, -1)), 1e-2f);
    EXPECT_GT(crown().at({2.4f, 0.0f, 7.1f}).z, 0.4f);
}

TEST(CrownEllipsoid, WithoutLeavesItIsAPoint) {
    EXPECT_EQ(CrownEllipsoid({}).at({0.0f, 0.0f, 1.0f}), glm::vec4(0, 0, 1, 1));
}

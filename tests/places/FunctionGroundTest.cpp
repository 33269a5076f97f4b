// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/FunctionGround.h>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

TEST(FunctionGround, HasNoHeightOutsideItsAreaOrForNaN) {
    const FunctionGround ground([](double x, double y) { return x > 5 ? std::nan("") : x + y; },
                                {{0, 0}, {9, 9}, 1});
    EXPECT_EQ(ground.height({2, 3}), 5.0);
    EXPECT_EQ(ground.height({0, 9}), 9.0);
    EXPECT_FALSE(ground.height({6, 3}));
    EXPECT_FALSE(ground.height({-1, 3}));
    EXPECT_FALSE(ground.height({std::nan(""), 3}));
    EXPECT_FALSE(FunctionGround(nullptr).height({0, 0}));
}

TEST(Ground, FootIsAtTheLowestPointOfTheTrunksCircle) {
    const FunctionGround slope([](double x, double) { return 0.5 * x; });
    EXPECT_NEAR(footHeight(slope, {10, 0}, 0.4).value(), 5.0 - 0.2, 1e-9);
    const FunctionGround edge([](double x, double) { return x < 0 ? std::nan("") : 1.0; });
    EXPECT_EQ(footHeight(edge, {0.1, 0}, 0.4), 1.0) << "its rim may extend beyond the edge";
    EXPECT_FALSE(footHeight(edge, {-0.1, 0}, 0.4));
}

} // namespace osgTreeWind

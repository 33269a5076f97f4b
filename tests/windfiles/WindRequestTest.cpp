// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>

#include <osgTreeWind/windfiles/WindRequest.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(WindRequest, FindsAnAreaInDegrees) {
    // from cs2cs: the corners of 20 km around 500000, 5100000 in UTM 11
    const auto there = areaOnMap("EPSG:4326", {"EPSG:32611", {490000, 5090000}, {510000, 5110000}});
    ASSERT_TRUE(there);
    EXPECT_NEAR(there.value().low.x, -117.12948, 1e-4);
    EXPECT_NEAR(there.value().high.x, -116.87052, 1e-4);
    EXPECT_NEAR(there.value().low.y, 45.96350, 1e-4);
    EXPECT_NEAR(there.value().high.y, 46.14358, 1e-4);
}

TEST(WindRequest, AreaAcrossTheDateLineIsContiguous) {
    const auto there = areaOnMap("EPSG:4326", {"EPSG:32601", {150000, 0}, {350000, 100000}});
    ASSERT_TRUE(there);
    EXPECT_LT(there.value().high.x - there.value().low.x, 2.0);
}

TEST(WindRequest, FileWithoutACrsHasThatOfTheArea) {
    const auto there = areaOnMap("", {"EPSG:32611", {1, 2}, {3, 4}});
    ASSERT_TRUE(there);
    EXPECT_EQ(there.value().high, glm::dvec2(3, 4));
}

TEST(WindRequest, RefusesAnAreaOutsideTheCrs) {
    const std::string problem =
        firstProblem(areaOnMap("+proj=ortho +lat_0=50 +lon_0=10", {"EPSG:4326", {-170, -50}, {-169, -49}}));
    EXPECT_NE(problem.find("does not cover the area where wind is needed"), std::string::npos) << problem;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/LogProfile.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace osgTreeWind;

TEST(LogProfile, IsOneAtTheHeightOfMeasurement) {
    EXPECT_DOUBLE_EQ((LogProfile{42.0, 0.1}.factor(42.0)), 1.0);
}

TEST(LogProfile, GrowsWithTheLogarithmOfHeight) {
    const LogProfile profile{10.0, 0.1}; // ln(100); 1 m is half of it, 100 m one and a half
    EXPECT_NEAR(profile.factor(1.0), 0.5, 1e-12);
    EXPECT_NEAR(profile.factor(100.0), 1.5, 1e-12);
    EXPECT_NEAR((LogProfile{42.0, 0.1}.factor(10.0)), 0.76241, 1e-5);
}

TEST(LogProfile, IsCalmAtTheGround) {
    const LogProfile profile{10.0, 0.1};
    EXPECT_EQ(profile.factor(0.1), 0.0);
    EXPECT_EQ(profile.factor(0.05), 0.0);
    EXPECT_EQ(profile.factor(-3.0), 0.0);
    EXPECT_EQ(profile.factor(std::nan("")), 0.0);
}

TEST(LogProfile, IsFiniteAtAnyHeight) {
    const double inf = std::numeric_limits<double>::infinity();
    for (const LogProfile& profile :
         {LogProfile{10.0, 0.1}, LogProfile{1e300, 1e-300}, LogProfile{2.0, std::nextafter(2.0, 0.0)}}) {
        ASSERT_TRUE(profile.valid());
        for (double z : {1e-300, 1.0, 2.0, 1e30, 1e308, inf})
            EXPECT_TRUE(std::isfinite(profile.factor(z))) << z;
    }
}

TEST(LogProfile, RequiresAHeightAboveTheRoughness) {
    EXPECT_TRUE((LogProfile{10.0, 0.1}.valid()));
    for (const LogProfile& bad :
         {LogProfile{10.0, 0.0}, LogProfile{10.0, -1.0}, LogProfile{0.1, 0.1}, LogProfile{0.05, 0.1},
          LogProfile{std::nan(""), 0.1}, LogProfile{10.0, std::nan("")},
          LogProfile{std::numeric_limits<double>::infinity(), 0.1}})
        EXPECT_FALSE(bad.valid()) << bad.height << ' ' << bad.roughness;
}

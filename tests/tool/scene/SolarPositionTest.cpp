// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/SolarPosition.h>
#include <osgTreeWind/base/DateText.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

TEST(SolarPosition, MatchesTheExampleOfReda2004) {
    // I. Reda and A. Andreas, Solar Energy 76 (2004), appendix A.5: zenith 50.11162, azimuth 194.34024.
    const SolarPosition sun(*parseDate("2003-10-17T12:30:30-07:00"), {-105.1786, 39.742476});
    EXPECT_NEAR(sun.elevation, 90.0 - 50.11162, 0.02);
    EXPECT_NEAR(sun.azimuth, 194.34024, 0.02);
}

TEST(SolarPosition, AtThePoleTheElevationIsTheDeclination) {
    // J. Meeus, Astronomical Algorithms, example 25.a: -7.78507 on 1992-10-13.
    EXPECT_NEAR(SolarPosition(*parseDate("1992-10-13T00:00Z"), {0.0, 90.0}).elevation, -7.78507, 0.012);
    // Solstices of 2000: 21 June 01:48, 21 December 13:37.
    EXPECT_NEAR(SolarPosition(*parseDate("2000-06-21T01:48Z"), {0.0, 90.0}).elevation, 23.438, 0.05);
    EXPECT_NEAR(SolarPosition(*parseDate("2000-12-21T13:37Z"), {0.0, -90.0}).elevation, 23.438, 0.05);
}

TEST(SolarPosition, GoesThroughTheNorthInTheSouthernHemisphere) {
    const auto at = [](const char* time, double latitude) {
        return SolarPosition(*parseDate(time), {0.0, latitude});
    };
    EXPECT_NEAR(at("2026-03-20T06:10Z", 52.0).azimuth, 90.0, 3.0);
    EXPECT_NEAR(at("2026-03-20T18:10Z", 52.0).azimuth, 270.0, 3.0);
    EXPECT_NEAR(at("2026-03-20T12:07Z", 52.0).azimuth, 180.0, 1.0);
    EXPECT_NEAR(at("2026-03-20T12:07Z", 52.0).elevation, 38.0, 0.3);
    const double north = at("2026-03-20T12:07Z", -52.0).azimuth;
    EXPECT_NEAR(std::min(north, 360.0 - north), 0.0, 1.0);
    EXPECT_LT(at("2026-03-20T00:00Z", 52.0).elevation, -30.0);
}

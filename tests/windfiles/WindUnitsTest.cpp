// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>

#include <osgTreeWind/windfiles/WindUnits.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

TEST(WindUnits, ConvertsSpeeds) {
    EXPECT_EQ(speedUnit("m/s").value(), 1.0);
    EXPECT_NEAR(speedUnit("km/h").value() * 36.0, 10.0, 1e-12);
    EXPECT_NEAR(speedUnit("kn").value() * 3600.0, 1852.0, 1e-9);
    EXPECT_NEAR(speedUnit("mph").value() * 3600.0, 1609.344, 1e-9);
    EXPECT_EQ(speedUnit("ft/s").value(), 0.3048);
}

TEST(WindUnits, ConvertsTimes) {
    EXPECT_EQ(timeUnit("s").value(), 1.0);
    EXPECT_EQ(timeUnit("min").value(), 60.0);
    EXPECT_EQ(timeUnit("h").value(), 3600.0);
    EXPECT_EQ(timeUnit("days").value(), 86400.0);
    EXPECT_EQ(timeUnit("ms").value(), 0.001);
}

TEST(WindUnits, RefusesUnknownUnitsAndListsTheKnownOnes) {
    EXPECT_EQ(firstProblem(speedUnit("knots")),
              "expected a unit of speed (m/s, km/h, kn, mph, ft/s), found 'knots'");
    EXPECT_EQ(firstProblem(timeUnit("")), "expected a unit of time (s, min, h, days, ms), found nothing");
}

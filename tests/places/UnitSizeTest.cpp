// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>

#include <osgTreeWind/places/UnitSize.h>

#include <gtest/gtest.h>

#include <string>

using namespace osgTreeWind;

TEST(UnitSize, AsksUdunitsForUnitsThatNoKeyHas) {
    for (const char* spelling : {"m.s-1", "meter second-1", "m·s-1", "metre second^-1", "M/S"})
        EXPECT_DOUBLE_EQ(sizeOfUnit(Dimension::Speed, spelling).value(), 1.0) << spelling;
    EXPECT_DOUBLE_EQ(sizeOfUnit(Dimension::Speed, "cm/s").value(), 0.01);
    EXPECT_NEAR(sizeOfUnit(Dimension::Speed, "mi/h").value(), 0.44704, 1e-12);
    EXPECT_DOUBLE_EQ(sizeOfUnit(Dimension::Speed, "0.1 m/s").value(), 0.1);
    EXPECT_DOUBLE_EQ(sizeOfUnit(Dimension::Length, "yd").value(), 0.9144);
    EXPECT_DOUBLE_EQ(sizeOfUnit(Dimension::Length, "dm").value(), 0.1);
}

TEST(UnitSize, PrefersTheNamesOfKeys) {
    EXPECT_EQ(sizeOfUnit(Dimension::Speed, "ms-1").value(), 1.0) << "per millisecond for UDUNITS";
    EXPECT_EQ(sizeOfUnit(Dimension::Speed, "mph").value(), 0.44704) << "metres per hour for UDUNITS";
}

TEST(UnitSize, RefusesOtherDimensionsReciprocalsAndNonsense) {
    for (const char* unit : {"s", "s/m", "kg", "m", "degC", "m2/s", "", "hello", "-1 m/s", "0 m/s", "m/s @ 3",
                             "lg(re 1 m/s)", "days since 1970-01-01"}) {
        EXPECT_FALSE(sizeOfUnit(Dimension::Speed, unit)) << unit;
    }
    EXPECT_FALSE(sizeOfUnit(Dimension::Speed, std::string(10000, '(')));
    EXPECT_FALSE(sizeOfUnit(Dimension::Direction, "percent"));
    EXPECT_EQ(firstProblem(sizeOfUnit(Dimension::Speed, "furlongs")),
              "expected a unit of speed (m/s, km/h, kn, mph, ft/s), found 'furlongs'");
}

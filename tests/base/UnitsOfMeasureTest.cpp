// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/UnitsOfMeasure.h>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace osgTreeWind;

namespace {

using Names = std::vector<std::pair<double, std::vector<const char*>>>;

void expectUnits(Dimension dimension, const Names& units) {
    for (const auto& [size, names] : units)
        for (const char* name : names) {
            EXPECT_NEAR(knownUnit(dimension, name).value_or(0.0) / size, 1.0, 1e-15) << name;
            EXPECT_EQ(canonicalUnit(dimension, name), names.front());
        }
}

} // namespace

TEST(UnitsOfMeasure, KnowsTheSpellingsOfLengths) {
    expectUnits(Dimension::Length,
                {{1.0, {"m", "M", "metre", "metres", "meter", "meters", "Meters", "gpm"}},
                 {0.01, {"cm", "centimetre", "centimetres", "centimeter", "centimeters", "CM"}},
                 {0.001, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
                 {0.3048,
                  {"ft", "foot", "feet", "international foot", "international_foot", "international_feet",
                   "ift", "Ft"}},
                 {1200.0 / 3937.0,
                  {"us-ft", "us survey foot", "us survey feet", "us_survey_foot", "us_survey_feet", "foot_us",
                   "ftUS"}},
                 {0.0254, {"in", "inch", "inches", "Inches"}}});
}

TEST(UnitsOfMeasure, KnowsTheSpellingsOfSpeeds) {
    expectUnits(
        Dimension::Speed,
        {{1.0,
          {"m/s", "m s-1", "m s^-1", "m s**-1", "m s⁻¹", "m·s⁻¹", "ms-1", "meters/second", "metres/second",
           "meters/sec", "mps", "meters per second", "meter/sec", "metre per second", "m/sec", "M/S"}},
         {1000.0 / 3600.0, {"km/h", "km h-1", "kph", "kmh", "kmph", "km/hr", "Km/h"}},
         {1852.0 / 3600.0, {"kn", "knots", "knot", "kt", "kts", "KT", "Knoten"}},
         {1609.344 / 3600.0, {"mph", "miles/hour", "MPH"}},
         {0.3048, {"ft/s", "ft s-1"}}});
}

TEST(UnitsOfMeasure, KnowsTheSpellingsOfTimes) {
    expectUnits(Dimension::Time, {{1.0, {"s", "sec", "secs", "second", "seconds"}},
                                  {60.0, {"min", "mins", "minute", "minutes"}},
                                  {3600.0, {"h", "hr", "hrs", "hour", "hours"}},
                                  {86400.0, {"days", "d", "day"}},
                                  {604800.0, {"weeks", "week"}},
                                  {0.001, {"ms"}}});
}

TEST(UnitsOfMeasure, KnowsTheSpellingsOfDirections) {
    expectUnits(
        Dimension::Direction,
        {{1.0, {"deg", "°", "degree", "degrees", "Degrees"}},
         {10.0, {"10 deg", "10s deg", "10's deg", "10 degrees", "deg/10", "10deg", "10°", "tens of degrees"}},
         {180.0 / 3.14159265358979323846, {"rad", "radian", "radians"}}});
}

TEST(UnitsOfMeasure, DoesNotMistakeOneQuantityForAnother) {
    EXPECT_FALSE(knownUnit(Dimension::Length, "m/s"));
    EXPECT_FALSE(knownUnit(Dimension::Speed, "ms")); // milliseconds
    EXPECT_FALSE(knownUnit(Dimension::Time, "m"));
    EXPECT_FALSE(knownUnit(Dimension::Length, ""));
    EXPECT_EQ(canonicalUnit(Dimension::Speed, "Furlong"), "Furlong");
    EXPECT_EQ(expectedUnit(Dimension::Speed), "a unit of speed (m/s, km/h, kn, mph, ft/s)");
}

TEST(UnitsOfMeasure, FindsUnitsInNamesOfColumns) {
    const auto length = [](const char* name) { return unitInName(Dimension::Length, name); };
    const auto speed = [](const char* name) { return unitInName(Dimension::Speed, name); };
    EXPECT_EQ(length("Height (ft)"), "ft");
    EXPECT_EQ(length("Height [ m ]"), "m");
    EXPECT_EQ(length("DBH_in"), "in");
    EXPECT_EQ(length("DBH_IN"), "IN");
    EXPECT_EQ(length("dbh, cm "), "cm");
    EXPECT_EQ(length("HeightFt"), "Ft");
    EXPECT_EQ(length("crown (W-E) ft"), "ft");
    EXPECT_EQ(length("z_us_survey_feet"), "us_survey_feet");
    EXPECT_EQ(length("Height (yd)"), "yd") << "may be known to UDUNITS";
    EXPECT_EQ(speed("wind_speed_10m (km/h)"), "km/h");
    EXPECT_EQ(speed("wind_mph"), "mph");
    EXPECT_EQ(speed("windspeedKmph"), "Kmph");
    EXPECT_EQ(speed("Wind m/s"), "m/s") << "and not s";
    EXPECT_EQ(speed("windspeedkmh"), "kmh");
    EXPECT_EQ(speed("wind_kmh_avg"), "kmh");
    EXPECT_EQ(speed("Wind Speed (km/h) Avg (10 min)"), "km/h");
    EXPECT_EQ(speed("Speed [8]"), "") << "the number of a column";
    EXPECT_EQ(unitInName(Dimension::Direction, "Wind Dir (10s deg)"), "10s deg");
    EXPECT_EQ(unitInName(Dimension::Direction, "WD (°)"), "°");
    for (const char* name :
         {"height", "in", "m", "margin", "(m)", "diam", "stem", "perimeters", "x_m_max", "Baum", "h_min", ""})
        EXPECT_EQ(length(name), "") << name;
}

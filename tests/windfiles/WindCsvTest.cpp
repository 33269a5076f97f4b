// SPDX-License-Identifier: MIT
#include <tests/Near.h>
#include <tests/base/FirstProblem.h>
#include <tests/windfiles/RecordOf.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

WindSeriesColumns polar() {
    WindSeriesColumns columns;
    columns.time = "t";
    columns.speed = "ws";
    columns.direction = "wd";
    return columns;
}

WindSeriesColumns cartesian() {
    WindSeriesColumns columns;
    columns.time = "t";
    columns.u = "u";
    columns.v = "v";
    return columns;
}

Result<WindSeries> read(const std::string& content, const WindSeriesColumns& columns) {
    return recordOf(readWindCsv(content, "w.csv", columns));
}

} // namespace

TEST(WindCsv, ReadsSpeedAndDirectionFrom) {
    const auto series = read("wd,t,ws\n270,100,5\n0,160,2\n", polar());
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(series.value().times, (std::vector<double>{0, 60}));
    expectNear(series.value().velocities[0], {5, 0, 0});
    expectNear(series.value().velocities[1], {0, -2, 0});
    EXPECT_FALSE(series.value().repeat);
    EXPECT_FALSE(series.value().profile);
}

TEST(WindCsv, ReadsDirectionsToward) {
    WindSeriesColumns columns = polar();
    columns.sense = DirectionSense::Toward;
    expectNear(read("t,ws,wd\n0,5,270\n", columns).value().velocities[0], {-5, 0, 0});
}

TEST(WindCsv, ReadsComponents) {
    WindSeriesColumns columns = cartesian();
    expectNear(read("t,u,v,w\n0,1,-2,3\n", columns).value().velocities[0], {1, -2, 0});
    columns.w = "w";
    expectNear(read("t,u,v,w\n0,1,-2,3\n", columns).value().velocities[0], {1, -2, 3});
}

TEST(WindCsv, ConvertsUnits) {
    WindSeriesColumns columns = cartesian();
    columns.speedUnit = "km/h";
    columns.timeUnit = "min";
    const auto series = read("t,u,v\n1.5,36,-18\n2,0,0\n", columns);
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(series.value().times[1], 30.0);
    expectNear(series.value().velocities[0], {10, -5, 0});
}

TEST(WindCsv, ReadsDatesAndTimes) {
    WindSeriesColumns columns = polar();
    columns.timeUnit = "iso8601";
    columns.delimiter = ';';
    const auto series = read("t;ws;wd\n2015-06-29T23:30:00-06:00;1;0\n2015-06-30 06:00;1;0\n", columns);
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(series.value().times[1], 1800.0);
}

namespace {

struct BadRecord {
    const char* name;
    const char* content;
    WindSeriesColumns columns;
    const char* problem;
};

void PrintTo(const BadRecord& bad, std::ostream* out) {
    *out << bad.name;
}

WindSeriesColumns with(WindSeriesColumns columns, std::string WindSeriesColumns::*member, const char* value) {
    columns.*member = value;
    return columns;
}

} // namespace

class WindCsvRefuses : public testing::TestWithParam<BadRecord> {};

TEST_P(WindCsvRefuses, WithLineColumnAndReason) {
    EXPECT_EQ(firstProblem(read(GetParam().content, GetParam().columns)), GetParam().problem);
}

using Columns = WindSeriesColumns;
INSTANTIATE_TEST_SUITE_P(
    Record, WindCsvRefuses,
    testing::Values(
        BadRecord{"Empty", "", polar(), "w.csv: the file is empty"},
        BadRecord{"HeaderOnly", "\nt,ws,wd\n", polar(),
                  "w.csv:2: expected at least one record below the header"},
        BadRecord{"MissingColumn", "t,ws\n0,1\n", polar(),
                  "w.csv:1: wd: no such column for direction; the header has t, ws"},
        BadRecord{"NoTime", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::time, ""),
                  "w.csv:1: time: no column is named for time"},
        BadRecord{"HalfAMap", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::direction, ""),
                  "w.csv:1: direction: no column is named for direction"},
        BadRecord{"BothForms", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::u, "ws"),
                  "w.csv: expected columns for u and v, or for speed and direction"},
        BadRecord{"NeitherForm", "t\n0\n", with(with(polar(), &Columns::speed, ""), &Columns::direction, ""),
                  "w.csv: expected columns for u and v, or for speed and direction"},
        BadRecord{"SpeedUnit", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::speedUnit, "bft"),
                  "w.csv: speed unit: expected a unit of speed (m/s, km/h, kn, mph, ft/s), found 'bft'"},
        BadRecord{"TimeUnit", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::timeUnit, "d"),
                  "w.csv: time unit: expected s, min, h or iso8601, found 'd'"},
        BadRecord{"TextInNumber", "t,ws,wd\n0,1,0\n1,x,0\n", polar(),
                  "w.csv:3: ws: expected a number, found 'x'"},
        BadRecord{"EmptyCell", "t,ws,wd\n0,1,\n", polar(),
                  "w.csv:1: expected at least one record with wind, found none in 1"},
        BadRecord{"NegativeSpeed", "t,ws,wd\n0,-1,0\n", polar(),
                  "w.csv:2: ws: expected a wind speed of 0 to 200 m/s, found '-1'"},
        BadRecord{"MissingSpeedCode", "t,ws,wd\n0,999.9,0\n", polar(),
                  "w.csv:1: expected at least one record with wind, found none in 1"},
        BadRecord{"MissingDirectionCode", "t,ws,wd\n0,1,990\n", polar(),
                  "w.csv:2: wd: expected degrees of -360 to 360, found '990'"},
        BadRecord{"MissingComponentCode", "t,u,v\n0,1,-999\n", cartesian(),
                  "w.csv:1: expected at least one record with wind, found none in 1"},
        BadRecord{"OutOfOrder", "t,ws,wd\n5,1,0\n4,1,0\n", polar(),
                  "w.csv:3: t: expected a later time than in the row before, found '4'"},
        BadRecord{"TimeTwice", "t,ws,wd\n5,1,0\n5,1,0\n", polar(),
                  "w.csv:3: t: expected a later time than in the row before, found '5'"},
        BadRecord{"HugeTime", "t,ws,wd\n1e300,1,0\n", polar(), "w.csv:2: t: expected a time, found '1e300'"},
        BadRecord{"NoDate", "t,ws,wd\n5,1,0\n", with(polar(), &Columns::timeUnit, "iso8601"),
                  "w.csv:2: t: expected a date and time such as 2015-06-29T12:00:00Z, found '5'"},
        BadRecord{"Ragged", "t,ws,wd\n0,1\n", polar(),
                  "w.csv:2: expected 3 cells as in the header, found 2"}),
    [](const auto& info) { return info.param.name; });

TEST(WindCsv, ReportsEveryBadCell) {
    const auto series = read("t,ws,wd\n0,x,y\n1,2,3\n2,-1,0\n", polar());
    ASSERT_FALSE(series);
    ASSERT_EQ(series.problems().size(), 3u);
    EXPECT_EQ(series.problems()[2].line, 4);
}

TEST(WindCsv, StopsAtAHundredBadRows) {
    std::string content = "t,ws,wd\n";
    for (int i = 0; i < 5000; ++i)
        content += "0,x,0\n";
    EXPECT_EQ(read(content, polar()).problems().size(), 100u);
}

// SPDX-License-Identifier: MIT
#include <tests/Near.h>
#include <tests/base/FirstProblem.h>
#include <tests/windfiles/RecordOf.h>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

WindSeriesColumns polar() {
    WindSeriesColumns columns;
    columns.time = {"t"};
    columns.speed = "ws";
    columns.direction = "wd";
    return columns;
}

WindSeriesColumns cartesian() {
    WindSeriesColumns columns;
    columns.time = {"t"};
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

TEST(WindCsv, ComputesColumns) {
    WindSeriesColumns columns = polar();
    columns.time = {"day || 'T' || hour"};
    columns.timeUnit = "iso8601";
    columns.direction = "10 * wd";
    columns.speed = "ws / 2";
    const auto series =
        read("day,hour,ws,wd\n2020-01-01,00:00,5,27\n2020-01-01,00:10,,0\n2020-01-01,01:00,4,00\n", columns);
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(series.value().times, (std::vector<double>{0, 3600}));
    expectNear(series.value().velocities[0], {2.5, 0, 0});
    expectNear(series.value().velocities[1], {0, -2, 0});
    columns.direction = "10 * wid";
    EXPECT_EQ(firstProblem(read("day,hour,ws,wd\n", columns)),
              "w.csv:1: 10 * wid: at character 6: no column \"wid\" in w.csv; did you mean \"wd\"?");
}

TEST(WindCsv, ConvertsUnits) {
    WindSeriesColumns columns = cartesian();
    columns.speedUnit = "km/h";
    columns.timeUnit = "min";
    const auto series = read("t,u,v\n1.5,36,-18\n2,0,0\n", columns);
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(series.value().times[1], 30.0);
    expectNear(series.value().velocities[0], {36, -18, 0}); // convertVelocities() converts them
}

TEST(WindCsv, ReadsDatesAndTimes) {
    WindSeriesColumns columns = polar();
    columns.timeUnit = "iso8601";
    columns.delimiter = ';';
    const auto series = read("t;ws;wd\n2015-06-29T23:30:00-06:00;1;0\n2015-06-30 06:00;1;0\n", columns);
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(series.value().times[1], 1800.0);
}

TEST(WindCsv, ReadsTimesAsPeopleWriteThem) {
    const std::pair<const char*, std::vector<const char*>> tables[] = {
        {"t", {"26/03/2019 23:50", "27/03/2019 00:00", "27/03/2019 00:10"}},
        {"t", {"03/26/2019 11:50 PM", "03/27/2019 12:00 AM", "03/27/2019 12:10 AM"}},
        {"t", {"26.03.2019 23:50", "26.03.2019 24:00", "27.03.2019 00:10"}},
        {"t", {"03/12/2019 23:50", "03/13/2019 00:00", "03/13/2019 00:10"}},
        {"t", {"201903262350", "201903270000", "201903270010"}},
        {"t", {"1553644200000", "1553644800000", "1553645400000"}},
        {"t", {"2019-03-26 23:50:00", "2019-03-27", "2019-03-27 00:10:00"}},
        {"date,t", {"2019-03-26,23:50", "2019-03-27,00:00", "2019-03-27,00:10"}},
        {"date,t", {"20190326,2350", "20190327,0000", "20190327,0010"}}};
    for (const auto& [names, times] : tables) {
        std::string table = std::string(names) + ",ws,wd\n";
        for (const char* time : times)
            table += std::string(time) + ",5,270\n";
        WindSeriesColumns columns = polar();
        if (names[0] == 'd')
            columns.time = {"date", "t"};
        const auto series = read(table, columns);
        ASSERT_TRUE(series) << firstProblem(series);
        EXPECT_EQ(series.value().times, (std::vector<double>{0, 600, 1200})) << table;
    }
}

TEST(WindCsv, ReadsDaysOfSpreadsheets) {
    WindSeriesColumns columns = polar();
    columns.timeUnit = "days";
    const auto series = readWindCsv("t,ws,wd\n43034.625,5,0\n43035.625,5,0\n", "w.csv", columns);
    ASSERT_TRUE(series) << firstProblem(series);
    EXPECT_EQ(recordOf(series).value().times[1], 86400.0);
}

TEST(WindCsv, AsksForTheOrderOfDayAndMonth) {
    const std::string table = "t,ws,wd\n01/02/1970,5,0\n02/02/1970,5,0\n";
    WindSeriesColumns columns = polar();
    columns.timeOrder = "dmy";
    EXPECT_EQ(read(table, columns).value().times[1], 86400.0);
    columns.timeOrder = "mdy";
    EXPECT_EQ(read(table, columns).value().times[1], 31 * 86400.0);
}

TEST(WindCsv, AveragesRecordsOfOneTime) {
    const auto content = readWindCsv("t,ws,wd\n"
                                     "2019-10-27 02:00,2,270\n2019-10-27 02:30,3,270\n"
                                     "2019-10-27 02:00,4,270\n2019-10-27 02:30,5,270\n2019-10-27 03:00,6,0\n",
                                     "w.csv", polar());
    ASSERT_TRUE(content) << firstProblem(content);
    const WindSeries series = recordOf(content).value();
    EXPECT_EQ(series.times, (std::vector<double>{0, 1800, 3600}));
    expectNear(series.velocities[0], {3, 0, 0});
    expectNear(series.velocities[1], {4, 0, 0});
    EXPECT_EQ(content.value().assumptions,
              (std::vector<std::string>{"its times name no zone and are taken as UTC",
                                        "2 of 5 records are not later than those above; records are sorted, "
                                        "and those of one time averaged"}));
    EXPECT_EQ(read("t,ws,wd\n5,1,270\n5,2,270\n6,1,0\n", polar()).value().times.size(), 2u);
}

TEST(WindCsv, DatesWithDotsHaveTheDayFirst) {
    const auto content =
        readWindCsv("t,ws,wd\n03.02.2024 12:00,2,270\n04.02.2024 12:00,3,270\n", "w.csv", polar());
    ASSERT_TRUE(content) << firstProblem(content);
    EXPECT_EQ(content.value().summary.start, "2024-02-03T12:00:00Z");
    EXPECT_EQ(content.value().assumptions.front(),
              "dates such as 04.02.2024 12:00 are taken with the day first; time_order sets another order");
    EXPECT_EQ(read("t,ws,wd\n02.28.2024,2,270\n03.01.2024,3,270\n", polar()).value().times.back(),
              2 * 86400.0);
}

/// As in files of NDBC, whose directions may be valid then. In km/h it is a wind.
TEST(WindCsv, A99InMetresPerSecondIsMissing) {
    EXPECT_EQ(read("t,ws,wd\n0,5,270\n1,99.0,270\n2,7,0\n", polar()).value().times.size(), 2u);
    WindSeriesColumns columns = polar();
    columns.speedUnit = "km/h";
    EXPECT_EQ(read("t,ws,wd\n0,5,270\n1,99.0,270\n2,7,0\n", columns).value().times.size(), 3u);
}

TEST(WindCsv, ReversesRecordsOfWhichTheNewestIsFirst) {
    const auto content =
        readWindCsv("t,ws,wd\n2019-10-27 12:00,2,270\n2019-10-27 08:00,3,270\n2019-10-27 05:00,4,270\n",
                    "w.csv", polar());
    ASSERT_TRUE(content) << firstProblem(content);
    const WindSeries series = recordOf(content).value();
    EXPECT_EQ(series.times, (std::vector<double>{0, 10800, 25200}));
    expectNear(series.velocities[0], {4, 0, 0});
    EXPECT_EQ(content.value().assumptions.back(), "its records run backward in time and are reversed");
}

TEST(WindCsv, ReadsUnitsOfDirections) {
    const auto first = [](const std::string& name, const char* unit, const char* cell) {
        WindSeriesColumns columns = polar();
        columns.direction = name;
        columns.directionUnit = unit;
        const auto series = read("t,ws," + name + "\n0,5," + cell + "\n", columns);
        return series ? series.value().velocities[0] : glm::vec3(HUGE_VALF);
    };
    expectNear(first("wd", "10 deg", "27"), {5, 0, 0});
    expectNear(first("Wind Dir (10s deg)", "", "27"), {5, 0, 0});
    expectNear(first("Wind Dir (10s deg)", "deg", "270"), {5, 0, 0});
    expectNear(first("wd", "rad", "4.712389"), {5, 0, 0});
    expectNear(first("wd_rad", "", "4.712389"), {5, 0, 0});
    expectNear(first("wd (°)", "", "270"), {5, 0, 0});
    for (const char* west : {"W", "w", "West"})
        expectNear(first("wd", "", west), {5, 0, 0});
    expectNear(first("wd", "", "North-East"), {-5 * std::sqrt(0.5f), -5 * std::sqrt(0.5f), 0});
    expectNear(first("wd", "", "SSW"),
               {5 * std::sin(glm::radians(22.5f)), 5 * std::cos(glm::radians(22.5f)), 0});
}

TEST(WindCsv, NotesDirectionsThatMayBeTens) {
    const auto notes = [](const char* directionUnit, const char* cell) {
        WindSeriesColumns columns = polar();
        columns.timeUnit = "s";
        columns.directionUnit = directionUnit;
        return readWindCsv(std::string("t,ws,wd\n0,5,0\n1,5,") + cell + "\n", "w.csv", columns)
            .value()
            .assumptions;
    };
    EXPECT_EQ(notes("", "36"),
              std::vector<std::string>{"its directions are taken as degrees, though none is above "
                                       "36; direction_unit sets another unit"});
    EXPECT_TRUE(notes("", "37").empty());
    EXPECT_TRUE(notes("deg", "36").empty());
    EXPECT_TRUE(notes("", "0").empty());
}

TEST(WindCsv, LeavesOutVariableDirections) {
    const auto content =
        readWindCsv("t,ws,wd\n0,5,270\n1,1,VRB\n2,1,990\n3,0,VRB\n4,0,0\n", "w.csv", polar());
    ASSERT_TRUE(content) << firstProblem(content);
    const WindSeries series = recordOf(content).value();
    EXPECT_EQ(series.times, (std::vector<double>{0, 3, 4}));
    expectNear(series.velocities[1], {0, 0, 0});
    EXPECT_EQ(content.value().assumptions.front(),
              "2 of 5 records have a variable direction and are skipped");
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

WindSeriesColumns timedBy(std::vector<std::string> time) {
    WindSeriesColumns columns = polar();
    columns.time = std::move(time);
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
        BadRecord{"NoTime", "t,ws,wd\n0,1,0\n", timedBy({}), "w.csv:1: time: no column is named for time"},
        BadRecord{"NoDateColumn", "t,ws,wd\n0,1,0\n", timedBy({"d", "t"}),
                  "w.csv:1: d: no such column for time; the header has t, ws, wd"},
        BadRecord{"HalfAMap", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::direction, ""),
                  "w.csv:1: direction: no column is named for direction"},
        BadRecord{"BothForms", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::u, "ws"),
                  "w.csv: expected columns for u and v, or for speed and direction"},
        BadRecord{"NeitherForm", "t\n0\n", with(with(polar(), &Columns::speed, ""), &Columns::direction, ""),
                  "w.csv: expected columns for u and v, or for speed and direction"},
        BadRecord{"SpeedUnit", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::speedUnit, "bft"),
                  "w.csv: speed unit: expected a unit of speed (m/s, km/h, kn, mph, ft/s), found 'bft'"},
        BadRecord{
            "TimeUnit", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::timeUnit, "a"),
            "w.csv: time unit: expected iso8601 or a unit of time (s, min, h, days, weeks, ms), found 'a'"},
        BadRecord{"TextInNumber", "t,ws,wd\n0,1,0\n1,x,0\n", polar(),
                  "w.csv:3: ws: expected a number, found 'x'"},
        BadRecord{"EmptyCell", "t,ws,wd\n0,1,\n", polar(),
                  "w.csv:1: expected at least one record with wind, found none in 1"},
        BadRecord{"NegativeSpeed", "t,ws,wd\n0,-1,0\n", polar(),
                  "w.csv:2: ws: expected a wind speed of 0 to 200 m/s, found '-1'"},
        BadRecord{"MissingSpeedCode", "t,ws,wd\n0,999.9,0\n", polar(),
                  "w.csv:1: expected at least one record with wind, found none in 1"},
        BadRecord{"TimeOrder", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::timeOrder, "ymd"),
                  "w.csv: time order: expected dmy or mdy, found 'ymd'"},
        BadRecord{"TimeFormat", "t,ws,wd\n0,1,0\n",
                  with(with(polar(), &Columns::timeFormat, "%F"), &Columns::timeUnit, "h"),
                  "w.csv: time format: cannot be used with the time unit h"},
        BadRecord{"DirectionUnit", "t,ws,wd\n0,1,0\n", with(polar(), &Columns::directionUnit, "gon"),
                  "w.csv: direction unit: expected a unit of direction (deg, 10 deg, rad), found 'gon'"},
        BadRecord{"OnlyVariable", "t,ws,wd\n0,1,990\n", polar(),
                  "w.csv:1: expected at least one record with wind, found none in 1"},
        BadRecord{
            "Direction", "t,ws,wd\n0,1,400\n", polar(),
            "w.csv:2: wd: expected a direction of -360 to 360 degrees (other units: direction_unit) or an "
            "English compass point (others: an expression such as replace(column, 'O', 'E')), found '400'"},
        BadRecord{
            "Ost", "t,ws,wd\n0,1,O\n", polar(),
            "w.csv:2: wd: expected a direction of -360 to 360 degrees (other units: direction_unit) or an "
            "English compass point (others: an expression such as replace(column, 'O', 'E')), found 'O'"},
        BadRecord{"MissingComponentCode", "t,u,v\n0,1,-999\n", cartesian(),
                  "w.csv:1: expected at least one record with wind, found none in 1"},
        BadRecord{"OutOfOrder", "t,ws,wd\n5,1,0\n4,1,0\n", polar(),
                  "w.csv:3: t: expected a time not before that of the row above, found '4'"},
        BadRecord{"DateOutOfOrder",
                  "t,ws,wd\n2020-01-01 05:00,1,0\n2020-01-01 03:59,1,0\n2020-01-01 06:00,1,0\n", polar(),
                  "w.csv:3: t: expected a time at most an hour before those above, found "
                  "'2020-01-01T03:59:00Z'"},
        BadRecord{
            "OpenOrder", "t,ws,wd\n01/02/2020 05:00,1,0\n02/02/2020 03:59,1,0\n", polar(),
            "w.csv:2: t: expected a day above 12 that tells the order of day and month, or time_order = "
            "\"dmy\" or \"mdy\", found '01/02/2020 05:00'"},
        BadRecord{"TwoOrders", "t,ws,wd\n13/02/2020,1,0\n02/14/2020,1,0\n", polar(),
                  "w.csv:3: t: expected one order of day and month, found \"13/02/2020\" and \"02/14/2020\""},
        BadRecord{"OtherOrder", "t,ws,wd\n13/02/2020,1,0\n", with(polar(), &Columns::timeOrder, "mdy"),
                  "w.csv:2: t: expected a date in the order mdy, found '13/02/2020'"},
        BadRecord{"OtherFormat", "t,ws,wd\n2020-02-13,1,0\n", with(polar(), &Columns::timeFormat, "%d.%m.%y"),
                  "w.csv:2: t: expected a time as in time_format, %d.%m.%y, found '2020-02-13'"},
        BadRecord{"MillisecondsAsSeconds", "t,ws,wd\n1509030000000,1,0\n",
                  with(polar(), &Columns::timeUnit, "s"),
                  "w.csv:2: t: expected a time below 1e11 s (milliseconds: time_unit = \"ms\"; dates: "
                  "\"iso8601\"), found '1509030000000'"},
        BadRecord{"HugeTime", "t,ws,wd\n1e300,1,0\n", polar(),
                  "w.csv:2: t: expected a time below 1e11 s (milliseconds: time_unit = \"ms\"; dates: "
                  "\"iso8601\"), found '1e300'"},
        BadRecord{"NoDate", "t,ws,wd\n5,1,0\n", with(polar(), &Columns::timeUnit, "iso8601"),
                  "w.csv:2: t: expected a date and time such as 2015-06-29T12:00:00Z (other forms: "
                  "time_format; several "
                  "columns: time = [\"date\", \"time\"]), found '5'"},
        BadRecord{"Ragged", "t,ws,wd\n0,1\n", polar(),
                  "w.csv:2: expected 3 cells as in the header, found 2; line 1 is taken for the header, \"t, "
                  "ws, wd\"; to "
                  "read it otherwise, set header_line (0: no header), comment (how lines begin that are left "
                  "out) or "
                  "delimiter in [inventory], or in a [wind] of kind \"series\""}),
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

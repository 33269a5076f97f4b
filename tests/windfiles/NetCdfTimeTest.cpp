// SPDX-License-Identifier: MIT
// Times of the CF conventions in every calendar.
#include <tests/windfiles/NetCdfWriting.h>

#include <osgTreeWind/base/DateText.h>

namespace osgTreeWind {

namespace {

std::string writeTimes(const TemporaryFolder& folder, const Numbers& times, const std::string& unit,
                       const std::string& calendar, bool isScalar = false) {
    std::string path = folder.path() + "/times.nc";
    NetCdfWriter file(path);
    file.axis("x", {0, 10}, "m").axis("y", {0, 10}, "m");
    NetCdfAttributes attributes;
    if (!calendar.empty())
        attributes.emplace_back("calendar", calendar);
    std::vector<std::string> dimensions = {"y", "x"};
    if (isScalar) {
        attributes.emplace_back("units", unit);
        file.array("time", {}, attributes, times);
    } else {
        file.axis("time", times, unit, attributes);
        dimensions.insert(dimensions.begin(), "time");
    }
    const Numbers values(4 * (isScalar ? 1 : times.size()), 1.0);
    file.array("u", dimensions, metresPerSecond, values).array("v", dimensions, metresPerSecond, values);
    return path;
}

struct Case {
    Numbers numbers;
    const char *unit, *calendar, *start;
    Numbers seconds;
};

} // namespace

TEST(NetCdfTime, DecodesUnitsZonesAndCalendars) {
    const TemporaryFolder folder;
    const std::string probe = writeTimes(folder, {0}, "hours since 2000-01-01", "");
    REQUIRE_NETCDF(probe);
    const Case cases[] = {
        {{0, 1}, "hours since 1900-01-01 00:00:00.0", "gregorian", "1900-01-01T00:00:00Z", {0, 3600}},
        {{1096626, 1096627}, "hours since 1900-01-01 00:00:00.0", "", "2025-02-06T18:00:00Z", {0, 3600}},
        {{0, 600}, "minutes since 2005-08-28 00:00:00", "standard", "2005-08-28T00:00:00Z", {0, 36000}},
        {{1496512800}, "seconds since 1970-01-01", "proleptic_gregorian", "2017-06-03T18:00:00Z", {0}},
        {{0.25, 0.5}, "days since 2000-2-28 18:00", "standard", "2000-02-29T00:00:00Z", {0, 21600}},
        {{0, 1}, "weeks since 1999-12-31T12:00:00Z", "standard", "1999-12-31T12:00:00Z", {0, 604800}},
        {{0, 1}, "Hour since 2017-05-21T00:00:00Z", "", "2017-05-21T00:00:00Z", {0, 3600}},
        {{0}, "hours since 2017-05-21 00:30:00 +02:00", "", "2017-05-20T22:30:00Z", {0}},
        {{0}, "hours since 2017-12-31 22:00:00 -3:30", "", "2018-01-01T01:30:00Z", {0}},
        {{0}, "hours since 2017-12-31 22:00 UTC", "", "2017-12-31T22:00:00Z", {0}},
        {{0}, "minutes since 2005-08-28_12:30:00", "", "2005-08-28T12:30:00Z", {0}},
        {{1.0 / 3.0}, "hours since 2020-01-01", "", "2020-01-01T00:20:00Z", {0}}, // rounded to the second
        // NCEP uses the year 1, for which the standard and proleptic calendars differ by two days.
        {{1895592}, "hours since 1-1-1 00:00:0.0", "proleptic_gregorian", "0217-04-02T00:00:00Z", {0}},
        {{17540592}, "hours since 1-1-1 00:00:0.0", "standard", "2002-01-07T00:00:00Z", {0}},
        {{17540592}, "hours since 1-1-1 00:00:0.0", "proleptic_gregorian", "2002-01-09T00:00:00Z", {0}},
        {{1}, "days since 1582-10-04", "standard", "1582-10-15T00:00:00Z", {0}},
        {{59, 60}, "days since 2000-01-01", "standard", "2000-02-29T00:00:00Z", {0, 86400}},
        {{59, 60}, "days since 2000-01-01", "noleap", "2000-03-01 00:00:00, calendar noleap", {0, 86400}},
        {{365}, "days since 1850-01-01", "365_day", "1851-01-01 00:00:00, calendar 365_day", {0}},
        {{59}, "days since 2001-01-01", "all_leap", "2001-02-29 00:00:00, calendar all_leap", {0}},
        {{366.5}, "days since 2001-01-01", "366_day", "2002-01-01 12:00:00, calendar 366_day", {0}},
        {{59, 89}, "days since 2001-01-01", "360_day", "2001-02-30 00:00:00, calendar 360_day", {0, 2592000}},
        {{-1}, "days since 2001-01-01", "360_day", "2000-12-30 00:00:00, calendar 360_day", {0}},
        {{5, 8}, "seconds", "", "", {0, 3}},
    };
    for (const Case& one : cases) {
        const std::string path = writeTimes(folder, one.numbers, one.unit, one.calendar);
        const Result<WindContent> content = contentOf(path);
        ASSERT_TRUE(content) << one.unit << ": " << firstProblem(content);
        const std::string& start = content.value().summary.start;
        EXPECT_EQ(start, one.start) << one.unit << " " << one.calendar;
        const Numbers& seconds = std::get<GridWind::Grid>(content.value().data).times;
        ASSERT_EQ(seconds.size(), one.seconds.size());
        for (std::size_t i = 0; i < seconds.size(); ++i)
            EXPECT_NEAR(seconds[i], one.seconds[i], 1e-6) << one.unit;
        EXPECT_EQ(parseDate(start).has_value(), !start.empty() && start.find(',') == std::string::npos);
    }
}

TEST(NetCdfTime, ReadsATimeWithoutADimension) {
    const TemporaryFolder folder;
    const std::string path = writeTimes(folder, {6}, "hours since 2020-02-29", "standard", true);
    REQUIRE_NETCDF(path);
    EXPECT_EQ(summaryOf(path).start, "2020-02-29T06:00:00Z");
    EXPECT_TRUE(gridOf(path).times.empty());
}

TEST(NetCdfTime, RefusesInvalidTimesByName) {
    const TemporaryFolder folder;
    const std::string probe = writeTimes(folder, {0}, "hours since 2000-01-01", "");
    REQUIRE_NETCDF(probe);
    const std::tuple<const char*, const char*, const char*> cases[] = {
        {"months since 2000-01-01", "",
         "time: expected times in seconds, minutes, hours, days or weeks, found "
         "'months since 2000-01-01'"},
        {"years since 2000-01-01", "", "time: expected times in seconds"},
        {"day as %Y%m%d.%f", "", "time: expected times in seconds"},
        {"hours since yesterday", "", "time: expected times since a date and time"},
        {"hours since 2001-02-29", "", "time: expected times since a date and time"},
        {"hours since 2000-02-29", "noleap", "time: expected times since a date and time"},
        {"hours since 2000-13-01", "360_day", "time: expected times since a date and time"},
        {"hours since 2000-01-01 25:00", "", "time: expected times since a date and time"},
        {"hours since 2000-01-01", "mayan", "time: expected a calendar"}};
    for (const auto& [unit, calendar, message] : cases) {
        const Result<WindContent> content = contentOf(writeTimes(folder, {0}, unit, calendar));
        ASSERT_FALSE(content) << unit << " " << calendar;
        EXPECT_EQ(content.problems().size(), 1u);
        EXPECT_NE(firstProblem(content).find(message), std::string::npos) << firstProblem(content);
    }
}

} // namespace osgTreeWind

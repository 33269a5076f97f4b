// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/DateText.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

TEST(DateText, CountsSecondsSinceTheEpoch) {
    EXPECT_EQ(parseDate("1970-01-01T00:00:00Z"), 0.0);
    EXPECT_EQ(parseDate("2015-06-29T12:00:00Z"), 1435579200.0);
    EXPECT_EQ(parseDate("2000-02-29T23:59:59Z"), 951868799.0);
    EXPECT_EQ(parseDate("2000-03-01T00:00:00Z"), 951868800.0);
    EXPECT_EQ(parseDate("1900-03-01T00:00:00Z"), -2203891200.0);
    EXPECT_EQ(parseDate("2100-12-31T23:59:00Z"), 4133980740.0);
}

TEST(DateText, KeepsFractions) {
    EXPECT_NEAR(*parseDate("1970-01-01T00:00:01.05"), 1.05, 1e-12);
    EXPECT_NEAR(*parseDate("1970-01-01T00:00:01.999Z"), 1.999, 1e-12);
    EXPECT_NEAR(*parseDate("1970-01-01 00:00:01,25"), 1.25, 1e-12);
}

TEST(DateText, ReadsTheFormsOfPeopleAndServices) {
    for (const char* text : {"2015-06-29T12:00",
                             "2015-06-29 12:00:00",
                             "2015-06-29t12:00z",
                             "2015-06-29T14:00:00+02:00",
                             "2015-06-29T05:30-06:30",
                             "2015-06-29T14:00:00+0200",
                             "2015-06-29 14:00+02",
                             "2015-06-29 12:00:00 UTC",
                             "2015-06-29 14:00 GMT+02:00",
                             "2015/06/29 12:00:00",
                             "2015.06.29 12:00",
                             "2015 06 29 12 00",
                             "29-Jun-2015 12:00",
                             "29 june 2015, 12:00:00",
                             "29-Jun-15 12:00",
                             "2015-Jun-29 12:00",
                             "June 29, 2015 12:00 PM",
                             "Mon, 29 Jun 2015 12:00:00 GMT",
                             "20150629T120000Z",
                             "20150629T1400+0200",
                             "20150629 1200",
                             "201506291200",
                             "20150629120000",
                             "2015062912",
                             "2015-6-29 12"})
        EXPECT_EQ(parseDate(text), 1435579200.0) << text;
}

TEST(DateText, KeepsBothOrdersOfDayAndMonth) {
    for (const char* text : {"29/06/2015 12:00", "29.06.2015 12:00", "29-06-2015 12:00", "29.6.15 12:00:00",
                             "29/06/2015, 12:00:00", "29/06/2015 12h00"}) {
        EXPECT_EQ(readDate(text).dayFirst, 1435579200.0) << text;
        EXPECT_FALSE(readDate(text).monthFirst) << text;
    }
    for (const char* text : {"06/29/2015 12:00", "6/29/15 12:00:00 PM", "06/29/2015 12 pm"}) {
        EXPECT_EQ(readDate(text).monthFirst, 1435579200.0) << text;
        EXPECT_FALSE(readDate(text).dayFirst) << text;
    }
    const DateReadings open = readDate("01/02/1970 12:30 AM");
    EXPECT_EQ(open.dayFirst, 31 * 86400.0 + 1800.0);
    EXPECT_EQ(open.monthFirst, 86400.0 + 1800.0);
}

TEST(DateText, EndsADayAt24) {
    EXPECT_EQ(parseDate("1970-01-01 24:00"), 86400.0);
    EXPECT_EQ(parseDate("197001012400"), 86400.0);
    EXPECT_FALSE(parseDate("1970-01-01 24:01"));
}

TEST(DateText, TakesADayAsItsMidnight) {
    EXPECT_EQ(parseDate("1970-01-02"), 86400.0);
    EXPECT_EQ(parseDate("19700102"), 86400.0);
}

TEST(DateText, KnowsWhetherAZoneIsNamed) {
    EXPECT_TRUE(readDate("2015-06-29T12:00Z").hasZone);
    EXPECT_TRUE(readDate("2015-06-29 12:00 +0200").hasZone);
    EXPECT_FALSE(readDate("2015-06-29T12:00").hasZone);
}

TEST(DateText, ReadsByAFormat) {
    EXPECT_EQ(readDate("29.06.2015 12.00", "%d.%m.%Y %H.%M").dayFirst, 1435579200.0);
    EXPECT_EQ(readDate("2015 180 1200", "%Y %j %H%M").dayFirst, 1435579200.0);
    EXPECT_EQ(readDate("15-06-29 14:00 +0200", "%y-%m-%d %H:%M %z").monthFirst, 1435579200.0);
    EXPECT_TRUE(readDate("15-06-29 14:00 +0200", "%y-%m-%d %H:%M %z").hasZone);
    for (const char* text : {"29.06.2015", "29.06.2015 12.00 h", "31.06.2015 12.00", "29.06.2015 12.60", ""})
        EXPECT_FALSE(readDate(text, "%d.%m.%Y %H.%M").isRead()) << text;
    EXPECT_FALSE(readDate("2015-06-29 12:00 CEST", "%Y-%m-%d %H:%M %Z").isRead());
    EXPECT_FALSE(readDate("12:00", "%H:%M").isRead());
    EXPECT_FALSE(readDate("12:00", "%").isRead());
}

TEST(DateText, WritesWholeSeconds) {
    EXPECT_EQ(isoTimeText(1435579200.9), "2015-06-29T12:00:00Z");
    EXPECT_EQ(isoTimeText(-0.5), "1969-12-31T23:59:59Z");
    EXPECT_EQ(isoTimeText(-2203891200.0), "1900-03-01T00:00:00Z");
}

TEST(DateText, RejectsWhatItWouldHaveToGuess) {
    EXPECT_FALSE(readDate("2019-10-27 15 00:30").isRead());
    for (const char* text :
         {"", "2015", "12:00", "29.06.2015 12.50", "2015-06-29 15.5", "2015-06-29 100", "15-06-29 12:00",
          "2015-06-29T12:00 CET", "29 juin 2015", "0015-06-29T12:00", "1435579200"})
        EXPECT_FALSE(readDate(text).isRead()) << text;
}

TEST(DateText, RejectsTimesThatDoNotExist) {
    for (const char* text :
         {"2015-02-29T12:00", "2015-13-01T12:00", "2015-00-01T12:00", "2015-01-00T12:00", "2015-01-32T12:00",
          "2015-06-29T12:60", "2015-06-29T12:00:60", "2015-06-29T1x:00:00.5", "2015-06-29T12:00Zz",
          "2015-06-29T12:00+2", "-015-06-29T12:00", "201506291260", "2015-06-29 13:00 PM",
          "2015-06-29T12:00+25:00"})
        EXPECT_FALSE(parseDate(text)) << text;
}

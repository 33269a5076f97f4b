// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/IsoTime.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

// Reference values from `date -u -d TEXT +%s`.
TEST(IsoTime, CountsSecondsSinceTheEpoch) {
    EXPECT_EQ(parseIsoTime("1970-01-01T00:00:00Z"), 0.0);
    EXPECT_EQ(parseIsoTime("2015-06-29T12:00:00Z"), 1435579200.0);
    EXPECT_EQ(parseIsoTime("2000-02-29T23:59:59Z"), 951868799.0);
    EXPECT_EQ(parseIsoTime("2000-03-01T00:00:00Z"), 951868800.0);
    EXPECT_EQ(parseIsoTime("1900-03-01T00:00:00Z"), -2203891200.0);
    EXPECT_EQ(parseIsoTime("2100-12-31T23:59:00Z"), 4133980740.0);
}

TEST(IsoTime, AcceptsCommonForms) {
    for (const char* text : {"2015-06-29T12:00", "2015-06-29 12:00:00", "2015-06-29t12:00z",
                             "2015-06-29T14:00:00+02:00", "2015-06-29T05:30-06:30"})
        EXPECT_EQ(parseIsoTime(text), 1435579200.0) << text;
}

TEST(IsoTime, KeepsFractions) {
    EXPECT_NEAR(*parseIsoTime("1970-01-01T00:00:01.05"), 1.05, 1e-12);
    EXPECT_NEAR(*parseIsoTime("1970-01-01T00:00:01.999Z"), 1.999, 1e-12);
}

TEST(IsoTime, WritesWholeSeconds) {
    EXPECT_EQ(isoTimeText(1435579200.9), "2015-06-29T12:00:00Z");
    EXPECT_EQ(isoTimeText(-0.5), "1969-12-31T23:59:59Z");
    EXPECT_EQ(isoTimeText(-2203891200.0), "1900-03-01T00:00:00Z");
}

TEST(IsoTime, RejectsInvalidTimes) {
    for (const char* text : {"",
                             "2015",
                             "2015-06-29",
                             "29.06.2015 12:00",
                             "2015-6-29T12:00",
                             "2015-02-29T12:00",
                             "2015-13-01T12:00",
                             "2015-00-01T12:00",
                             "2015-01-00T12:00",
                             "2015-01-32T12:00",
                             "2015-06-29T24:00",
                             "2015-06-29T12:60",
                             "2015-06-29T12:00:60",
                             "2015-06-29T12:00:00.",
                             "2015-06-29T1x:00:00.5",
                             "2015-06-29T12:00 CET",
                             "2015-06-29T12:00Zz",
                             "2015-06-29T12:00+2",
                             "2015-06-29T12:00+02",
                             "-015-06-29T12:00",
                             "1435579200"})
        EXPECT_FALSE(parseIsoTime(text)) << text;
}

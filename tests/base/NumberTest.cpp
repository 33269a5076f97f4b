// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Number.h>

#include <gtest/gtest.h>

#include <locale>

using namespace osgTreeWind;

TEST(Number, ParsesDecimalNumbersAndIgnoresBlanks) {
    EXPECT_EQ(parseNumber("42"), 42.0);
    EXPECT_EQ(parseNumber(" -0.5\t"), -0.5);
    EXPECT_EQ(parseNumber("+1.5e3"), 1500.0);
    EXPECT_EQ(parseNumber(".25"), 0.25);
}

TEST(Number, RejectsEverythingElse) {
    for (const char* text : {"", "  ", "abc", "1.5m", "1 2", "3,1", "nan", "inf", "-inf", "1e999", "0x10",
                             "+-1", "++1", "+", "-", "1e", "NA", "--1"})
        EXPECT_FALSE(parseNumber(text)) << text;
}

TEST(Number, TextParsesToTheSameNumber) {
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(-100000.0), "-100000");
    EXPECT_EQ(numberText(1e300), "1e+300");
    EXPECT_EQ(parseNumber(numberText(1.0 / 3.0)), 1.0 / 3.0);
}

TEST(Number, IgnoresTheLocale) {
    struct GermanNumbers : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
    EXPECT_EQ(parseNumber("1234.5"), 1234.5);
    EXPECT_EQ(numberText(1234.5), "1234.5");
    std::locale::global(before);
}

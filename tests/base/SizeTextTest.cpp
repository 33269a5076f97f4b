// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/SizeText.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// A text, and its value; estimates are marked.
struct SizeCase {
    const char* text;
    double value;
    bool isEstimate = false;
};

void expectSizes(SizeKind kind, bool isInMetres, const std::vector<SizeCase>& cases, bool commas = false) {
    for (const SizeCase& each : cases) {
        const auto size = parseSize(each.text, kind, commas);
        ASSERT_TRUE(size) << each.text;
        EXPECT_NEAR(size->value, each.value, 1e-9) << each.text;
        EXPECT_EQ(size->isInMetres, isInMetres) << each.text;
        EXPECT_EQ(size->isEstimate, each.isEstimate) << each.text;
    }
}

void expectNone(SizeKind kind, const std::vector<const char*>& texts) {
    for (const char* text : texts)
        EXPECT_FALSE(parseSize(text, kind)) << text;
}

} // namespace

TEST(SizeText, ReadsNumbersWithEitherDecimalMark) {
    expectSizes(SizeKind::Height, false,
                {{"18", 18}, {" 18.5 ", 18.5}, {"12,5", 12.5}, {"-9999", -9999}, {"5½", 5.5}, {"1e1", 10}});
}

TEST(SizeText, ReadsUnits) {
    // 1 ft = .3048 m and 1 in = .0254 m by definition
    expectSizes(SizeKind::Height, true,
                {{"18 m", 18},
                 {"18m", 18},
                 {"18,5 m", 18.5},
                 {"45 cm", 0.45},
                 {"450 mm", 0.45},
                 {"12 Metres", 12},
                 {"60'", 18.288},
                 {"60 ft.", 18.288},
                 {"60 feet", 18.288},
                 {"45'6\"", 13.8684},
                 {"45′6″", 13.8684},
                 {"45’ 6”", 13.8684},
                 {"45' 6''", 13.8684},
                 {"45 ft 6 in", 13.8684},
                 {"45'6", 13.8684},
                 {"18\"", 0.4572},
                 {"5½\"", 0.1397}});
}

TEST(SizeText, ReadsAboutAsAnEstimate) {
    expectSizes(SizeKind::Height, false,
                {{"~20", 20, true},
                 {"ca. 20", 20, true},
                 {"ca.20", 20, true},
                 {"c. 20", 20, true},
                 {"approx 20", 20, true},
                 {"20 (est.)", 20, true},
                 {"20?", 20, true},
                 {"≈20", 20, true}});
    expectSizes(SizeKind::Height, true, {{"etwa 20 m", 20, true}, {"~60'", 18.288, true}});
}

TEST(SizeText, TakesTheMiddleOfAClass) {
    expectSizes(SizeKind::Height, false,
                {{"9-12", 10.5, true},
                 {"12 – 15", 13.5, true},
                 {"9 to 12", 10.5, true},
                 {"9 bis 12", 10.5, true},
                 {"von 9 bis unter 12", 10.5, true},
                 {"de 9 à 12", 10.5, true},
                 {"9 tot 12", 10.5, true},
                 {"between 9 and 12", 10.5, true},
                 {"zwischen 9 und 12", 10.5, true},
                 {"10-<20", 15, true},
                 {">9 <=12", 10.5, true},
                 {"≥ 9 - < 12", 10.5, true},
                 {"(9,5-12,5]", 11, true},
                 {"10/15", 12.5, true}});
    expectSizes(SizeKind::Height, true,
                {{"9-12 m", 10.5, true},
                 {"9m - 12m", 10.5, true},
                 {"10-20 ft", 4.572, true},
                 {"10'-20'", 4.572, true}});
    expectSizes(SizeKind::Trunk, true, {{"100-150 cm", 1.25, true}});
}

TEST(SizeText, SkipsTheLetterOfAClass) {
    expectSizes(SizeKind::Height, true, {{"B (5-10 m)", 7.5, true}, {"a(0-5m)", 2.5, true}});
    expectNone(SizeKind::Height, {"B (m)", "B 5-10", "B2 (5-10)", "12 (5-10)", "B (5-10"});
}

TEST(SizeText, TakesTheBoundOfAnOpenClass) {
    expectSizes(SizeKind::Height, false,
                {{">18", 18, true},          {"<6", 6, true},           {"≥18", 18, true},
                 {">= 18", 18, true},        {"18+", 18, true},         {"over 18", 18, true},
                 {"more than 18", 18, true}, {"18 and more", 18, true}, {"18 oder mehr", 18, true},
                 {"18 und mehr", 18, true},  {"18 et plus", 18, true},  {"plus de 18", 18, true},
                 {"über 18", 18, true},      {"less than 6", 6, true},  {"up to 6", 6, true},
                 {"bis 6", 6, true},         {"tot 6", 6, true},        {"onder 6", 6, true},
                 {"unter 6", 6, true},       {"moins de 6", 6, true}});
    expectSizes(SizeKind::Height, true, {{"24 m en hoger", 24, true}, {">60'", 18.288, true}});
}

TEST(SizeText, AddsTheSquaresOfStems) {
    // sqrt(12^2 + 14^2 + 9^2) and so on
    expectSizes(SizeKind::Trunk, false,
                {{"12+14+9", 20.518284528683193},
                 {"12 + 14 + 9", 20.518284528683193},
                 {"12/14/9", 20.518284528683193},
                 {"12,14,9", 20.518284528683193},
                 {"12; 14 & 9", 20.518284528683193},
                 {"12, 14 and 9", 20.518284528683193},
                 {"20, 15", 25},
                 {"20;15", 25},
                 {"20 und 15", 25},
                 {"20,5, 15,3", 25.580070367377804},
                 {"3x10", 17.320508075688775},
                 {"3 × 10", 17.320508075688775},
                 {"2x10+1x20", 24.49489742783178}});
    expectSizes(SizeKind::Trunk, true,
                {{"20+15 cm", 0.25}, {"20 cm + 15 cm", 0.25}, {"3x10 cm", 0.17320508075688775}});
    expectSizes(SizeKind::Trunk, false, {{"~20+15", 25, true}});
}

TEST(SizeText, TakesTheMeanOfACrownsExtents) {
    expectSizes(SizeKind::Width, false, {{"8x6", 7}, {"8 × 6", 7}, {"6-8", 7, true}});
    expectSizes(SizeKind::Width, true, {{"8 x 6 m", 7}, {"8m x 6m", 7}});
}

TEST(SizeText, SeparatesStemsByCommasWhereTheColumnDoes) {
    expectSizes(SizeKind::Trunk, false, {{"20,15", 20.15}});
    expectSizes(SizeKind::Trunk, false, {{"20,15", 25}, {"12.5,30", 32.5}}, true);
    expectSizes(SizeKind::Height, false, {{"20,15", 20.15}}, true); // a height has no stems
    EXPECT_EQ(commaSeparatesNumbers("12,14,9"), true);
    EXPECT_EQ(commaSeparatesNumbers("12.5,14"), true);
    EXPECT_EQ(commaSeparatesNumbers("0,45"), false);
    EXPECT_EQ(commaSeparatesNumbers("12,05 m"), false);
    for (const char* text : {"", "12", "20, 15", "12,5", "about", ","})
        EXPECT_FALSE(commaSeparatesNumbers(text)) << text;
}

TEST(SizeText, RefusesOtherTexts) {
    expectNone(SizeKind::Height,
               {"",     " ",        "m",        "tall",  "18 kg",  "18 years", "12+14",    "12;14",  "20, 15",
                "3x10", "12-9",     "9-12-15",  "9--12", "5 6",    "1.2.3",    "12,14,9",  "-5 m",   "9-",
                "-",    "+",        ">",        "x",     "12 m 5", "9-12+3",   "<script>", "12-Sep", "nan",
                "inf",  "1/1/2020", "\x80\xff", "~",     "u",      "0u",       "b",        "t6"});
    expectNone(SizeKind::Trunk, {"16/18", "20 15", "12-14-9", "20 + m", "0x10", "1.5x10", "99x10", "30x40"});
    expectNone(SizeKind::Width, {"8x6x4", "12+14"});
}

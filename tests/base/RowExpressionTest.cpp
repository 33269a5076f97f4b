// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/RowExpression.h>
#include <osgTreeWind/system/Memory.h>

#include <gtest/gtest.h>

#ifndef _WIN32
#include <sys/resource.h>
#endif

#include <ctime>
#include <tuple>

using namespace osgTreeWind;

namespace {

struct OneRow final : RowCells {
    explicit OneRow(std::vector<std::string> cells) : cells(std::move(cells)) {}
    std::string text(std::size_t column) const override { return cells[column]; }
    std::optional<double> number(std::size_t column) const override { return parseNumber(cells[column]); }
    std::vector<std::string> cells;
};

const std::vector<std::string> columns = {"height", "kind", "status", "Höhe (m)"};
const std::string file = "f.csv";

Result<RowExpression> condition(const std::string& text) {
    return RowExpression::parse(text, columns, file, RowExpression::Kind::Condition);
}

bool matches(const std::string& text, const OneRow& row) {
    const Result<RowExpression> filter = condition(text);
    EXPECT_TRUE(filter) << text.substr(0, 100) << ": " << firstProblem(filter);
    return filter && filter.value().matches(row).value();
}

RowExpression::Value valueOf(const std::string& text, const OneRow& row) {
    const Result<RowExpression> expression = RowExpression::parse(text, columns, file);
    EXPECT_TRUE(expression) << text << ": " << firstProblem(expression);
    return expression ? expression.value().evaluate(row).value() : RowExpression::Value();
}

} // namespace

TEST(RowExpression, EvaluatesConditionsLikeSql) {
    const OneRow row({"12.5", "Quercus robur", "", "7"});
    for (const char* const yes : {"height > 3",
                                  "height>=12.5",
                                  "height = 12.50",
                                  "12 < height",
                                  "height <> 3",
                                  "height != 3",
                                  "height < 1e2",
                                  "height > -1e-3",
                                  "kind = 'Quercus robur'",
                                  "kind LIKE 'quercus%'",
                                  "kind like '%ROB_R'",
                                  "kind NOT LIKE 'Acer%'",
                                  "status IS NULL",
                                  "kind IS NOT NULL",
                                  "height IN (1, 12.5)",
                                  "kind NOT IN ('Acer', 'Tilia')",
                                  "height BETWEEN 10 AND 13",
                                  "height NOT BETWEEN 13 AND 20",
                                  "height BETWEEN 10 AND 13 AND kind = 'Quercus robur'",
                                  "NOT height < 3",
                                  "height < 3 OR (kind LIKE '%robur' AND \"Höhe (m)\" = 7)",
                                  "kind <> 'it''s'",
                                  "height < 3 AND status = 'x' OR height > 3",
                                  "NOT (height < 3 AND status = 'alive')",
                                  "\"height\" > \"Höhe (m)\"",
                                  "status = 'alive' OR height > 3",
                                  "kind > 'A'"})
        EXPECT_TRUE(matches(yes, row)) << yes;
    for (const char* const no :
         {"height < 3", "kind = 'quercus robur'", "status = 'alive'", "status <> 'alive'",
          "NOT status = 'alive'", "status IS NOT NULL", "status IN ('a')", "status NOT IN ('a')",
          "height IN (1, 2)", "kind LIKE 'robur'", "height > 3 AND status = 'alive'", "kind LIKE '%%%x'",
          "status LIKE '%'", "height BETWEEN 13 AND 10"})
        EXPECT_FALSE(matches(no, row)) << no;
}

TEST(RowExpression, ReportsThePositionOfErrors) {
    for (const auto& [text, place, part] :
         {std::tuple("", "1", "expected an expression of SQL, found nothing"),
          {"height", "7", "expected a condition such as height > 3"},
          {"height > 3 kind", "12", "expected an expression of SQL, found 'kind'"},
          {"height > 'x", "10", "a ' at its end"},
          {"hight > 3", "1", "\"hight\" in f.csv; did you mean \"height\"?"},
          {"height > (SELECT 1)", "11", "found 'SELECT'"},
          {"height > 3; DROP TABLE x", "11", "found ';'"},
          {"height NOT = 3", "12", "found '='"},
          {"kind LIKE", "10", "found nothing"},
          {"(height > 3", "12", "expected ), found nothing"},
          {"height > 3) AND (kind = 'a'", "11", "expected the end, found ')'"},
          {"height > rund(3)", "10", "no function \"rund\"; did you mean \"round\"?"},
          {"height > max(3)", "1", "max() need"},
          {"round() > 3", "1", "wrong number of arguments to function round()"}})
        EXPECT_TRUE(isProblem(firstProblem(condition(text)), std::string("at character ") + place, part));
    EXPECT_EQ(firstProblem(RowExpression::parse("Hohe (m)", columns, file)),
              "at character 1: no function \"Hohe\"");
    EXPECT_EQ(firstProblem(RowExpression::parse("2 * hight", columns, file)),
              "at character 5: no column \"hight\" in f.csv; did you mean \"height\"?");
    EXPECT_EQ(firstProblem(RowExpression::parse("hight", columns, file)),
              "no column \"hight\" in f.csv; did you mean \"height\"?");
}

TEST(RowExpression, ComputesValues) {
    const OneRow row({"12.5", "Tilia", "", "007"});
    for (const auto& [text, number] : {std::pair("2 * height", 25.0),
                                       {"height + 1e-1", 12.6},
                                       {"7 / 2 + 0 * height", 3.5},
                                       {"height / 5 / 2", 1.25},
                                       {"0.3048 * height * sin(radians(30))", 1.905},
                                       {"CASE kind WHEN 'Tilia' THEN 5 ELSE height END", 5.0},
                                       {"coalesce(status, height)", 12.5},
                                       {"\"Höhe (m)\" * 2", 14.0},
                                       {"\"Höhe (m)\" = 7", 1.0},
                                       {"CAST(substr(\"Höhe (m)\", 2, 2) AS INTEGER)", 7.0}}) {
        const RowExpression::Value value = valueOf(text, row);
        ASSERT_TRUE(value.number) << text;
        EXPECT_NEAR(*value.number, number, 1e-12) << text;
    }
    for (const auto& [text, expected] : {std::pair("kind || ' ' || 'cordata'", "Tilia cordata"),
                                         {"kind || status", ""},
                                         {"kind || coalesce(' ' || status, '')", "Tilia"},
                                         {"kind || \"Höhe (m)\"", "Tilia007"},
                                         {"kind * 2", ""}, // no number
                                         {"upper(kind)", "TILIA"},
                                         {"kind || 3", "Tilia3"},
                                         {"1e300 * height * 1e300", "Inf"}}) {
        EXPECT_EQ(valueOf(text, row).text, expected) << text;
        EXPECT_FALSE(valueOf(text, row).number) << text;
    }
}

TEST(RowExpression, TakesColumnsByTheirExactNames) {
    const std::vector<std::string> names = {"H", "h", "natural", "addr:street", "rowid", "2020", "c0"};
    const OneRow row({"1", "2", "tree", "x", "", "6", "7"});
    const auto value = [&](const std::string& text) {
        const Result<RowExpression> expression = RowExpression::parse(text, names, file);
        return expression ? expression.value().evaluate(row).value().text : firstProblem(expression);
    };
    EXPECT_EQ(value("H || h"), "12");
    EXPECT_EQ(value("natural || addr:street"), "treex");
    EXPECT_EQ(value("coalesce(rowid, 'none')"), "none");
    EXPECT_EQ(value("\"2020\" + 2020"), "2026");
    EXPECT_EQ(value("c0 - H"), "6");
    for (const char* const none : {"n0", "oid", "none", "cells", "H.h", "\"x\"", "true", "2 * 3", "12"})
        EXPECT_TRUE(hasPart(value(none), "no column")) << none;
}

// Processor time, but on Windows the time of day, which other programs lengthen.
#ifdef _WIN32
static constexpr std::clock_t soon = 30 * CLOCKS_PER_SEC;
#else
static constexpr std::clock_t soon = CLOCKS_PER_SEC;
#endif

TEST(RowExpression, RefusesAllButExpressions) {
    const std::clock_t start = std::clock();
    for (const char* const text :
         {"height > random()",
          "height > length(randomblob(1000000000))",
          "length(zeroblob(1000000000)) > height",
          "load_extension('x') = height",
          "height > julianday('now')",
          "kind < date('now')",
          "kind < CURRENT_TIMESTAMP",
          "EXISTS (SELECT 1)",
          "height IN (WITH RECURSIVE r(x) AS (VALUES(1) UNION ALL SELECT x + 1 FROM r) SELECT x FROM r)",
          "height IN (VALUES (1))",
          "height IN cells",
          "1); ATTACH 'x.db' AS x; SELECT (1",
          "1) UNION SELECT (1",
          "1) LIMIT (0",
          "PRAGMA temp_store",
          "ATTACH 'x.db' AS x",
          "readfile('/etc/passwd') = kind",
          "writefile('x', 'y') = height",
          "sqlite_version() = kind",
          "printf('%1000000000d', 1) = kind",
          "format('%1000000000d', 1) = kind",
          "count(*) > height",
          "sum(height) > 1",
          "max(height, 1) OVER () > 1",
          "height > ?1",
          "height > :x",
          "height > $x",
          "kind -- > 3",
          "kind /* > 3",
          "kind REGEXP 'a'",
          "kind MATCH 'a'",
          "kind -> 'a' = 'b'",
          "height > 3 COLLATE x",
          "[height] > 3",
          "`height` > 3",
          "raise(ABORT, 'x')"})
        EXPECT_FALSE(condition(text)) << text;
    EXPECT_LT(std::clock() - start, soon);
}

/// Memory of the process, MB: at its peak, or on Windows now.
static double peakMegabytes() {
#ifdef _WIN32
    return residentBytes() / 0x1p20;
#else
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
#endif
}

TEST(RowExpression, LimitsDepthLengthAndTime) {
    const OneRow row({"1", std::string(20000, 'a'), "b", "c"});
    const double before = peakMegabytes();
    const std::clock_t start = std::clock();
    EXPECT_FALSE(condition(std::string(60, '(') + "height > 3" + std::string(60, ')')));
    EXPECT_FALSE(condition(std::string(90000, '(') + "height > 3"));
    EXPECT_FALSE(condition(std::string(90000, '-') + "height > 3"));
    EXPECT_FALSE(matches("kind LIKE '%a%a%a%a%a%a%a%a%a%a%b'", row));
    EXPECT_FALSE(condition("height > " + std::string(200000, '1')));
    std::string nots, many = "height > 3", bomb = "kind";
    for (int i = 0; i < 20000; ++i) {
        nots += "NOT ";
        many += " OR height > 3";
    }
    EXPECT_FALSE(condition(nots + "height > 3"));
    EXPECT_FALSE(condition(many));
    for (int i = 0; i < 20; ++i)
        bomb = "replace(" + bomb + ", 'a', 'aa')";
    const auto growing = RowExpression::parse(bomb, columns, file);
    ASSERT_TRUE(growing);
    EXPECT_TRUE(hasPart(firstProblem(growing.value().evaluate(row)), "texts of at most 32768 bytes"));
    EXPECT_LT(std::clock() - start, soon);
    EXPECT_LT(peakMegabytes() - before, 100.0);
}

TEST(RowExpression, StopsSlowEvaluations) {
    const OneRow row({"1", std::string(32000, 'a'), "b", "c"});
    const std::string slow = "kind LIKE '%" + std::string(190, 'a') + "b%'";
    std::string all = slow;
    for (int i = 0; i < 400; ++i)
        all += " OR " + slow;
    const auto filter = condition(all);
    ASSERT_TRUE(filter) << firstProblem(filter);
    const std::clock_t start = std::clock();
    Result<bool> result = false;
    for (int i = 0; i < 1000 && result; ++i)
        result = filter.value().matches(row);
    EXPECT_TRUE(hasPart(firstProblem(result), "takes too long"));
    EXPECT_LT(std::clock() - start, soon);
}

TEST(RowExpression, SelectsFromLongLists) {
    std::string many = "height IN (0";
    for (int i = 2; i < 10000; ++i)
        many += ", " + std::to_string(i);
    EXPECT_FALSE(matches(many + ")", OneRow({"1", "", "", ""})));
    EXPECT_TRUE(matches(many + ")", OneRow({"9999", "", "", ""})));
}

// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/io/RowFilter.h>
#include <osgTreeWind/io/TreeRows.h>

#include <gtest/gtest.h>

#include <tuple>

using namespace osgTreeWind;

namespace {

/// A single row.
class OneRow final : public TreeRows {
public:
    explicit OneRow(std::vector<std::string> cells) : _cells(std::move(cells)) {}

    const std::string& file() const override { return _file; }
    const std::string& format() const override { return _file; }
    const std::vector<std::string>& columns() const override { return _columns; }
    const std::optional<Crs>& crs() const override { return _crs; }
    bool hasPlaces() const override { return false; }
    bool has(std::size_t column) const override { return !_cells[column].empty(); }
    std::string text(std::size_t column) const override { return _cells[column]; }
    std::optional<double> number(std::size_t column) const override { return parseNumber(_cells[column]); }
    Result<VectorPlace> place() const override { return VectorPlace(); }
    Diagnostic problem(const std::string&, const std::string& message) const override {
        return fileProblem(_file, message);
    }

private:
    void restart(const CrsTransform&, std::vector<std::size_t>) override {}
    Result<bool> advance() override { return true; }

    std::vector<std::string> _cells, _columns = {"height", "kind", "status", "Höhe (m)"};
    std::string _file = "f.csv";
    std::optional<Crs> _crs;
};

bool matches(const std::string& condition, const OneRow& row) {
    const Result<RowFilter> filter = RowFilter::parse(condition, row);
    EXPECT_TRUE(filter) << condition << ": " << firstProblem(filter);
    return filter && filter.value().matches(row);
}

} // namespace

TEST(RowFilter, EvaluatesConditionsLikeSql) {
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

TEST(RowFilter, ReportsThePositionOfErrors) {
    const OneRow row({"1", "a", "b", "c"});
    for (const auto& [condition, place, part] :
         {std::tuple("", "1", "expected a column, a number or a text in '...', found nothing"),
          {"height", "7", "BETWEEN or IS NULL, found nothing"},
          {"height > 3 kind", "12", "AND, OR or the end, found 'kind'"},
          {"height > 'x", "10", "a ' at its end"},
          {"hight > 3", "1", "\"hight\" in f.csv; did you mean \"height\"?"},
          {"height > (SELECT 1)", "10", "found '('"},
          {"height > 3; DROP TABLE x", "11", "found ';'"},
          {"height NOT = 3", "12", "IN, LIKE or BETWEEN, found '='"},
          {"kind LIKE kind", "11", "a text in '...', found 'kind'"},
          {"(height > 3", "12", "expected ), found nothing"}})
        EXPECT_TRUE(isProblem(firstProblem(RowFilter::parse(condition, row)),
                              std::string("at character ") + place, part));
}

TEST(RowFilter, LimitsDepthAndTime) {
    const OneRow row({"1", std::string(20000, 'a'), "b", "c"});
    EXPECT_FALSE(RowFilter::parse(std::string(100000, '(') + "height > 3", row));
    EXPECT_FALSE(matches("kind LIKE '%a%a%a%a%a%a%a%a%a%a%b'", row));
    std::string many = "height > 3";
    for (int i = 0; i < 20000; ++i)
        many += " OR height > 3";
    EXPECT_FALSE(matches(many, row));
}

// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/base/FirstProblem.h>

#include <osgTreeWind/base/CsvTable.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace osgTreeWind;

namespace {

using Cells = std::vector<std::string>;

Result<CsvTable> read(const std::string& content, char delimiter = ',') {
    std::istringstream input(content);
    return readCsvTable(input, "t.csv", delimiter);
}

} // namespace

TEST(CsvTable, ReadsHeaderAndRows) {
    const auto table = read("a,b\n1,2\n3,4\n");
    ASSERT_TRUE(table) << firstProblem(table);
    EXPECT_EQ(table.value().file, "t.csv");
    EXPECT_EQ(table.value().columns, (Cells{"a", "b"}));
    ASSERT_EQ(table.value().rows.size(), 2u);
    EXPECT_EQ(table.value().rows[1].cells, (Cells{"3", "4"}));
    EXPECT_EQ(table.value().rows[1].line, 3);
}

TEST(CsvTable, LastLineNeedsNoLineEnd) {
    EXPECT_EQ(read("a\n1").value().rows.at(0).cells, Cells{"1"});
}

TEST(CsvTable, HeaderWithoutRowsIsValid) {
    EXPECT_TRUE(read("a,b").value().rows.empty());
}

TEST(CsvTable, HeaderNamesAreTrimmedAndTheByteOrderMarkIsSkipped) {
    EXPECT_EQ(read("\xEF\xBB\xBF x , \"y\" \n1,2\n").value().columns, (Cells{"x", "y"}));
}

TEST(CsvTable, RejectsTooManyColumns) {
    std::string header = "c0";
    for (int i = 1; i < 200000; ++i)
        header += ",c" + std::to_string(i);
    EXPECT_EQ(firstProblem(read(header + "\n")), "t.csv:1: expected at most 10000 columns, found 200000");
}

TEST(CsvTable, QuotedCellsKeepDelimitersQuotesAndLineEnds) {
    const auto table = read("a,b\n\"x,\"\"y\"\"\",\"1\n2\"\n");
    ASSERT_TRUE(table) << firstProblem(table);
    EXPECT_EQ(table.value().rows[0].cells, (Cells{"x,\"y\"", "1\n2"}));
}

TEST(CsvTable, LineNumbersCountQuotedLineEnds) {
    const auto table = read("a,b\n\"1\n\n2\",3\n4,5\n");
    ASSERT_TRUE(table) << firstProblem(table);
    EXPECT_EQ(table.value().rows[0].line, 2);
    EXPECT_EQ(table.value().rows[1].line, 5);
}

TEST(CsvTable, AcceptsAllLineEnds) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const auto table = read(std::string("a,b") + end + "1,2" + end + end + "3,4" + end);
        ASSERT_TRUE(table) << firstProblem(table);
        ASSERT_EQ(table.value().rows.size(), 2u);
        EXPECT_EQ(table.value().rows[0].line, 2);
        EXPECT_EQ(table.value().rows[1].line, 4);
        EXPECT_EQ(table.value().rows[1].cells, (Cells{"3", "4"}));
    }
}

TEST(CsvTable, KeepsEmptyCells) {
    EXPECT_EQ(read("a,b,c\n,,\n").value().rows.at(0).cells, (Cells{"", "", ""}));
}

TEST(CsvTable, AcceptsOtherDelimiters) {
    EXPECT_EQ(read("a\tb\n\t2\n", '\t').value().rows.at(0).cells, (Cells{"", "2"}));
    EXPECT_EQ(read("a;b\n1,5;2\n", ';').value().rows.at(0).cells, (Cells{"1,5", "2"}));
}

TEST(CsvTable, FindsColumnsByExactName) {
    const auto table = read("x,X\n1,2\n");
    EXPECT_EQ(table.value().column("X"), 1u);
    EXPECT_FALSE(table.value().column("y"));
}

TEST(CsvTable, BadNumberIsReportedWithLineColumnAndText) {
    const auto table = read("x,y\n1.5,n/a\n");
    const CsvTable& t = table.value();
    EXPECT_EQ(t.number(t.rows[0], 0).value(), 1.5);
    EXPECT_EQ(firstProblem(t.number(t.rows[0], 1)), "t.csv:2: y: expected a number, found 'n/a'");
}

struct BadCsv {
    const char* name;
    std::string content;
    char delimiter;
    const char* problem;
};

void PrintTo(const BadCsv& bad, std::ostream* out) {
    *out << bad.name;
}

class CsvTableRefuses : public testing::TestWithParam<BadCsv> {};

TEST_P(CsvTableRefuses, BadInputWithLocationAndReason) {
    EXPECT_EQ(firstProblem(read(GetParam().content, GetParam().delimiter)), GetParam().problem);
}

INSTANTIATE_TEST_SUITE_P(
    Table, CsvTableRefuses,
    testing::Values(
        BadCsv{"Empty", "", ',', "t.csv: the file is empty"},
        BadCsv{"Blank", "\n \n", ',', "t.csv:1: expected a header row, found only blank lines"},
        BadCsv{"ShortRow", "a,b\n1,2\n3\n", ',', "t.csv:3: expected 2 cells as in the header, found 1"},
        BadCsv{"LongRow", "a,b\n\n1,2,3\n", ',', "t.csv:3: expected 2 cells as in the header, found 3"},
        BadCsv{"RaggedAfterQuotedLineEnd", "a,b\n\"x\ny\",2\n1\n", ',',
               "t.csv:4: expected 2 cells as in the header, found 1"},
        BadCsv{"OpenQuote", "a,b\n1,2\n3,\"4\n5,6\n", ',', "t.csv:3: quotation mark is never closed"},
        BadCsv{"TextAfterQuote", "a,b\n\"1\"2,3\n", ',',
               "t.csv:2:4: misplaced quotation mark; expected \"\" inside quotes"},
        BadCsv{"Nul", std::string("a,b\n1,\0002\n", 9), ',', "t.csv:2:3: expected text, found binary data"},
        BadCsv{"QuoteAsDelimiter", "a,b\n", '"',
               "t.csv: delimiter: expected a character that can separate cells, such as , ; or a tab"},
        BadCsv{"NulAsDelimiter", "a,b\n", '\0',
               "t.csv: delimiter: expected a character that can separate cells, such as , ; or a tab"}),
    [](const auto& info) { return info.param.name; });

TEST(CsvTable, ReportsRaggedRowsOnce) {
    const auto table = read("a,b\n1\n1,2\n1,2,3\n");
    ASSERT_FALSE(table);
    ASSERT_EQ(table.problems().size(), 1u);
    EXPECT_EQ(firstProblem(table), "t.csv:2: expected 2 cells as in the header, found 1, as in 1 more rows");
}

TEST(CsvTable, AQuoteWithinACellIsPartOfIt) {
    for (const char* const cell : {"60' 5\" est.", "6\"", "a \"b\" c", "5\"\"", "x\"\"\"y"})
        EXPECT_EQ(read(std::string("a,b\n1,") + cell + "\n\"3\",4\n").value().rows.at(0).cells,
                  (Cells{"1", cell}));
}

TEST(CsvTable, ReadsNumbersInGroups) {
    const CsvFormat points(';'), commas(';', true);
    for (const char* const text : {"2'600'100.5", "2 600 100.5", "2\u00a0600\u00a0100.5",
                                   "2\u202f600\u202f100.5", "2\u2019600\u2019100.5"})
        EXPECT_EQ(points.groupedNumberOf(text), 2600100.5) << text;
    EXPECT_EQ(commas.groupedNumberOf(" -6\u202f862\u202f300,25 "), -6862300.25);
    EXPECT_EQ(points.groupedNumberOf("12 345"), 12345.0);
    for (const char* const text : {"", "12", "12.5", "12 34", "1234 567", "12 345 67", "1'234 567", "1 234,5",
                                   "a 123", "12 345 m", "-", "'123", "12 3456", "--1 234"})
        EXPECT_FALSE(points.groupedNumberOf(text)) << text;
}

TEST(CsvTable, TruncatedInputGivesATableOrAProblem) {
    const std::string content = "\xEF\xBB\xBF\"a\",b\r\n\"x\r\n\"\"y\",2\r\n3,4\r\n";
    for (std::size_t length = 0; length <= content.size(); ++length) {
        const auto table = read(content.substr(0, length));
        if (table) {
            for (const auto& row : table.value().rows)
                EXPECT_EQ(row.cells.size(), table.value().columns.size()) << length;
        } else {
            EXPECT_FALSE(firstProblem(table).empty()) << length;
        }
    }
}

TEST(CsvTable, ReadsRealCampusTrees) {
    REQUIRE_REAL_DATA(path, "utah_campus/utah_campus_trees.csv");
    std::ifstream file(path);
    const auto table = readCsvTable(file, path);
    ASSERT_TRUE(table) << firstProblem(table);
    const CsvTable& trees = table.value();
    EXPECT_EQ(trees.rows.size(), 1233u);
    EXPECT_EQ(trees.columns.size(), 8u);
    EXPECT_EQ(trees.number(trees.rows[0], *trees.column("x")).value(), 428759.19);
    EXPECT_EQ(trees.rows[0].line, 2);
    EXPECT_EQ(trees.rows.back().line, 1234);
}

TEST(CsvTable, ReadsRealTablesWithQuotedCommasAndTabs) {
    REQUIRE_REAL_DATA(sway, "sway/NaturalFrequencies_FieldData.csv");
    REQUIRE_REAL_DATA(species, "species/species_parameters_1.txt");
    std::ifstream commas(sway), tabs(species);
    EXPECT_EQ(firstProblem(readCsvTable(commas, sway)), "");
    EXPECT_EQ(firstProblem(readCsvTable(tabs, species, '\t')), "");
}

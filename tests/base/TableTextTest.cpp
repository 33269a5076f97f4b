// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/base/IsProblem.h>

#include <osgTreeWind/base/RowExpression.h>
#include <osgTreeWind/base/TableText.h>
#include <osgTreeWind/base/Text.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace osgTreeWind;

namespace {

/// The header and the rows of a table, a line each, with "|" between cells.
std::string rowsIn(const std::string& bytes, const TableOptions& options) {
    const Result<TableText> text = decodeTable(bytes, "t.csv", options);
    if (!text)
        return firstProblem(text);
    std::string rows;
    const auto add = [&](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            rows += (i == 0 ? "" : "|") + cells[i];
        rows += '\n';
    };
    const Result<CsvTable> table =
        readCsvRows(text.value().text, "t.csv", text.value().format,
                    [&](const CsvTable&, const CsvTable::Row& row) { add(row.cells); });
    if (!table)
        return firstProblem(table);
    const std::string below = std::move(rows);
    rows.clear();
    add(table.value().columns);
    return rows + below;
}

TableOptions asking(std::vector<std::string> columns) {
    TableOptions options;
    options.columns = std::move(columns);
    return options;
}

const std::string table = "id|x|y\n1|2.5|3\n2|4|5\n";

} // namespace

/// The same table, as programs write it around, between or beside its cells.
TEST(TableText, FindsATableInItsSurroundings) {
    for (const char* const text : {"id,x,y\n1,2.5,3\n2,4,5\n",
                                   "City trees\nExported: 2024, March\n\nid,x,y\n1,2.5,3\n2,4,5\n",
                                   "City trees,,\n,,\nid,x,y\n1,2.5,3\n2,4,5\n",
                                   "# city, trees\n# 2024\nid,x,y\n1,2.5,3\n# felled\n2,4,5\n",
                                   "% a\nid,x,y\n1,2.5,3\n2,4,5\n",
                                   "sep=;\nid;x;y\n1;2,5;3\n2;4;5\n",
                                   "\"sep=;\"\nid;x;y\n1;2.5;3\n2;4;5\n",
                                   "id,x,y\n1,2.5,3,\n2,4,5,\n",
                                   "id,x,y\n1,2.5,3,,\n2,4,5\n",
                                   "City\nid,x,y\n1,2.5,3,\n2,4,5,\n",
                                   "id x y\n1 2.5 3\n2 4 5\n",
                                   "  id    x  y \n   1  2.5  3\n\n  2  4    5  \n",
                                   "id\tx\ty\n1\t2.5\t3\n2\t4\t5\n",
                                   "id|x|y\n1|2.5|3\n2|4|5\n",
                                   "#id x y\n#- m m\n1 2.5 3\n2 4 5\n",
                                   "# id,x,y\n1,2.5,3\n2,4,5\n",
                                   "#Software: S\n#Fields: id x y\n1 2.5 3\n2 4 5\n",
                                   "\"City\" trees, 2024\nid,x,y\n1,2.5,3\n2,4,5\n",
                                   "City,\"trees\nid,x,y\n1,2.5,3\n2,4,5\n",
                                   "id,x,y\n,m,m\n1,2.5,3\n2,4,5\n",
                                   "id,x,y\n--,---,-\n1,2.5,3\n2,4,5\n",
                                   "name,place,zone,height,owner\nA,B,0,8,C\n\nid,x,y\n1,2.5,3\n2,4,5\n"})
        for (const auto& columns : {std::vector<std::string>(), {"id", "x"}, {"y"}, {"2 * y"}}) {
            if (columns.empty() && std::string(text).substr(0, 5) == "name,")
                continue; // two tables of two lines each
            std::string rows = rowsIn(text, asking(columns));
            std::replace(rows.begin(), rows.end(), ',', '.');
            EXPECT_EQ(rows, table) << text;
        }
}

TEST(TableText, KeepsRowsWithoutNamesForAllCells) {
    EXPECT_EQ(rowsIn("x,y,\n1,2\n3,4,a\n", {}), "x|y|\n1|2|\n3|4|a\n");
    EXPECT_EQ(rowsIn("x,y\n", asking({"x"})), "x|y\n");
}

TEST(TableText, PrefersTheLineWithMostOfTheColumns) {
    const std::string text = "x,id,zone\n9,8,7\nx,y,z\n1,2,3\n";
    EXPECT_EQ(rowsIn(text, asking({"x", "y"})), "x|y|z\n1|2|3\n");
    EXPECT_EQ(rowsIn(text, asking({"x"})), "x|id|zone\n9|8|7\nx|y|z\n1|2|3\n");
}

TEST(TableText, SaysWhatItAssumes) {
    const auto notes = [](const std::string& text) {
        return decodeTable(text, "t.csv", asking({"x", "y"})).value().notes;
    };
    using Notes = std::vector<std::string>;
    EXPECT_EQ(notes("x,y\n1,2\n"), Notes());
    EXPECT_EQ(notes("sep=;\nx;y\n1;2\n"), Notes());
    EXPECT_EQ(notes("City\nx,y\n1,2\n"), Notes{"line 2 is taken for the header (header_line sets another)"});
    EXPECT_EQ(notes("\n\"a\"b\nx,y\n1,2\n"),
              Notes{"line 3 is taken for the header (header_line sets another)"});
    EXPECT_EQ(notes("\nx,y\n1,2\n"), Notes());
    EXPECT_EQ(notes("x,y\nm,m/s\n1,2\n"), Notes{"line 2, \"m, m/s\", has no digits and can only give units"});
    EXPECT_EQ(notes("x  y\n1 2\n"),
              Notes{"its cells are separated by blanks, and its numbers may have decimal commas"});
    EXPECT_EQ(notes("x,y\n1,2,\n2,3,\n"), Notes());
}

TEST(TableText, CountsCommentsBetweenRows) {
    const auto table =
        readCsvRows("x,y\n#1,2\n# moved\n3,4\n// end\n", "t.csv", ',', [](const auto&, auto&) {});
    EXPECT_EQ(table.value().commentCount, 2u);
    EXPECT_EQ(rowsIn("x,y\n#1,2\n# moved\n3,4\n", {}), "x|y\n#1|2\n3|4\n");
}

TEST(TableText, FollowsItsOptions) {
    TableOptions options = asking({"1"});
    options.headerLine = 0;
    EXPECT_EQ(rowsIn("Q,+5.0,\nQ,+5.1,\n", options), "1|2|3\nQ|+5.0|\nQ|+5.1|\n");
    options = asking({"x"});
    options.headerLine = 3;
    EXPECT_EQ(rowsIn("x,y\n1,2\nx,z\n3,4\n", options), "x|z\n3|4\n");
    options = asking({"x"});
    options.comment = "(";
    EXPECT_EQ(rowsIn("(a)\nx,y\n(1,2)\n3,4\n(1 row)\n", options), "x|y\n3|4\n");
    options = asking({"a b"});
    options.delimiter = '|';
    EXPECT_EQ(rowsIn("a b|c d\n1|2\n", options), "a b|c d\n1|2\n");
    options.delimiter = ' ';
    options.columns = {"a,b"};
    EXPECT_EQ(rowsIn("a,b \"c d\"\n1,5 \"e  f\"\n", options), "a,b|c d\n1,5|e  f\n");
}

/// R writes one name less than cells, and quotes texts.
TEST(TableText, ReadsTablesOfR) {
    EXPECT_EQ(rowsIn("\"sp\" \"x\"\n\"1\" \"Picea abies\" 10.5\n\"2\" \"Abies alba\" 3\n", asking({"sp"})),
              "|sp|x\n1|Picea abies|10.5\n2|Abies alba|3\n");
    EXPECT_EQ(rowsIn("\"sp\",\"x\"\n\"1\",\"Abies alba\",3\n", {}), "|sp|x\n1|Abies alba|3\n");
    EXPECT_TRUE(hasPart(rowsIn("id,x\n1,2.5,ill\n2,3.5,well\n", asking({"x"})), "expected 2 cells"));
}

/// Forms of the NDBC and of KNMI, with own values.
TEST(TableText, ReadsHeadersInComments) {
    const std::string
        buoy = "#YY  MM DD WDIR WSPD\n#yr  mo dy degT m/s\n2024 01 22 270  9.5\n2024 01 23 265 11.0\n",
        rows = "|MM|DD|WDIR|WSPD\n2024|01|22|270|9.5\n2024|01|23|265|11.0\n";
    EXPECT_EQ(rowsIn(buoy, asking({"YY", "WDIR"})), "YY" + rows);
    EXPECT_EQ(rowsIn(buoy, asking({"#YY", "WDIR"})), "#YY" + rows);
    EXPECT_EQ(rowsIn(buoy, {}), "YY" + rows);
    EXPECT_EQ(rowsIn("# DD = direction (degrees), 360=north\n# FH = speed, .1 m/s\n#\n# STN,DD,   FH\n#\n"
                     "  260,  200,   50\n  260,  210,   60\n",
                     asking({"DD", "0.1 * FH"})),
              "STN|DD|FH\n260|200|50\n260|210|60\n");
    EXPECT_EQ(rowsIn("\"Plot: 3\"\n\"#\",\"Time, GMT\",\"Speed, m/s\"\n1,10:00,5\n2,10:10,6\n",
                     asking({"Time, GMT", "Speed, m/s"})),
              "|Time, GMT|Speed, m/s\n1|10:00|5\n2|10:10|6\n");
}

TEST(TableText, NumbersNamesThatComeTwice) {
    EXPECT_EQ(rowsIn("id,x,id\n1,2,3\n", asking({"x"})), "id [1]|x|id [3]\n1|2|3\n");
}

TEST(TableText, ExplainsWhatItCannotFind) {
    const std::string keys =
        "; to read it otherwise, set header_line (0: no header), comment (how lines begin that "
        "are left out) or delimiter in [inventory], or in a [wind] of kind \"series\"";
    EXPECT_EQ(rowsIn("Q,+5.0,00\nQ,+5.1,01\n", asking({"u", "v"})),
              "t.csv:1: expected a header with \"u\" or \"v\", found \"Q, +5.0, 00\"" + keys);
    EXPECT_EQ(rowsIn("Speed,Dir\n5,200\n", asking({"Sped"})),
              "t.csv:1: expected a header with \"Sped\", found \"Speed, Dir\"; did you mean \"Speed\"?" +
                  keys);
    EXPECT_EQ(
        rowsIn("City\nid,x,y,z\n1,2,3\n2,3,4\n3,4,5\n", asking({"x"})),
        "t.csv:3: expected 4 cells as in the header, found 3, as in 2 more rows; line 2 is taken for the "
        "header, \"id, x, y, z\"" +
            keys);
    EXPECT_EQ(rowsIn("id,x,y,z\n1,2,3\n2,3,4\n", {}),
              "t.csv:2: expected 4 cells as in the header, found 3, as in 1 more rows");
    EXPECT_EQ(problemOfColumn("id", {"id [1]", "x", "id [3]"}, "t.csv"),
              "\"id\" in t.csv may be \"id [1]\", \"id [3]\"");
    EXPECT_TRUE(hasPart(rowsIn("x,y\n\"1\"2,3\n", asking({"x"})), "misplaced quotation mark"));
}

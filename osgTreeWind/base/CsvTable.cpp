// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvTable.h>

#include <osgTreeWind/base/CsvReader.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace osgTreeWind {

namespace {

using Row = CsvTable::Row;

Diagnostics readHeader(const Row& row, CsvTable& table) {
    table.headerLine = row.line;
    table.columns = row.cells;
    constexpr std::size_t maxColumns = 10000; // column() searches linearly
    if (table.columns.size() > maxColumns)
        return {fileProblem(table.file,
                            "expected at most " + std::to_string(maxColumns) + " columns, found " +
                                std::to_string(table.columns.size()),
                            row.line)};
    Diagnostics problems;
    std::set<std::string> names;
    for (const std::string& name : table.columns) {
        if (!name.empty() && !names.insert(name).second)
            problems.push_back({table.file, row.line, 0, name, "the header names this column twice"});
    }
    return problems;
}

/// Parses a number with a decimal comma and full stops as thousands separators.
std::optional<double> parseDecimalComma(std::string text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        return parseNumber(text);
    text[comma] = '.';
    for (std::size_t at = comma; (at = text.rfind('.', at - 1)) < comma && at > 0;)
        text.erase(at, 1);
    return parseNumber(text);
}

bool isNines(std::string_view digits, std::size_t minCount) {
    return digits.size() >= minCount && digits.find_first_not_of('9') == std::string_view::npos;
}

} // namespace

std::optional<double> CsvFormat::numberOf(const std::string& cell) const {
    return decimalComma ? parseDecimalComma(cell) : parseNumber(cell);
}

bool isMissing(std::string_view cell) {
    static const std::set<std::string> markers = {
        "",   "m",   "na",   "n/a",   "nan",     "null",      "none",   "nil", "nodata",
        "-",  "--",  "---",  "/",     "//",      "///",       "?",      "*",   ".",
        "..", "...", "k.a.", "k. a.", "unknown", "unbekannt", "inconnu"};
    if (cell.size() > 20)
        return false;
    return markers.count(lower(std::string(trimmed(cell)))) > 0;
}

bool isMissing(double number) {
    const std::string text = numberText(std::round(std::abs(number) * 1000.0) / 1000.0); // also for floats
    const std::size_t point = std::min(text.find('.'), text.size());
    return isNines(std::string_view(text).substr(0, point), number < 0.0 ? 2 : 3) &&
           (point == text.size() || isNines(std::string_view(text).substr(point + 1), 1));
}

std::optional<std::size_t> CsvTable::column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - columns.begin());
}

Result<double> CsvTable::number(const Row& row, std::size_t column) const {
    const std::string& cell = row.cells[column];
    if (const auto number = format.numberOf(cell))
        return *number;
    return Diagnostic{file, row.line, 0, columns[column], expectedFound("a number", cell)};
}

Result<CsvTable> readCsvRows(std::string_view text, const std::string& file, CsvFormat format,
                             const std::function<void(const CsvTable& table, Row& row)>& onRow) {
    if (std::string_view("\0\"\r\n", 4).find(format.delimiter) != std::string_view::npos)
        return Diagnostic{file, 0, 0, "delimiter",
                          "expected a character that can separate cells, such as , ; or a tab"};

    const Result<std::string_view> plain = plainText(text, file);
    if (!plain)
        return plain.problems();
    CsvTable table;
    table.file = file;
    table.format = format;
    table.headerLine = 0;
    Diagnostics problems;
    CsvReader rows(plain.value(), file, format.delimiter);
    Result<bool> found = rows.next();
    for (; found && found.value(); found = rows.next()) {
        Row& row = rows.row();
        if (table.headerLine == 0)
            problems = readHeader(row, table);
        else if (row.cells.size() != table.columns.size())
            problems.push_back(fileProblem(file,
                                           "expected " + std::to_string(table.columns.size()) +
                                               " cells as in the header, found " +
                                               std::to_string(row.cells.size()),
                                           row.line));
        else if (problems.empty())
            onRow(table, row);
    }
    if (!found)
        return found.problems();
    if (table.headerLine == 0)
        return fileProblem(file, "expected a header row, found only blank lines", 1);
    if (!problems.empty())
        return problems;
    return table;
}

Result<CsvTable> readCsvTable(std::istream& input, const std::string& file, CsvFormat format) {
    const Result<std::string> text = readText(input, file);
    if (!text)
        return text.problems();
    std::vector<Row> rows;
    Result<CsvTable> table = readCsvRows(text.value(), file, format,
                                         [&](const CsvTable&, Row& row) { rows.push_back(std::move(row)); });
    if (table)
        table.value().rows = std::move(rows);
    return table;
}

double CsvCells::number(std::size_t column, const Range& range, const char* expected) {
    const std::optional<double> number = _table.format.numberOf(text(column));
    if (number && range.contains(*number))
        return *number;
    failExpected(column, expected ? expected : "a number " + range.text());
    return 0.0;
}

void CsvCells::failExpected(std::size_t column, const std::string& expected) {
    fail(column, expectedFound(expected, text(column)));
}

void CsvCells::fail(std::size_t column, const std::string& message) {
    if (!_problem)
        _problem = Diagnostic{_table.file, _row.line, 0, _table.columns[column], message};
}

Diagnostics readCsvWithColumns(std::istream& input, const std::string& file,
                               const std::vector<std::string>& columns,
                               const std::function<void(CsvCells& row)>& onRow) {
    const Result<std::string> text = readText(input, file);
    if (!text)
        return text.problems();
    std::optional<Diagnostic> problem;
    const Result<CsvTable> table =
        readCsvRows(text.value(), file, ',', [&](const CsvTable& header, const Row& row) {
            if (problem || header.columns != columns)
                return;
            CsvCells cells(header, row);
            onRow(cells);
            problem = cells.problem();
        });
    if (!table)
        return table.problems();
    if (table.value().columns != columns)
        return {fileProblem(file, "expected the columns " + joined(columns), 1)};
    return problem ? Diagnostics{*problem} : Diagnostics();
}

} // namespace osgTreeWind

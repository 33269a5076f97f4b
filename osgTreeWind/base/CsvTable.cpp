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
#include <cstring>
#include <map>
#include <set>

namespace osgTreeWind {

namespace {

using Row = CsvTable::Row;

std::optional<Diagnostic> readHeader(std::vector<std::string> names, int line, CsvTable& table) {
    table.headerLine = line;
    table.columns = std::move(names);
    constexpr std::size_t maxColumns = 10000; // column() searches linearly
    if (table.columns.size() > maxColumns)
        return fileProblem(table.file,
                           "expected at most " + std::to_string(maxColumns) + " columns, found " +
                               std::to_string(table.columns.size()),
                           line);
    std::map<std::string, std::size_t> counts;
    for (const std::string& name : table.columns)
        ++counts[name];
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (std::string& name = table.columns[i]; counts[name] > 1 && !name.empty())
            name += " [" + std::to_string(i + 1) + ']';
    return std::nullopt;
}

/// Number of bytes of the thousands separator at the beginning of a text; 0 if there is none.
std::size_t separatorSize(std::string_view text) {
    for (const std::string_view separator : {"'", " ", "\u00a0", "\u2009", "\u2019", "\u202f"})
        if (text.substr(0, separator.size()) == separator)
            return separator.size();
    return 0;
}

std::size_t digitCount(std::string_view text) {
    return std::min(text.find_first_not_of("0123456789"), text.size());
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

/// "; line 4 is taken for the header, "id,height"".
std::string headerText(const CsvTable& table) {
    return table.headerLine == 0 ? std::string()
                                 : "; line " + std::to_string(table.headerLine) +
                                       " is taken for the header, " + inQuotes(joined(table.columns));
}

bool isNines(std::string_view digits, std::size_t minCount) {
    return digits.size() >= minCount && digits.find_first_not_of('9') == std::string_view::npos;
}

} // namespace

std::optional<double> CsvFormat::numberOf(const std::string& cell) const {
    return decimalComma ? parseDecimalComma(cell) : parseNumber(cell);
}

std::optional<double> CsvFormat::groupedNumberOf(const std::string& cell) const {
    constexpr std::size_t groupSize = 3;
    std::string_view rest = trimmed(cell);
    const std::size_t begin = rest.find_first_of("0123456789");
    if (begin > 1)
        return std::nullopt;
    const std::size_t first = begin + digitCount(rest.substr(begin));
    std::string digits(rest.substr(0, first));
    rest.remove_prefix(first);
    const std::string_view separator = rest.substr(0, separatorSize(rest));
    while (!separator.empty() && rest.substr(0, separator.size()) == separator &&
           digitCount(rest.substr(separator.size())) == groupSize) {
        digits += rest.substr(separator.size(), groupSize);
        rest.remove_prefix(separator.size() + groupSize);
    }
    if (first - begin > groupSize || digits.size() == first)
        return std::nullopt;
    return numberOf(digits += rest);
}

bool beginsAsComment(const CsvTable::Row& row) {
    const std::string& cell = row.cells.front();
    return !cell.empty() && (std::strchr("#%;", cell.front()) || cell.substr(0, 2) == "//");
}

bool isMissing(std::string_view cell) {
    static const std::set<std::string> markers = {
        "",       "m",  "mm",  "na",   "n/a",   "nan",     "null",      "none",   "nil",
        "nodata", "-",  "--",  "---",  "/",     "//",      "///",       "?",      "*",
        ".",      "..", "...", "k.a.", "k. a.", "unknown", "unbekannt", "inconnu"};
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

std::string CsvTable::commentNote() const {
    return commentCount == 0
               ? std::string()
               : std::to_string(commentCount) +
                     " lines have other numbers of cells, begin with #, %, // or a semicolon, and "
                     "are left out as comments";
}

std::string CsvTable::unitOf(Dimension dimension, std::size_t column) const {
    const std::string cell = column < format.units.size() ? format.units[column] : std::string();
    const std::string named = unitInName(dimension, columns[column]),
                      unit = unitInName(dimension, "x " + cell);
    const bool isText = cell.find_first_not_of("-. ") != std::string::npos;
    return knownUnit(dimension, unit) ? unit : named.empty() && isText ? cell : named;
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
    table.format = std::move(format);
    table.headerLine = 0;
    std::optional<Diagnostic> problem;
    if (!table.format.columns.empty())
        problem = readHeader(table.format.columns, table.format.headerLine, table);
    std::size_t raggedCount = 0, minCells = 0;
    CsvReader rows(plain.value(), file, table.format);
    Result<bool> found = rows.next();
    for (; found && found.value() && (!problem || raggedCount > 0); found = rows.next()) {
        Row& row = rows.row();
        if (table.columns.empty()) {
            problem = readHeader(std::move(row.cells), row.line, table);
            continue;
        }
        if (minCells == 0)
            for (minCells = table.columns.size(); minCells > 1 && table.columns[minCells - 1].empty();)
                --minCells;
        while (row.cells.size() > table.columns.size() && row.cells.back().empty())
            row.cells.pop_back();
        if (row.cells.size() < table.columns.size() && row.cells.size() >= minCells)
            row.cells.resize(table.columns.size());
        if (row.cells.size() == table.columns.size()) {
            if (!problem)
                onRow(table, row);
        } else if (beginsAsComment(row)) {
            ++table.commentCount;
        } else if (raggedCount++ == 0) {
            problem = fileProblem(file,
                                  "expected " + std::to_string(table.columns.size()) +
                                      " cells as in the header, found " + std::to_string(row.cells.size()),
                                  row.line);
        }
    }
    if (!found)
        return found.problems();
    if (table.columns.empty())
        return fileProblem(file, "expected a header row, found only blank lines", table.format.firstLine);
    if (raggedCount > 1)
        problem->message += ", as in " + std::to_string(raggedCount - 1) + " more rows";
    if (raggedCount > 0 && !table.format.hint.empty())
        problem->message += headerText(table) + table.format.hint;
    if (problem)
        return *problem;
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

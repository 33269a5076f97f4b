// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Problem.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <csv.h>

#include <algorithm>
#include <string_view>

namespace osgTreeWind {

namespace {

using Row = CsvTable::Row;

/// libcsv, fed one line of the file at a time so that every row knows its line.
class RowReader {
public:
    /// @param take gets each row in turn.
    RowReader(const std::string& file, char delimiter, std::function<void(Row&)> take)
        : _file(file), _take(std::move(take)) {
        csv_init(&_parser, CSV_STRICT | CSV_STRICT_FINI | CSV_REPALL_NL);
        csv_set_delim(&_parser, static_cast<unsigned char>(delimiter));
    }
    RowReader(const RowReader&) = delete;
    RowReader& operator=(const RowReader&) = delete;
    ~RowReader() { csv_free(&_parser); }

    /// What is wrong with the quotes; empty when all is well.
    Diagnostics read(std::string_view text) {
        for (int line = 1; !text.empty(); ++line) {
            const std::size_t length = lineLength(text);
            if (_rowEnded)
                _row.line = line;
            _rowEnded = false;
            const std::size_t parsed = csv_parse(&_parser, text.data(), length, &onCell, &onRowEnd, this);
            if (parsed != length)
                return {problem(line, static_cast<int>(parsed) + 1,
                                "misplaced quotation mark; expected \"\" inside quotes")};
            text.remove_prefix(length);
        }
        if (csv_fini(&_parser, &onCell, &onRowEnd, this) != 0)
            return {problem(_row.line, 0, "quotation mark is never closed")};
        return {};
    }

private:
    static void onCell(void* cell, std::size_t length, void* self) {
        static_cast<RowReader*>(self)->_row.cells.emplace_back(static_cast<const char*>(cell), length);
    }

    static void onRowEnd(int, void* data) {
        auto& self = *static_cast<RowReader*>(data);
        self._rowEnded = true;
        if (self._row.cells.empty()) // a blank line, or the LF of a CR LF
            return;
        self._take(self._row);
        self._row.cells.clear();
    }

    static std::size_t lineLength(std::string_view text) {
        const std::size_t end = text.find_first_of("\r\n");
        if (end == std::string_view::npos)
            return text.size();
        return text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
    }

    Diagnostic problem(int line, int column, const char* syntax) const {
        const int error = csv_error(&_parser);
        return {_file, line, column, {}, error == CSV_EPARSE ? syntax : csv_strerror(error)};
    }

    const std::string& _file;
    mutable csv_parser _parser; // csv_error takes no const
    std::function<void(Row&)> _take;
    Row _row;
    bool _rowEnded = true;
};

/// The columns that a header row names.
Diagnostics readHeader(const Row& row, CsvTable& table) {
    table.headerLine = row.line;
    table.columns = row.cells;
    Diagnostics problems;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string& name = table.columns[i];
        if (!name.empty() && *table.column(name) != i)
            problems.push_back({table.file, row.line, 0, name, "the header names this column twice"});
    }
    return problems;
}

} // namespace

std::optional<std::size_t> CsvTable::column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - columns.begin());
}

Result<double> CsvTable::number(const Row& row, std::size_t column) const {
    const std::string& cell = row.cells[column];
    if (const auto number = parseNumber(cell))
        return *number;
    return Diagnostic{file, row.line, 0, columns[column], expectedFound("a number", cell)};
}

Result<CsvTable> readCsvRows(std::string_view text, const std::string& file, char delimiter,
                             const std::function<void(const CsvTable& table, Row& row)>& take) {
    if (std::string_view("\0\"\r\n", 4).find(delimiter) != std::string_view::npos)
        return Diagnostic{file, 0, 0, "delimiter",
                          "expected a character that can part cells, such as , ; or a tab"};

    const Result<std::string_view> plain = plainText(text, file);
    if (!plain)
        return plain.problems();
    CsvTable table;
    table.file = file;
    table.headerLine = 0;
    Diagnostics problems;
    RowReader rows(file, delimiter, [&](Row& row) {
        if (table.headerLine == 0)
            problems = readHeader(row, table);
        else if (row.cells.size() != table.columns.size())
            problems.push_back(fileProblem(file,
                                           "expected " + std::to_string(table.columns.size()) +
                                               " cells as in the header, found " +
                                               std::to_string(row.cells.size()),
                                           row.line));
        else if (problems.empty())
            take(table, row);
    });
    if (Diagnostics broken = rows.read(plain.value()); !broken.empty())
        return broken;
    if (table.headerLine == 0)
        return fileProblem(file, "expected a header row, found only blank lines", 1);
    if (!problems.empty())
        return problems;
    return table;
}

Result<CsvTable> readCsvTable(std::istream& input, const std::string& file, char delimiter) {
    const Result<std::string> text = readText(input, file);
    if (!text)
        return text.problems();
    std::vector<Row> rows;
    Result<CsvTable> table = readCsvRows(text.value(), file, delimiter,
                                         [&](const CsvTable&, Row& row) { rows.push_back(std::move(row)); });
    if (table)
        table.value().rows = std::move(rows);
    return table;
}

} // namespace osgTreeWind

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
    RowReader(const std::string& file, char delimiter) : _file(file) {
        csv_init(&_parser, CSV_STRICT | CSV_STRICT_FINI | CSV_REPALL_NL);
        csv_set_delim(&_parser, static_cast<unsigned char>(delimiter));
    }
    RowReader(const RowReader&) = delete;
    RowReader& operator=(const RowReader&) = delete;
    ~RowReader() { csv_free(&_parser); }

    Result<std::vector<Row>> read(std::string_view text) {
        for (int line = 1; !text.empty(); ++line) {
            const std::size_t length = lineLength(text);
            if (_rowEnded)
                _row.line = line;
            _rowEnded = false;
            const std::size_t parsed = csv_parse(&_parser, text.data(), length, &onCell, &onRowEnd, this);
            if (parsed != length)
                return problem(line, static_cast<int>(parsed) + 1,
                               "misplaced quotation mark; expected \"\" inside quotes");
            text.remove_prefix(length);
        }
        if (csv_fini(&_parser, &onCell, &onRowEnd, this) != 0)
            return problem(_row.line, 0, "quotation mark is never closed");
        return std::move(_rows);
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
        self._rows.push_back(std::move(self._row));
        self._row = Row{};
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
    std::vector<Row> _rows;
    Row _row;
    bool _rowEnded = true;
};

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

Result<CsvTable> readCsvTable(std::istream& input, const std::string& file, char delimiter) {
    if (std::string_view("\0\"\r\n", 4).find(delimiter) != std::string_view::npos)
        return Diagnostic{file, 0, 0, "delimiter",
                          "expected a character that can part cells, such as , ; or a tab"};

    const Result<std::string> text = readText(input, file);
    if (!text)
        return text.problems();
    Result<std::vector<Row>> rows = RowReader(file, delimiter).read(text.value());
    if (!rows)
        return rows.problems();
    if (rows.value().empty())
        return fileProblem(file, "expected a header row, found only blank lines", 1);

    CsvTable table;
    table.file = file;
    table.rows = std::move(rows.value());
    const Row header = std::move(table.rows.front());
    table.rows.erase(table.rows.begin());
    table.headerLine = header.line;
    table.columns = header.cells;

    Diagnostics problems;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string& name = table.columns[i];
        if (!name.empty() && *table.column(name) != i)
            problems.push_back({file, header.line, 0, name, "the header names this column twice"});
    }
    for (const Row& row : table.rows)
        if (row.cells.size() != table.columns.size())
            problems.push_back(fileProblem(file,
                                           "expected " + std::to_string(table.columns.size()) +
                                               " cells as in the header, found " +
                                               std::to_string(row.cells.size()),
                                           row.line));
    if (!problems.empty())
        return problems;
    return table;
}

} // namespace osgTreeWind

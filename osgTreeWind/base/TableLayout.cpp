// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/TableLayout.h>

#include <osgTreeWind/base/CsvReader.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace osgTreeWind {

namespace {

using Row = CsvTable::Row;

/// The whole lines at the beginning of a text, up to 64 KiB.
std::string_view firstLines(std::string_view text) {
    constexpr std::size_t maxSize = 1 << 16;
    if (text.size() <= maxSize)
        return text;
    return text.substr(0, std::min(text.find_last_of("\r\n", maxSize), text.size()));
}

/// The rows of a text, comments included. Skips lines with misplaced quotation marks, which titles may have.
std::vector<Row> rowsOf(std::string_view text, char delimiter, int firstLine) {
    constexpr int maxRestarts = 100;
    std::vector<Row> rows;
    for (int restarts = 0; restarts < maxRestarts; ++restarts) {
        CsvFormat format(delimiter);
        format.firstLine = firstLine;
        CsvReader reader(text, {}, format);
        Result<bool> found = reader.next();
        for (; found && found.value(); found = reader.next())
            rows.push_back(std::move(reader.row()));
        if (found)
            break;
        firstLine = found.problems().front().line + 1;
    }
    return rows;
}

bool hasDigit(const Row& row) {
    return std::any_of(row.cells.begin(), row.cells.end(), [](const std::string& cell) {
        return cell.find_first_of("0123456789") != std::string::npos;
    });
}

bool isLastLineQuoted(std::string_view text) {
    text = trimmed(text);
    return text.substr(text.find_last_of("\r\n") + 1).substr(0, 1) == "\"";
}

/// Whether a row is "sep=;", as spreadsheets write and read it.
bool beginsWithSeparator(const Row& row) {
    return row.cells.front().compare(0, 4, "sep=") == 0;
}

/// A comment without its mark, "# STN" or "#STN".
std::string withoutMark(const std::string& cell) {
    return std::string(
        trimmed(std::string_view(cell).substr(std::min(cell.find_first_not_of("#%;/"), cell.size()))));
}

/// Finds the header among rows.
class HeaderSearch {
public:
    /// @param rows of the text.
    HeaderSearch(const std::vector<Row>& rows, std::string_view text, const TableOptions& options,
                 const CsvFormat& format)
        : _rows(rows), _options(options), _format(format), _areQuoted(isLastLineQuoted(text)),
          _begin(positionInText(text, text.find_first_not_of(" \t\r\n")).line) {
        std::map<std::size_t, std::size_t> counts;
        for (const Row& row : rows)
            if (!isComment(row))
                ++counts[row.cells.size()];
        for (const auto& [size, count] : counts)
            if (count >= counts[_width])
                _width = size;
    }

    TableLayout find() {
        TableLayout layout;
        layout.format = _format;
        if (_rows.empty())
            return layout;
        if (_options.headerLine == 0)
            return withoutHeader(std::move(layout));
        std::size_t header = 0;
        for (std::size_t i = 0; i < _rows.size() && !_options.headerLine; ++i)
            if (const std::size_t count = countFound(_rows[i]); count > layout.foundCount) {
                layout.foundCount = count;
                header = i;
            }
        if (_options.headerLine)
            layout.foundCount = countFound(_rows.front());
        else if (layout.foundCount == 0)
            header = findByShape();
        layout.isCertain = layout.foundCount > 0 || (_width > 1 && !hasNumber(_rows[header]));
        setHeader(header, layout);
        return layout;
    }

    /// Usual number of cells in a row.
    std::size_t width() const { return _width; }

private:
    bool isComment(const Row& row) const {
        return beginsAsComment(row) ||
               (!_options.comment.empty() &&
                row.cells.front().compare(0, _options.comment.size(), _options.comment) == 0);
    }
    bool isRow(const Row& row) const { return !isComment(row) && row.cells.size() == _width; }
    bool hasNumber(const Row& row) const {
        return std::any_of(row.cells.begin(), row.cells.end(),
                           [&](const std::string& cell) { return _format.numberOf(cell).has_value(); });
    }

    std::size_t countFound(const Row& row) const {
        return static_cast<std::size_t>(
            std::count_if(_options.columns.begin(), _options.columns.end(), [&](const std::string& name) {
                return std::count(row.cells.begin(), row.cells.end(), name) > 0 ||
                       (beginsAsComment(row) && withoutMark(row.cells.front()) == name);
            }));
    }

    /// Whether all rows after one are like this.
    template <typename Test>
    bool rowsAfter(std::size_t header, Test test) const {
        std::size_t number = 0;
        for (std::size_t i = header + 1; i < _rows.size(); ++i)
            if (isRow(_rows[i]) && !test(_rows[i], ++number))
                return false;
        return number > 0;
    }
    /// Whether the rows begin with quoted numbers, for which R writes no name.
    bool areNumbered(std::size_t header) const {
        return _areQuoted && _rows[header].cells.size() + 1 == _width &&
               rowsAfter(header, [](const Row& row, std::size_t number) {
                   return row.cells.front() == std::to_string(number);
               });
    }
    /// Whether rows have more cells than the header, which are empty.
    bool endInDelimiters(std::size_t header) const {
        const auto size = static_cast<std::ptrdiff_t>(_rows[header].cells.size());
        return _rows[header].cells.size() < _width && rowsAfter(header, [&](const Row& row, std::size_t) {
                   return std::all_of(row.cells.begin() + size, row.cells.end(),
                                      [](const std::string& cell) { return cell.empty(); });
               });
    }

    /// The first row with the usual number of cells, not padded ones, or a shorter row before it, or a
    /// comment before it.
    std::size_t findByShape() const {
        const auto found = std::find_if(_rows.begin(), _rows.end(), [&](const Row& row) {
            const auto empty = static_cast<std::size_t>(std::count(row.cells.begin(), row.cells.end(), ""));
            return isRow(row) && (_width == 1 || empty + 1 < _width);
        });
        if (found == _rows.end())
            return 0;
        const auto first = static_cast<std::size_t>(found - _rows.begin());
        std::size_t before = first;
        while (before > 0 && isComment(_rows[before - 1]))
            --before;
        if (before > 0 && (areNumbered(before - 1) || endInDelimiters(before - 1)))
            return before - 1;
        if (!hasNumber(*found))
            return first;
        for (std::size_t i = before; i < first; ++i)
            if (const std::size_t size = _rows[i].cells.size(); size == _width || size == _width + 1)
                return i;
        return 0;
    }

    TableLayout withoutHeader(TableLayout layout) const {
        const auto first =
            std::find_if(_rows.begin(), _rows.end(), [&](const Row& row) { return isRow(row); });
        if (first == _rows.end())
            return layout;
        for (std::size_t i = 1; i <= _width; ++i)
            layout.names.push_back(std::to_string(i));
        layout.format.columns = layout.names;
        layout.format.firstLine = first->line;
        layout.isCertain = _width > 1;
        layout.foundCount = countFound({0, layout.names});
        if (first != _rows.begin())
            layout.notes.push_back("its first record is on line " + std::to_string(first->line));
        return layout;
    }

    void setHeader(std::size_t header, TableLayout& layout) const {
        const Row& row = _rows[header];
        layout.names = row.cells;
        layout.headerLine = layout.format.headerLine = layout.format.firstLine = row.line;
        const bool isFirst = row.line <= _begin || (header == 1 && beginsWithSeparator(_rows.front()));
        if (!isFirst && !_options.headerLine)
            layout.notes.push_back("line " + std::to_string(row.line) +
                                   " is taken for the header (header_line sets another)");
        std::vector<std::string>& columns = layout.format.columns;
        if (isComment(row) && row.cells.size() == _width + 1 && _width > 0) {
            columns.assign(row.cells.begin() + 1, row.cells.end());
        } else if (isComment(row) && !isAsked(row.cells.front())) {
            columns = row.cells;
            columns.front() = withoutMark(columns.front());
        } else if (isComment(row)) {
            columns = row.cells;
        } else if (areNumbered(header)) {
            columns = {""};
            columns.insert(columns.end(), row.cells.begin(), row.cells.end());
            layout.notes.push_back("its rows are numbered in a first column without a name");
        }
        std::size_t first = header + 1;
        for (; first < _rows.size() && (isComment(_rows[first]) || !hasDigit(_rows[first])); ++first) {
            if (!hasDigit(_rows[first]) && _rows[first].cells.size() == row.cells.size())
                layout.format.units = _rows[first].cells;
            if (!isComment(_rows[first]) && !joined(_rows[first].cells).empty()) {
                layout.notes.push_back("line " + std::to_string(_rows[first].line) + ", " +
                                       inQuotes(joined(_rows[first].cells)) +
                                       ", has no digits and can only give units");
                columns = columns.empty() ? row.cells : columns;
            }
        }
        if (columns.empty())
            return;
        layout.names = columns;
        layout.format.firstLine = first < _rows.size() ? _rows[first].line : _rows.back().line + 1;
    }

    bool isAsked(const std::string& name) const {
        return std::count(_options.columns.begin(), _options.columns.end(), name) > 0;
    }

    const std::vector<Row>& _rows;
    const TableOptions& _options;
    const CsvFormat& _format;
    const bool _areQuoted; ///< Whether the last row begins with a quotation mark.
    const int _begin;      ///< Line of the first text.
    std::size_t _width = 0;
};

} // namespace

std::string blanksToTabs(std::string_view text) {
    std::string tabbed;
    tabbed.reserve(text.size());
    bool isQuoted = false, isSeparated = false;
    for (const char c : text) {
        const bool isLineEnd = c == '\n' || c == '\r';
        const bool isCellBegin =
            isSeparated || tabbed.empty() || tabbed.back() == '\n' || tabbed.back() == '\r';
        if (!isQuoted && (c == ' ' || c == '\t')) {
            isSeparated = !isCellBegin || isSeparated;
            continue;
        }
        if (isSeparated && !isLineEnd)
            tabbed += '\t';
        if (c == '"' && (isQuoted || isCellBegin))
            isQuoted = !isQuoted;
        isQuoted = isQuoted && !isLineEnd;
        isSeparated = false;
        tabbed += c;
    }
    return tabbed;
}

TableLayout findTable(std::string_view text, const TableOptions& options) {
    const std::string_view lines = firstLines(text);
    TableLayout best;
    std::optional<std::tuple<std::size_t, bool, int, std::size_t>> bestRank;
    for (const char delimiter : {',', ';', '\t', '|', ' '}) {
        if (options.delimiter.value_or(delimiter) != delimiter)
            continue;
        CsvFormat format(delimiter, options.decimalComma.value_or(delimiter != ','));
        format.firstLine = std::max(options.headerLine.value_or(1), 1);
        format.comment = options.comment;
        const bool areBlanks = delimiter == ' ';
        const std::string tabbed = areBlanks ? blanksToTabs(lines) : std::string();
        const std::vector<Row> rows =
            areBlanks ? rowsOf(tabbed, '\t', format.firstLine) : rowsOf(lines, delimiter, format.firstLine);
        HeaderSearch search(rows, lines, options, format);
        TableLayout layout = search.find();
        const std::tuple rank(layout.foundCount, layout.isCertain, -layout.headerLine, search.width());
        if (bestRank &&
            (areBlanks && best.isCertain ? layout.foundCount <= best.foundCount : rank <= *bestRank))
            continue;
        best = std::move(layout);
        bestRank = rank;
    }
    return best;
}

} // namespace osgTreeWind

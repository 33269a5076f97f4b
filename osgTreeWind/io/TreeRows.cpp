// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TreeRows.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/SizeText.h>
#include <osgTreeWind/io/InputFolders.h>
#include <osgTreeWind/io/TableReader.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <string_view>

namespace osgTreeWind {

std::optional<std::size_t> TreeRows::column(const std::string& name) const {
    const auto found = std::find(columns().begin(), columns().end(), name);
    if (found == columns().end())
        return std::nullopt;
    return static_cast<std::size_t>(found - columns().begin());
}

Result<std::size_t> TreeRows::columnOrExpression(const std::string& text) {
    if (const auto found = column(text))
        return *found;
    std::size_t index = columns().size();
    for (const Expression& known : _expressions) {
        if (known.expression.text() == text)
            return index;
        ++index;
    }
    auto parsed = RowExpression::parse(text, columns(), file());
    if (!parsed)
        return parsed.problems();
    _expressions.push_back({std::move(parsed.value())});
    return index;
}

const TreeRows::Expression* TreeRows::expression(std::size_t column) const {
    return _expressions.empty() || column < columns().size() ? nullptr
                                                             : &_expressions[column - columns().size()];
}

const std::string& TreeRows::nameOf(std::size_t column) const {
    const Expression* const computed = expression(column);
    return computed ? computed->expression.text() : columns()[column];
}

bool TreeRows::has(std::size_t column) const {
    const Expression* const computed = expression(column);
    return computed ? !computed->value.text.empty() : hasCell(column);
}

std::string TreeRows::text(std::size_t column) const {
    const Expression* const computed = expression(column);
    return computed ? computed->value.text : cellText(column);
}

std::optional<double> TreeRows::number(std::size_t column) const {
    const Expression* const computed = expression(column);
    if (!computed)
        return cellNumber(column);
    return computed->value.number ? computed->value.number : numberIn(computed->value.text);
}

void TreeRows::rewind(const CrsTransform& transform, std::vector<std::size_t> columns) {
    const bool areAll = columns.empty();
    std::vector<std::size_t> cells;
    const auto addCells = [&](const RowExpression& expression) {
        cells.insert(cells.end(), expression.columns().begin(), expression.columns().end());
    };
    std::size_t index = this->columns().size();
    for (Expression& computed : _expressions) {
        computed.isRead = areAll || std::count(columns.begin(), columns.end(), index++);
        if (computed.isRead)
            addCells(computed.expression);
    }
    for (const std::size_t column : columns)
        if (!expression(column))
            cells.push_back(column);
    if (_filter)
        addCells(*_filter);
    restart(transform, areAll ? std::vector<std::size_t>() : std::move(cells));
}

Result<bool> TreeRows::next() {
    for (;;) {
        Result<bool> found = advance();
        if (!found || !found.value())
            return found;
        const Result<bool> isMatch = evaluate();
        if (!isMatch)
            return problem("", isMatch.problems().front().message);
        if (isMatch.value())
            return true;
    }
}

/// Computes the expressions. @return whether the row matches the filter.
Result<bool> TreeRows::evaluate() {
    if (_filter)
        if (const Result<bool> isMatch = _filter->matches(*this); !isMatch || !isMatch.value())
            return isMatch;
    for (Expression& computed : _expressions)
        if (computed.isRead) {
            auto value = computed.expression.evaluate(*this);
            if (!value)
                return value.problems();
            computed.value = std::move(value.value());
        }
    return true;
}

namespace {

/// The rows of a CSV table, which is parsed once: its text becomes that of the cells below the header, each
/// with a NUL at its end.
class CsvRows final : public TreeRows {
public:
    /// @param text from decodeTable().
    CsvRows(const std::string& path, std::string text, const CsvFormat& format) : _text(std::move(text)) {
        std::size_t end = 0;
        // The cells of a row are never longer than its lines, which are parsed before, and the header's.
        _header = readCsvRows(_text, path, format, [&](const CsvTable&, const CsvTable::Row& row) {
            if (_jumps.empty() || row.line != lineOf(_row))
                _jumps.push_back({_row, row.line});
            ++_row;
            for (const std::string& cell : row.cells) {
                std::memcpy(_text.data() + end, cell.c_str(), cell.size() + 1);
                end += cell.size() + 1;
            }
        });
        _text.resize(end);
    }

    const Diagnostics& problems() const { return _header.problems(); }
    std::string commentNote() const { return header().commentNote(); }
    const std::string& file() const override { return header().file; }
    const std::string& format() const override { return _format; }
    const std::vector<std::string>& columns() const override { return header().columns; }
    std::string unitOf(Dimension dimension, std::size_t column) const override {
        return header().unitOf(dimension, column);
    }
    const std::optional<Crs>& crs() const override { return _crs; }
    bool hasPlaces() const override { return false; }
    Result<VectorPlace> place() const override { return VectorPlace(); }
    Diagnostic problem(const std::string& column, const std::string& message) const override {
        return {file(), lineOf(_row - 1), 0, column, message};
    }

private:
    /// A row that does not begin on the line after the previous row's.
    struct Jump {
        std::size_t row;
        int line;
    };

    bool hasCell(std::size_t column) const override { return !_cells[column].empty(); }
    std::string cellText(std::size_t column) const override { return std::string(_cells[column]); }
    std::optional<double> cellNumber(std::size_t column) const override {
        const std::string text = cellText(column);
        if (const auto number = numberIn(text))
            return number;
        const auto grouped = header().format.groupedNumberOf(text);
        return grouped && areNumbers(column) ? grouped : std::nullopt;
    }
    std::optional<double> numberIn(const std::string& text) const override {
        return header().format.numberOf(text);
    }
    /// Whether all cells of a column are numbers, with or without thousands separators, or missing.
    bool areNumbers(std::size_t column) const {
        const auto [known, isNew] = _areNumbers.try_emplace(column, true);
        std::size_t index = 0;
        for (std::size_t at = 0; isNew && known->second && at < _text.size(); ++index) {
            const std::string cell = _text.data() + at;
            if (index % columns().size() == column)
                known->second = isMissing(cell) || numberIn(cell) || header().format.groupedNumberOf(cell);
            at += cell.size() + 1;
        }
        return known->second;
    }
    const CsvTable& header() const { return _header.value(); }
    int lineOf(std::size_t row) const {
        const auto after = std::upper_bound(_jumps.begin(), _jumps.end(), row,
                                            [](std::size_t at, const Jump& jump) { return at < jump.row; });
        return std::prev(after)->line + static_cast<int>(row - std::prev(after)->row);
    }
    void restart(const CrsTransform&, std::vector<std::size_t>) override {
        _at = _row = 0;
        _cells.resize(columns().size());
    }
    Result<bool> advance() override {
        if (_at == _text.size())
            return false;
        ++_row;
        for (std::string_view& cell : _cells) {
            cell = _text.data() + _at;
            _at += cell.size() + 1;
        }
        return true;
    }

    const std::string _format = "CSV";
    const std::optional<Crs> _crs;
    std::string _text;
    std::vector<Jump> _jumps;
    Result<CsvTable> _header = CsvTable();
    mutable std::map<std::size_t, bool> _areNumbers; ///< By column.
    std::vector<std::string_view> _cells;            ///< Of the current row.
    std::size_t _at = 0, _row = 0; ///< Begin of the next row in the text; number of rows up to it.
};

/// The features of a layer.
class FeatureRows final : public TreeRows {
public:
    FeatureRows(VectorFile file, const TableOptions& options)
        : _file(std::move(file)), _format(_file.format()),
          _numbers(',', options.decimalComma.value_or(false)) {
        if (_format == "OSM" || column("@id") || column("osm_id"))
            _natural = column("natural");
        if (_natural)
            _format = "OSM";
    }

    const std::string& file() const override { return _file.path(); }
    const std::string& format() const override { return _format; }
    const std::vector<std::string>& columns() const override { return _file.columns(); }
    const std::optional<Crs>& crs() const override { return _file.crs(); }
    bool hasPlaces() const override { return _file.hasGeometry(); }
    std::vector<std::string> warnings() const override { return _file.warnings(); }
    void setYFirst() override { _file.setYFirst(); }
    Result<VectorPlace> place() const override {
        auto place = _file.place();
        return place ? place : problem("", place.problems().front().message);
    }
    Diagnostic problem(const std::string& column, const std::string& message) const override {
        return {_file.path(), 0, 0, column, _file.feature() + ": " + message};
    }

private:
    bool hasCell(std::size_t column) const override {
        return _file.number(column) || !cellText(column).empty();
    }
    std::string cellText(std::size_t column) const override { return _file.text(column); }
    std::optional<double> cellNumber(std::size_t column) const override {
        const std::optional<double> stored = _file.number(column);
        const std::optional<double> number = stored ? stored : numberIn(cellText(column));
        return number && Range().contains(*number) ? number : std::nullopt;
    }
    std::optional<double> numberIn(const std::string& text) const override {
        const auto number = _numbers.numberOf(text);
        if (number || !_natural)
            return number;
        const auto size = parseSize(text, SizeKind::Height);
        return size && size->isInMetres && !size->isEstimate ? std::optional(size->value) : std::nullopt;
    }
    void restart(const CrsTransform& transform, std::vector<std::size_t> columns) override {
        if (_natural && !columns.empty())
            columns.push_back(*_natural);
        _file.rewind(transform, std::move(columns));
    }
    Result<bool> advance() override {
        for (;;) {
            Result<bool> found = _file.next();
            if (!found || !found.value() || !_natural || _file.text(*_natural) == "tree")
                return found;
        }
    }

    VectorFile _file;
    std::string _format;
    const CsvFormat _numbers;            ///< Numbers in texts.
    std::optional<std::size_t> _natural; ///< OpenStreetMap's column `natural`, which is "tree" for trees.
};

std::unique_ptr<TreeRows> openCsv(TableReader& table, const std::string& path, const TableOptions& options) {
    Result<std::string> bytes = readBytes(path);
    Result<TableText> text =
        bytes ? decodeTable(std::move(bytes.value()), path, options) : Result<TableText>(bytes.problems());
    std::unique_ptr<CsvRows> rows;
    if (text)
        rows = std::make_unique<CsvRows>(path, std::move(text.value().text), text.value().format);
    const Diagnostics& problems = rows ? rows->problems() : text.problems();
    for (const Diagnostic& problem : problems)
        table.report(problem);
    if (!problems.empty())
        return {};
    for (const std::string& note : text.value().notes)
        table.note(path + ": " + note);
    if (const std::string note = rows->commentNote(); !note.empty())
        table.note(path + ": " + note);
    return rows;
}

std::unique_ptr<TreeRows> openFeatures(TableReader& table, const std::string& path, const std::string& layer,
                                       const TableOptions& options) {
    auto file = VectorFile::open(path);
    Diagnostics problems = file.problems();
    if (problems.empty())
        problems = file.value().chooseLayer(layer);
    for (const Diagnostic& problem : problems)
        table.report(problem);
    if (!problems.empty())
        return {};
    return std::make_unique<FeatureRows>(std::move(file.value()), options);
}

} // namespace

TableOptions readTableOptions(TableReader& table) {
    TableOptions options;
    table.readChoice<std::optional<char>>(
        "delimiter", options.delimiter,
        {{",", ','}, {";", ';'}, {"\t", '\t'}, {"tab", '\t'}, {"|", '|'}, {"blanks", ' '}});
    table.readChoice<std::optional<bool>>("decimal", options.decimalComma, {{".", false}, {",", true}});
    table.read("comment", options.comment);
    if (int line = 0; table.read("header_line", line, within(0, 1e6)))
        options.headerLine = line;
    options.columns = table.texts("columns");
    return options;
}

std::unique_ptr<TreeRows> openTreeRows(TableReader& table, const InputFolders& folders) {
    const TableOptions options = readTableOptions(table);
    std::string layer, filter;
    table.read("layer", layer);
    table.read("filter", filter);
    auto file = folders.open(table, "file");
    if (!file)
        return {};
    const bool hasFeatures = VectorFile::isSupported(file->path);
    bool isValid = true;
    for (const char* key : {"layer", "delimiter", "comment", "header_line"})
        if (table.has(key) && hasFeatures == (key != std::string("layer"))) {
            table.problem(key, hasFeatures ? "applies only to a CSV table"
                                           : "applies only to a file with layers, not to a CSV table");
            isValid = false;
        }
    if (!isValid)
        return {};
    std::unique_ptr<TreeRows> rows =
        hasFeatures ? openFeatures(table, file->path, layer, options) : openCsv(table, file->path, options);
    if (!rows || filter.empty())
        return rows;
    auto condition =
        RowExpression::parse(filter, rows->columns(), rows->file(), RowExpression::Kind::Condition);
    if (!condition) {
        table.problem("filter", condition.problems().front().message);
        return {};
    }
    rows->setFilter(std::move(condition.value()));
    return rows;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TreeRows.h>

#include <osgTreeWind/base/CsvReader.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/InventoryColumns.h>
#include <osgTreeWind/io/NameMatching.h>
#include <osgTreeWind/io/RowFilter.h>

#include <algorithm>

namespace osgTreeWind {

std::optional<std::size_t> TreeRows::column(const std::string& name) const {
    const auto found = std::find(columns().begin(), columns().end(), name);
    if (found == columns().end())
        return std::nullopt;
    return static_cast<std::size_t>(found - columns().begin());
}

std::string TreeRows::problemOfColumn(const std::string& name) const {
    const std::string similar = nearestName(name, columns());
    return "no column " + inQuotes(name) + " in " + file() +
           (similar.empty() ? "" : "; did you mean " + inQuotes(similar) + '?');
}

namespace {

class CsvRows final : public TreeRows {
public:
    /// @param text from decodeTable(), checked by readCsvRows(). @param header from readCsvRows().
    CsvRows(CsvTable header, std::string text) : _header(std::move(header)), _text(std::move(text)) {
        rewind({}, {});
    }

    const std::string& file() const override { return _header.file; }
    const std::string& format() const override { return _format; }
    const std::vector<std::string>& columns() const override { return _header.columns; }
    const std::optional<Crs>& crs() const override { return _crs; }
    bool hasPlaces() const override { return false; }
    void rewind(const CrsTransform&, const std::vector<std::size_t>&) override {
        _reader.emplace(_text, _header.file, _header.format.delimiter);
        static_cast<void>(_reader->next()); // skip the header
    }
    Result<bool> next() override { return _reader->next(); }
    bool has(std::size_t column) const override { return !text(column).empty(); }
    std::string text(std::size_t column) const override { return _reader->row().cells[column]; }
    Result<double> number(std::size_t column) const override {
        return _header.number(_reader->row(), column);
    }
    Result<VectorPlace> place() const override { return VectorPlace(); }
    Diagnostic problem(const std::string& column, const std::string& message) const override {
        return {_header.file, _reader->row().line, 0, column, message};
    }

private:
    CsvTable _header;
    std::string _text;
    const std::string _format = "CSV";
    std::optional<CsvReader> _reader;
    std::optional<Crs> _crs;
};

class FeatureRows final : public TreeRows {
public:
    explicit FeatureRows(VectorFile file) : _file(std::move(file)), _format(_file.format()) {
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
    void rewind(const CrsTransform& transform, const std::vector<std::size_t>& columns) override {
        std::vector<std::size_t> all = columns;
        if (_natural && !all.empty())
            all.push_back(*_natural);
        _file.rewind(transform, all);
    }
    Result<bool> next() override {
        for (;;) {
            Result<bool> found = _file.next();
            if (!found || !found.value() || !_natural || _file.text(*_natural) == "tree")
                return found;
        }
    }
    bool has(std::size_t column) const override { return _file.number(column) || !text(column).empty(); }
    std::string text(std::size_t column) const override { return _file.text(column); }
    Result<double> number(std::size_t column) const override {
        const std::optional<double> stored = _file.number(column);
        const std::optional<double> number = stored     ? stored
                                             : _natural ? parseMetres(text(column))
                                                        : parseNumber(text(column));
        if (number && Range().contains(*number))
            return *number;
        return problem(columns()[column], expectedFound("a number", text(column)));
    }
    Result<VectorPlace> place() const override {
        auto place = _file.place();
        return place ? place : problem("", place.problems().front().message);
    }
    Diagnostic problem(const std::string& column, const std::string& message) const override {
        return {_file.path(), 0, 0, column, _file.feature() + ": " + message};
    }

private:
    VectorFile _file;
    std::string _format;
    std::optional<std::size_t> _natural; ///< OpenStreetMap's column `natural`, which is "tree" for trees.
};

std::unique_ptr<TreeRows> openCsv(const std::string& path, const TableOptions& options,
                                  ForestReading& reading) {
    Result<std::string> bytes = readBytes(path);
    Result<TableText> text =
        bytes ? decodeTable(std::move(bytes.value()), path, options) : Result<TableText>(bytes.problems());
    const Result<CsvTable> table = text ? readCsvRows(text.value().text, path, text.value().format,
                                                      [](const CsvTable&, CsvTable::Row&) {})
                                        : Result<CsvTable>(text.problems());
    for (const Diagnostic& problem : table.problems())
        reading.log.add(problem);
    if (!table)
        return {};
    for (const std::string& note : text.value().notes)
        reading.forest.notes.push_back(path + ": " + note);
    return std::make_unique<CsvRows>(table.value(), std::move(text.value().text));
}

/// The rows that match a filter.
class MatchingRows final : public TreeRows {
public:
    MatchingRows(std::unique_ptr<TreeRows> all, RowFilter filter)
        : _all(std::move(all)), _filter(std::move(filter)) {}

    const std::string& file() const override { return _all->file(); }
    const std::string& format() const override { return _all->format(); }
    const std::vector<std::string>& columns() const override { return _all->columns(); }
    const std::optional<Crs>& crs() const override { return _all->crs(); }
    bool hasPlaces() const override { return _all->hasPlaces(); }
    void rewind(const CrsTransform& transform, const std::vector<std::size_t>& columns) override {
        std::vector<std::size_t> all = columns;
        if (!columns.empty())
            for (const std::size_t column : _filter.columns())
                all.push_back(column);
        _all->rewind(transform, all);
    }
    Result<bool> next() override {
        for (;;) {
            Result<bool> found = _all->next();
            if (!found || !found.value() || _filter.matches(*_all))
                return found;
        }
    }
    bool has(std::size_t column) const override { return _all->has(column); }
    std::string text(std::size_t column) const override { return _all->text(column); }
    Result<double> number(std::size_t column) const override { return _all->number(column); }
    Result<VectorPlace> place() const override { return _all->place(); }
    Diagnostic problem(const std::string& column, const std::string& message) const override {
        return _all->problem(column, message);
    }

private:
    std::unique_ptr<TreeRows> _all;
    RowFilter _filter;
};

std::unique_ptr<TreeRows> openFeatures(const std::string& path, const std::string& layer,
                                       ForestReading& reading) {
    auto file = VectorFile::open(path);
    Diagnostics problems = file.problems();
    if (problems.empty())
        problems = file.value().chooseLayer(layer);
    for (const Diagnostic& problem : problems)
        reading.log.add(problem);
    if (!problems.empty())
        return {};
    for (const std::string& warning : file.value().warnings())
        reading.forest.notes.emplace_back(path).append(": ").append(warning);
    return std::make_unique<FeatureRows>(std::move(file.value()));
}

} // namespace

TableOptions readTableOptions(TableReader& table) {
    TableOptions options;
    table.readChoice<std::optional<char>>("delimiter", options.delimiter,
                                          {{",", ','}, {";", ';'}, {"\t", '\t'}, {"|", '|'}});
    table.readChoice<std::optional<bool>>("decimal", options.decimalComma, {{".", false}, {",", true}});
    return options;
}

std::unique_ptr<TreeRows> openTreeRows(TableReader& table, ForestReading& reading) {
    const TableOptions options = readTableOptions(table);
    std::string layer, filter;
    table.read("layer", layer);
    table.read("filter", filter);
    auto file = reading.open(table, "file");
    if (!file)
        return {};
    const bool hasFeatures = VectorFile::isSupported(file->path);
    bool isValid = true;
    for (const char* key : {"layer", "delimiter"})
        if (table.has(key) && hasFeatures == (key == std::string("delimiter"))) {
            table.problem(key, hasFeatures ? "applies only to a CSV table"
                                           : "applies only to a file with layers, not to a CSV table");
            isValid = false;
        }
    if (!isValid)
        return {};
    std::unique_ptr<TreeRows> rows =
        hasFeatures ? openFeatures(file->path, layer, reading) : openCsv(file->path, options, reading);
    if (!rows || filter.empty())
        return rows;
    Result<RowFilter> condition = RowFilter::parse(filter, *rows);
    if (condition)
        return std::make_unique<MatchingRows>(std::move(rows), std::move(condition.value()));
    table.problem("filter", condition.problems().front().message);
    return {};
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TreeRows.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/InventoryColumns.h>

#include <algorithm>

namespace osgTreeWind {

std::optional<std::size_t> TreeRows::column(const std::string& name) const {
    const auto found = std::find(columns().begin(), columns().end(), name);
    if (found == columns().end())
        return std::nullopt;
    return static_cast<std::size_t>(found - columns().begin());
}

namespace {

class CsvRows final : public TreeRows {
public:
    explicit CsvRows(CsvTable table) : _table(std::move(table)) {}

    const std::string& file() const override { return _table.file; }
    const std::string& format() const override { return _format; }
    const std::vector<std::string>& columns() const override { return _table.columns; }
    const std::optional<Crs>& crs() const override { return _crs; }
    bool hasPlaces() const override { return false; }
    void rewind() override { _next = 0; }
    Result<bool> next() override { return _next++ < _table.rows.size(); }
    bool has(std::size_t column) const override { return !row().cells[column].empty(); }
    std::string text(std::size_t column) const override { return row().cells[column]; }
    Result<double> number(std::size_t column) const override { return _table.number(row(), column); }
    Result<VectorPlace> place(const CrsWay&) const override { return VectorPlace(); }
    Diagnostic problem(const std::string& column, const std::string& message) const override {
        return {_table.file, row().line, 0, column, message};
    }

private:
    const CsvTable::Row& row() const { return _table.rows[_next - 1]; }

    CsvTable _table;
    const std::string _format = "CSV";
    std::size_t _next = 0;
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
    void rewind() override { _file.rewind(); }
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
                                             : _natural ? metresOf(text(column))
                                                        : parseNumber(text(column));
        if (number && Range().contains(*number))
            return *number;
        return problem(columns()[column], expectedFound("a number", text(column)));
    }
    Result<VectorPlace> place(const CrsWay& way) const override {
        auto place = _file.place(way);
        return place ? place : problem("", place.problems().front().message);
    }
    Diagnostic problem(const std::string& column, const std::string& message) const override {
        return {_file.path(), 0, 0, column, _file.feature() + ": " + message};
    }

private:
    VectorFile _file;
    std::string _format;
    std::optional<std::size_t> _natural; ///< Of OpenStreetMap: the column that says "tree".
};

std::unique_ptr<TreeRows> openCsv(ForestReading::InputFile file, char delimiter, ForestReading& reading) {
    auto table = readCsvTable(file.stream, file.path, delimiter);
    if (table)
        return std::make_unique<CsvRows>(std::move(table.value()));
    for (const Diagnostic& problem : table.problems())
        reading.log.add(problem);
    return {};
}

std::unique_ptr<TreeRows> openFeatures(const std::string& path, const std::string& layer,
                                       const std::string& filter, ForestReading& reading) {
    auto file = VectorFile::open(path);
    Diagnostics problems = file.problems();
    if (problems.empty())
        problems = file.value().chooseLayer(layer);
    if (problems.empty() && !filter.empty())
        problems = file.value().filter(filter);
    for (const Diagnostic& problem : problems)
        reading.log.add(problem);
    if (!problems.empty())
        return {};
    for (const std::string& warning : file.value().warnings())
        reading.forest.notes.emplace_back(path).append(": ").append(warning);
    return std::make_unique<FeatureRows>(std::move(file.value()));
}

} // namespace

std::unique_ptr<TreeRows> openTreeRows(TableReader& table, ForestReading& reading) {
    char delimiter = ',';
    table.readChoice<char>("delimiter", delimiter, {{",", ','}, {";", ';'}, {"\t", '\t'}, {"|", '|'}});
    std::string layer, filter;
    table.read("layer", layer);
    table.read("filter", filter);
    auto file = reading.open(table, "file");
    if (!file)
        return {};
    const bool hasFeatures = VectorFile::knows(file->path);
    bool fits = true;
    for (const char* key : {"layer", "filter", "delimiter"})
        if (table.has(key) && hasFeatures == (key == std::string("delimiter"))) {
            table.problem(key, hasFeatures ? "expected only beside a CSV table"
                                           : "expected only beside a file with layers, not a CSV table");
            fits = false;
        }
    if (!fits)
        return {};
    return hasFeatures ? openFeatures(file->path, layer, filter, reading)
                       : openCsv(std::move(*file), delimiter, reading);
}

} // namespace osgTreeWind

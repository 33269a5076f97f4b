// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>

#include <array>
#include <sstream>

namespace osgTreeWind {

namespace {

/// Reads cells of a table; the first problem is kept.
class CellReader {
public:
    explicit CellReader(const CsvTable& table) : _table(table) {}

    std::size_t column(const char* name) {
        for (std::size_t i = 0; i < _table.columns.size(); ++i)
            if (lower(_table.columns[i]) == lower(name))
                return i;
        fail({_table.file, _table.headerLine, 0, name, "expected a column of this name"});
        return 0;
    }

    double number(const CsvTable::Row& row, std::size_t column, const char* what, double low, double high) {
        const auto value = parseNumber(row.cells[column]);
        if (value && *value >= low && *value <= high)
            return *value;
        fail(row, column, what);
        return 0.0;
    }

    int whole(const CsvTable::Row& row, std::size_t column, const char* what) {
        const double value = number(row, column, what, -1e9, 1e9);
        if (value != static_cast<int>(value))
            fail(row, column, what);
        return static_cast<int>(value);
    }

    const Diagnostic* problem() const { return _problem.message.empty() ? nullptr : &_problem; }
    void fail(const Diagnostic& problem) {
        if (_problem.message.empty())
            _problem = problem;
    }

private:
    void fail(const CsvTable::Row& row, std::size_t column, const char* what) {
        fail({_table.file, row.line, 0, _table.columns[column], expectedFound(what, row.cells[column])});
    }

    const CsvTable& _table;
    Diagnostic _problem;
};

char delimiterOf(std::string_view text) {
    for (const char delimiter : text.substr(0, text.find('\n')))
        if (delimiter == ',' || delimiter == ';' || delimiter == '\t')
            return delimiter;
    return ',';
}

} // namespace

Result<ScanFile> readSimpleForest(std::string_view text, const std::string& file) {
    std::istringstream input{std::string(text)};
    const Result<CsvTable> read = readCsvTable(input, file, delimiterOf(text));
    if (!read)
        return read.problems().front();
    const CsvTable& table = read.value();
    CellReader cells(table);
    const std::size_t id = cells.column("ID"), parentId = cells.column("parentID"),
                      radius = cells.column("radius");
    const std::array<std::size_t, 6> ends = {cells.column("startX"), cells.column("startY"),
                                             cells.column("startZ"), cells.column("endX"),
                                             cells.column("endY"),   cells.column("endZ")};
    if (table.rows.size() > maxScanCylinders)
        cells.fail(fileProblem(file, "expected at most " + std::to_string(maxScanCylinders) + " cylinders"));

    ScanFile scan{"SimpleForest", {{}}};
    ScanCylinders& cylinders = scan.trees.front();
    std::vector<ScanName> names;
    for (const CsvTable::Row& row : table.rows) {
        if (cells.problem())
            break;
        ScanCylinder cylinder;
        const auto metres = [&](std::size_t i) {
            return cells.number(row, ends[i], "metres within 1e9", -1e9, 1e9);
        };
        cylinder.start = {metres(0), metres(1), metres(2)};
        cylinder.end = {metres(3), metres(4), metres(5)};
        cylinder.radius = cells.number(row, radius, "a radius above 0 and of at most 10 m", 1e-9, 10.0);
        cylinder.line = row.line;
        cylinders.push_back(cylinder);
        names.push_back({cells.whole(row, id, "a whole number"),
                         cells.whole(row, parentId, "the ID of a cylinder, or -1"), row.line});
    }
    if (cells.problem())
        return *cells.problem();
    if (auto problem = linkCylinders(cylinders, names, -1, file))
        return std::move(*problem);
    return scan;
}

} // namespace osgTreeWind

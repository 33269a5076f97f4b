// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/scanfiles/ScanColumns.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>
#include <osgTreeWind/scanfiles/ScanMeasures.h>

#include <algorithm>
#include <sstream>

namespace osgTreeWind {

namespace {

using Column = ScanColumns::Column;

/// The cells of a cylinder.
struct CylinderCells {
    CsvCells cells;
    const ScanColumns& columns;

    double number(std::size_t column, const ScanMeasure& measure) {
        return cells.number(columns.at[column], measure.range, measure.what);
    }

    int whole(std::size_t column, const char* what) {
        const double value = number(column, {what, within(-1e9, 1e9)});
        if (value != static_cast<int>(value))
            cells.expect(columns.at[column], what);
        return static_cast<int>(value);
    }

    glm::dvec3 vector(std::size_t first, const ScanMeasure& measure) {
        return {number(first, measure), number(first + 1, measure), number(first + 2, measure)};
    }

    ScanCylinder cylinder() {
        ScanCylinder cylinder;
        cylinder.start = vector(Column::start, scanMetres);
        if (columns.hasEnds) {
            cylinder.end = vector(Column::end, scanMetres);
        } else {
            const glm::dvec3 axis = vector(Column::axis, scanDirection);
            const double length = number(Column::length, scanLength);
            if (const std::string wrong = endAlong(axis, length, cylinder); !wrong.empty())
                cells.fail(columns.at[Column::axis], wrong);
        }
        cylinder.radius = number(Column::radius, scanRadius);
        cylinder.line = cells.line();
        return cylinder;
    }

    ScanName name() {
        const std::string& parent = cells.text(columns.at[Column::parent]);
        const bool isRoot = parent.empty() || lower(parent) == "na";
        return {whole(Column::id, "a whole number"),
                isRoot ? -1
                       : whole(Column::parent, "the id of a cylinder, or 0, -1 or NA for that of the root"),
                cells.line()};
    }
};

/// What parts the names in the first line that is not blank.
char delimiterOf(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    for (const char delimiter : text.substr(0, text.find('\n')))
        if (delimiter == ',' || delimiter == ';' || delimiter == '\t')
            return delimiter;
    return ' ';
}

/// The text with one blank between the words of a line. Where R put names of rows, in quotes, before the
/// cells but none over them, they get one.
std::string withSingleBlanks(std::string_view text) {
    std::string single;
    for (const char c : text) {
        if ((c == '\n' || c == '\r') && !single.empty() && single.back() == ' ')
            single.pop_back();
        if (c != ' ' || (!single.empty() && single.back() != ' ' && single.back() != '\n'))
            single += c;
    }
    const std::size_t names = single.find('\n'), row = names + 1;
    const auto words = [&](std::size_t from, std::size_t to) {
        return std::count(single.data() + from, single.data() + to, ' ');
    };
    if (names != std::string::npos && single[row] == '"' &&
        words(row, std::min(single.find('\n', row), single.size())) == words(0, names) + 1)
        single.insert(0, "\"\" ");
    return single;
}

/// Where 0 is no id, it is the parent of the root. Extensions with a 0 among them are none: there, cylinders
/// count from 1.
void settleNames(std::vector<ScanName>& names, bool areExtensions) {
    const bool hasZero = std::any_of(names.begin(), names.end(), [](const ScanName& n) { return n.id == 0; });
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (areExtensions && hasZero)
            names[i].id = static_cast<int>(i) + 1;
        if (names[i].parent == 0 && (areExtensions || !hasZero))
            names[i].parent = -1;
    }
}

} // namespace

Result<ScanFile> readScanTable(std::string_view text, const std::string& file) {
    const char delimiter = delimiterOf(text);
    std::istringstream input(delimiter == ' ' ? withSingleBlanks(text) : std::string(text));
    const Result<CsvTable> table = readCsvTable(input, file, delimiter);
    if (!table)
        return table.problems().front();
    const Result<ScanColumns> columns = ScanColumns::of(table.value());
    if (!columns)
        return columns.problems();
    const std::vector<CsvTable::Row>& rows = table.value().rows;
    if (rows.size() > maxScanCylinders)
        return fileProblem(file, "expected at most " + std::to_string(maxScanCylinders) + " cylinders");

    ScanFile scan{columns.value().format, {{}}};
    std::vector<ScanName> names;
    for (const CsvTable::Row& row : rows) {
        CylinderCells cells{{table.value(), row}, columns.value()};
        scan.trees.front().push_back(cells.cylinder());
        names.push_back(cells.name());
        if (cells.cells.problem())
            return *cells.cells.problem();
    }
    settleNames(names, columns.value().idsAreExtensions);
    if (auto problem = linkCylinders(scan.trees.front(), names, -1, file))
        return std::move(*problem);
    return scan;
}

} // namespace osgTreeWind

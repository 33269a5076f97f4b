// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/TableText.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/scanfiles/ScanColumns.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>
#include <osgTreeWind/scanfiles/ScanQuantity.h>

#include <algorithm>
#include <sstream>

namespace osgTreeWind {

namespace {

using Column = ScanColumns::Column;

/// Reads the cells of a cylinder.
struct CylinderCells {
    CsvCells cells;
    const ScanColumns& columns;

    double number(std::size_t column, const ScanQuantity& quantity) {
        return cells.number(columns.at[column], quantity.range, quantity.description);
    }

    int integer(std::size_t column, const char* description) {
        const double value = number(column, {description, within(-1e9, 1e9)});
        if (value != static_cast<int>(value))
            cells.failExpected(columns.at[column], description);
        return static_cast<int>(value);
    }

    glm::dvec3 vector(std::size_t first, const ScanQuantity& quantity) {
        return {number(first, quantity), number(first + 1, quantity), number(first + 2, quantity)};
    }

    ScanCylinder cylinder() {
        ScanCylinder cylinder;
        cylinder.start = vector(Column::start, scanMetres);
        if (columns.hasEnds) {
            cylinder.end = vector(Column::end, scanMetres);
        } else {
            const glm::dvec3 axis = vector(Column::axis, scanDirection);
            const double length = number(Column::length, scanLength);
            if (const std::string wrong = setEndFromAxis(axis, length, cylinder); !wrong.empty())
                cells.fail(columns.at[Column::axis], wrong);
        }
        cylinder.radius = number(Column::radius, scanRadius);
        cylinder.line = cells.line();
        return cylinder;
    }

    ScanLink link() {
        const std::string& parent = cells.text(columns.at[Column::parent]);
        const bool isRoot = parent.empty() || lower(parent) == "na";
        return {integer(Column::id, "a whole number"),
                isRoot
                    ? -1
                    : integer(Column::parent, "the id of the parent cylinder, or 0, -1 or NA for the root"),
                cells.line()};
    }
};

/// Sets the parent of the root to -1; it may be 0 if no id is 0. Extensions that contain a 0 are not ids: the
/// cylinders are then numbered from 1.
void normalizeLinks(std::vector<ScanLink>& links, bool areExtensions) {
    const bool hasZero =
        std::any_of(links.begin(), links.end(), [](const ScanLink& link) { return link.id == 0; });
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (areExtensions && hasZero)
            links[i].id = static_cast<int>(i) + 1;
        if (links[i].parent == 0 && (areExtensions || !hasZero))
            links[i].parent = -1;
    }
}

} // namespace

Result<ScanFile> readScanTable(std::string_view text, const std::string& file) {
    const Result<TableText> decoded = decodeTable(std::string(text), file);
    if (!decoded)
        return decoded.problems();
    std::istringstream input(decoded.value().text);
    const Result<CsvTable> table = readCsvTable(input, file, decoded.value().format);
    if (!table)
        return table.problems();
    const Result<ScanColumns> columns = ScanColumns::find(table.value());
    if (!columns)
        return columns.problems();
    const std::vector<CsvTable::Row>& rows = table.value().rows;
    if (rows.size() > maxScanCylinders)
        return fileProblem(file, "expected at most " + std::to_string(maxScanCylinders) + " cylinders");

    ScanFile scan{columns.value().format, {{}}};
    std::vector<ScanLink> links;
    for (const CsvTable::Row& row : rows) {
        CylinderCells cells{{table.value(), row}, columns.value()};
        scan.trees.front().push_back(cells.cylinder());
        links.push_back(cells.link());
        if (cells.cells.problem())
            return *cells.cells.problem();
    }
    normalizeLinks(links, columns.value().idsAreExtensions);
    if (auto problem = setParents(scan.trees.front(), links, -1, file))
        return std::move(*problem);
    return scan;
}

} // namespace osgTreeWind

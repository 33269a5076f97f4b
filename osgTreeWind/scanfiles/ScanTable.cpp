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
#include <limits>
#include <sstream>

namespace osgTreeWind {

namespace {

using Column = ScanColumns::Column;

constexpr int noParent = std::numeric_limits<int>::min(); ///< ScanLink::parent of a root.

/// Reads the cells of a cylinder or a point.
struct CylinderCells {
    CsvCells cells;
    const ScanColumns& columns;

    std::size_t at(std::size_t column) const { return *columns.at[column]; }

    double number(std::size_t column, const ScanQuantity& quantity) {
        return cells.number(at(column), quantity.range, quantity.description);
    }

    int integer(std::size_t column, const char* description) {
        const double value = number(column, {description, within(-1e9, 1e9)});
        if (value != static_cast<int>(value))
            cells.failExpected(at(column), description);
        return static_cast<int>(value);
    }

    glm::dvec3 vector(std::size_t first, const ScanQuantity& quantity) {
        return {number(first, quantity), number(first + 1, quantity), number(first + 2, quantity)};
    }

    double radius() {
        return columns.at[Column::radius] ? number(Column::radius, scanRadius)
                                          : 0.5 * number(Column::diameter, scanDiameter);
    }

    ScanCylinder cylinder() {
        ScanCylinder cylinder;
        cylinder.start = vector(Column::start, scanMetres);
        if (columns.kind == Column::end) {
            cylinder.end = vector(Column::end, scanMetres);
        } else {
            const glm::dvec3 axis = vector(Column::axis, scanDirection);
            const double length = number(Column::length, scanLength);
            if (const std::string wrong = setEndFromAxis(axis, length, cylinder); !wrong.empty())
                cells.fail(at(Column::axis), wrong);
        }
        cylinder.radius = radius();
        cylinder.line = cells.line();
        return cylinder;
    }

    /// The radius of a root is not used.
    ScanPoint point(const ScanLink& link) {
        return {vector(Column::place, scanMetres), link.parent == noParent ? 0.0 : radius(), link};
    }

    /// @param row from 1 on.
    ScanLink link(int row) {
        ScanLink link{row, noParent, cells.line()};
        if (columns.at[Column::id])
            link.id = integer(Column::id, "a whole number");
        if (!columns.at[Column::parent])
            return link;
        const std::string parent = lower(cells.text(at(Column::parent)));
        if (!parent.empty() && parent != "na" && parent != "nan" && parent != "none" && parent != "null")
            link.parent = integer(Column::parent, "the id of the parent, or 0, -1 or NA for the root");
        return link;
    }
};

/// Sets the parent of the root to noParent; in the file it may be -1 or the root itself, or 0 if no id is 0.
/// Extensions that contain a 0 are not ids: the cylinders are then numbered from 1.
void normalizeLinks(std::vector<ScanLink>& links, bool areExtensions) {
    const bool hasZero =
        std::any_of(links.begin(), links.end(), [](const ScanLink& link) { return link.id == 0; });
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (areExtensions && hasZero)
            links[i].id = static_cast<int>(i) + 1;
        if (links[i].parent == -1 || links[i].parent == links[i].id ||
            (links[i].parent == 0 && (areExtensions || !hasZero)))
            links[i].parent = noParent;
    }
}

/// Numbers rows without ids as their parents do: from 0, if a root has the parent -1 or none has 0.
/// @return a note.
std::string numberRows(std::vector<ScanLink>& links) {
    const auto anyHas = [&](int parent) {
        return std::any_of(links.begin(), links.end(),
                           [&](const ScanLink& link) { return link.parent == parent; });
    };
    const bool isFromZero = anyHas(-1) || (anyHas(noParent) && anyHas(0));
    for (ScanLink& link : links)
        link.id -= isFromZero;
    return std::string("its parents are taken as numbers of rows from ") + (isFromZero ? "0" : "1") +
           " on, because there is no column of ids";
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
    const Result<ScanColumns> found = ScanColumns::find(table.value());
    if (!found)
        return found.problems();
    const ScanColumns& columns = found.value();
    const std::vector<CsvTable::Row>& rows = table.value().rows;
    if (rows.size() > maxScanCylinders)
        return fileProblem(file, "expected at most " + std::to_string(maxScanCylinders) + " cylinders");

    ScanFile scan{columns.format, {{}}};
    std::vector<ScanLink> links;
    for (const CsvTable::Row& row : rows) {
        CylinderCells cells{{table.value(), row}, columns};
        links.push_back(cells.link(static_cast<int>(links.size()) + 1));
        if (cells.cells.problem())
            return *cells.cells.problem();
    }
    const bool hasParents = columns.at[Column::parent].has_value();
    if (hasParents && !columns.at[Column::id])
        scan.notes.push_back(numberRows(links));
    normalizeLinks(links, columns.idsAreExtensions);
    ScanCylinders& cylinders = scan.trees.front();
    std::vector<ScanPoint> points;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CylinderCells cells{{table.value(), rows[i]}, columns};
        if (columns.kind == Column::place)
            points.push_back(cells.point(links[i]));
        else
            cylinders.push_back(cells.cylinder());
        if (cells.cells.problem())
            return *cells.cells.problem();
    }
    if (columns.kind == Column::place) {
        Result<ScanCylinders> tree = makeCylinders(points, noParent, file);
        if (!tree)
            return tree.problems();
        cylinders = std::move(tree.value());
    } else if (!hasParents) {
        joinEnds(cylinders);
        scan.hasParents = false;
    } else if (auto problem = setParents(cylinders, links, noParent, file))
        return std::move(*problem);
    return scan;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>
#include <osgTreeWind/scanfiles/ScanRows.h>

namespace osgTreeWind {

namespace {

/// Reads the cylinder of a line. @return the number of its parent.
int readCylinder(ScanRows& rows, ScanCylinder& cylinder) {
    const auto vector = [&](std::size_t first, const ScanQuantity& quantity) {
        glm::dvec3 v(0.0);
        for (int i = 0; i < 3; ++i)
            v[i] = rows.number(first + static_cast<std::size_t>(i), quantity);
        return v;
    };
    cylinder.radius = rows.number(0, scanRadius);
    const double length = rows.number(1, scanLength);
    cylinder.start = vector(2, scanMetres);
    const glm::dvec3 axis = vector(5, scanDirection);
    if (const std::string wrong = setEndFromAxis(axis, length, cylinder); !wrong.empty())
        rows.fail(5, wrong);
    cylinder.line = rows.line();
    return rows.integer(8, "the number of the parent cylinder, or 0", -1, static_cast<int>(maxScanCylinders));
}

} // namespace

Result<ScanFile> readTreeQsm(std::string_view text, const std::string& file) {
    ScanFile scan{"TreeQSM", {{}}};
    ScanCylinders& cylinders = scan.trees.front();
    std::vector<ScanLink> links;
    std::size_t columns = 0;
    ScanRows rows(text, file);
    for (bool isFirst = true; rows.good() && rows.next(); isFirst = false) {
        const std::size_t count = rows.words().size();
        if (isFirst && !parseNumber(rows.words().front()))
            continue; // the header
        if (columns == 0)
            columns = count;
        if (count != columns || (columns != 15 && columns != 17))
            rows.failLine("expected 15 or 17 columns, the same in all lines, found " + std::to_string(count));
        else if (cylinders.size() == maxScanCylinders)
            rows.failLine("expected at most " + std::to_string(maxScanCylinders) + " cylinders");
        if (!rows.good())
            break;
        ScanCylinder cylinder;
        const int parent = readCylinder(rows, cylinder);
        links.push_back({static_cast<int>(links.size()) + 1, parent, rows.line()});
        cylinders.push_back(cylinder);
    }
    if (!rows.good())
        return rows.problem();
    makeOneBased(links);
    if (auto problem = setParents(cylinders, links, 0, file))
        return std::move(*problem);
    return scan;
}

} // namespace osgTreeWind

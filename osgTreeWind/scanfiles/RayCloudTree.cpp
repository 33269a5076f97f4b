// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>
#include <osgTreeWind/scanfiles/ScanRows.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr std::size_t noColumn = static_cast<std::size_t>(-1);

/// Values of one segment, according to the header: x, y, z and radius come first.
struct Section {
    std::size_t width = 0;
    std::size_t parent = noColumn; ///< Index of parent_id in the section.
};

struct Layout {
    std::size_t treeValues = 0; ///< Number of values before the first segment.
    Section first, others;
};

/// Reads the header. @return false if it has no x, y, z, radius, parent_id.
bool readLayout(const std::vector<std::string_view>& names, Layout& layout) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i + 3 < names.size(); ++i)
        if (names[i] == "x" && names[i + 1] == "y" && names[i + 2] == "z" && names[i + 3] == "radius")
            starts.push_back(i);
    if (starts.empty() || starts.size() > 2)
        return false;
    const auto section = [&](std::size_t from, std::size_t to) {
        const auto begin = names.begin() + static_cast<std::ptrdiff_t>(from),
                   end = names.begin() + static_cast<std::ptrdiff_t>(to);
        const auto parent = std::find(begin, end, "parent_id");
        return Section{to - from, parent == end ? noColumn : static_cast<std::size_t>(parent - begin)};
    };
    layout.treeValues = starts.front();
    layout.first = section(starts.front(), starts.size() == 2 ? starts[1] : names.size());
    layout.others = starts.size() == 2 ? section(starts[1], names.size()) : layout.first;
    return layout.others.parent != noColumn;
}

ScanPoint readSegment(ScanRows& rows, std::size_t at, const Section& section, int id) {
    ScanPoint point;
    for (int i = 0; i < 3; ++i)
        point.place[i] = rows.number(at + static_cast<std::size_t>(i), scanMetres);
    if (id == 0) // a point; its radius is not used
        rows.number(at + 3, {"a number", within(-1e300, 1e300)});
    else
        point.radius = rows.number(at + 3, scanRadius);
    point.link = {id, -1, rows.line()};
    if (section.parent != noColumn && id == 0)
        rows.integer(at + section.parent, "-1 as the parent of the first segment", -1, -1);
    else if (section.parent != noColumn)
        point.link.parent = rows.integer(at + section.parent, "the index of a segment in its line, from 0", 0,
                                         static_cast<int>(maxScanCylinders));
    return point;
}

} // namespace

Result<ScanFile> readRayCloudTree(std::string_view text, const std::string& file) {
    ScanRows rows(text, file);
    Layout layout;
    if (!rows.next() || !readLayout(rows.words(), layout))
        rows.failLine("expected column names with x,y,z,radius and parent_id");
    ScanFile scan{"RayCloudTools", {}};
    std::size_t cylinders = 0;
    while (rows.good() && rows.next()) {
        const std::size_t count = rows.words().size(), least = layout.treeValues + layout.first.width;
        cylinders += count / layout.others.width;
        if (count < least + layout.others.width || (count - least) % layout.others.width != 0)
            rows.failLine("expected " + std::to_string(least) + " values and then " +
                          std::to_string(layout.others.width) + " for each further segment, found " +
                          std::to_string(count));
        else if (cylinders > maxScanCylinders)
            rows.failLine("expected at most " + std::to_string(maxScanCylinders) + " segments");
        if (!rows.good())
            break;
        std::vector<ScanPoint> points = {readSegment(rows, layout.treeValues, layout.first, 0)};
        for (std::size_t at = least; at < count && rows.good(); at += layout.others.width)
            points.push_back(readSegment(rows, at, layout.others, static_cast<int>(points.size())));
        if (!rows.good())
            break;
        Result<ScanCylinders> tree = makeCylinders(points, -1, file);
        if (!tree)
            return tree.problems();
        scan.trees.push_back(std::move(tree.value()));
    }
    if (rows.good() && scan.trees.empty())
        rows.failLine("expected at least one tree after the header");
    if (!rows.good())
        return rows.problem();
    return scan;
}

} // namespace osgTreeWind

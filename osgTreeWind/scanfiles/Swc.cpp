// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanFormats.h>
#include <osgTreeWind/scanfiles/ScanLinks.h>
#include <osgTreeWind/scanfiles/ScanRows.h>

namespace osgTreeWind {

Result<ScanFile> readSwc(std::string_view text, const std::string& file) {
    constexpr int most = 1000000000;
    ScanRows rows(text, file);
    std::vector<ScanPoint> points;
    while (rows.good() && rows.next()) {
        const std::size_t count = rows.words().size();
        if (count != 7)
            rows.failLine("expected 7 numbers: id, type, x, y, z, radius, parent; found " +
                          std::to_string(count) + " words");
        else if (points.size() > maxScanCylinders)
            rows.failLine("expected at most " + std::to_string(maxScanCylinders) + " points");
        if (!rows.good())
            break;
        ScanPoint point;
        point.link.id = rows.integer(0, "a whole number from 0 on", 0, most);
        for (int i = 0; i < 3; ++i)
            point.place[i] = rows.number(2 + static_cast<std::size_t>(i), scanMetres);
        point.radius = rows.number(5, scanRadius);
        point.link.parent = rows.integer(6, "the id of a point, or -1", -1, most);
        point.link.line = rows.line();
        points.push_back(point);
    }
    if (!rows.good())
        return rows.problem();
    Result<ScanCylinders> tree = makeCylinders(points, -1, file);
    if (!tree)
        return tree.problems();
    return ScanFile{"SWC", {std::move(tree.value())}};
}

} // namespace osgTreeWind

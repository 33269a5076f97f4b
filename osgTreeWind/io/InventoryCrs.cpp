// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventoryCrs.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/io/ForestSections.h>

#include <glm/common.hpp>

namespace osgTreeWind {

namespace {

/// What places are in; empty: what the forest is in.
Result<std::optional<Crs>> sourceOf(const std::string& text, const TreeRows& rows,
                                    const InventoryColumns& columns) {
    Result<Crs> given = Crs();
    if (!text.empty())
        given = Crs::parse(text);
    else if (columns.areDegrees(rows))
        given = Crs::degrees();
    else if (rows.crs())
        given = *rows.crs();
    else
        return std::optional<Crs>();
    if (!given)
        return given.problems();
    return std::optional(given.value());
}

/// The UTM zone of the middle of all places; what is wrong with rows is told when they become trees.
Result<Crs> zoneOf(TreeRows& rows, const InventoryColumns& columns, const Crs& source) {
    glm::dvec2 low(1e300), high(-1e300);
    rows.rewind();
    for (auto found = rows.next(); found && found.value(); found = rows.next())
        if (const auto place = placeOfRow(rows, columns, CrsWay())) {
            low = glm::min(low, glm::dvec2(place.value().position));
            high = glm::max(high, glm::dvec2(place.value().position));
        }
    return utmZoneOf(low.x <= high.x ? 0.5 * (low + high) : glm::dvec2(0.0), source, "crs");
}

} // namespace

std::optional<CrsWay> wayOfInventory(TableReader& table, TreeRows* rows, const InventoryColumns& columns,
                                     ForestReading& reading) {
    std::string text;
    table.read("crs", text);
    if (!rows || !columns.complete())
        return std::nullopt;
    const auto fail = [&](const Diagnostics& problems) {
        table.problem(text.empty() ? "file" : "crs", problems.front().message);
        return std::nullopt;
    };
    const auto source = sourceOf(text, *rows, columns);
    if (!source)
        return fail(source.problems());
    if (!source.value())
        return CrsWay();
    const Crs& from = *source.value();
    if (columns.hasXY() && (columns.x.unit != 1.0 || columns.y.unit != 1.0)) {
        table.problem("units", "expected no units of x and y: those of " + from.name() + " count");
        return std::nullopt;
    }
    if (!reading.crs) {
        const bool isMap = from.problemOfMap().empty();
        const Result<Crs> chosen = isMap ? Result<Crs>(from) : zoneOf(*rows, columns, from);
        if (!chosen)
            return fail(chosen.problems());
        reading.choose(chosen.value());
    }
    const auto way = CrsWay::between(from, *reading.crs);
    if (!way)
        return fail(way.problems());
    return way.value();
}

Result<double> metresOfRow(const TreeRows& rows, const Measure& measure) {
    Result<double> number = rows.number(*measure.column);
    if (!number)
        return number;
    const double metres = number.value() * measure.unit;
    if (!measure.range.contains(metres))
        return rows.problem(rows.columns()[*measure.column], "expected " + measure.range.text() +
                                                                 " metres, found " +
                                                                 inQuotes(rows.text(*measure.column)));
    return metres;
}

Result<VectorPlace> placeOfRow(const TreeRows& rows, const InventoryColumns& columns, const CrsWay& way) {
    VectorPlace place;
    Diagnostics problems;
    const auto take = [&](const auto& result) {
        problems.insert(problems.end(), result.problems().begin(), result.problems().end());
        return result ? result.value() : std::decay_t<decltype(result.value())>();
    };
    if (columns.hasXY()) {
        const double x = take(metresOfRow(rows, columns.x)), y = take(metresOfRow(rows, columns.y));
        glm::dvec2 flat{x, y};
        if (problems.empty() && !way.go(flat))
            problems.push_back(rows.problem("", "the place (" + numberText(x) + ", " + numberText(y) +
                                                    ") cannot be brought into the crs of the forest"));
        place.position = {flat, 0.0};
    } else
        place = take(rows.place(way));
    place.position.z *= columns.z.unit;
    if (columns.z.column && rows.has(*columns.z.column)) {
        place.position.z = take(metresOfRow(rows, columns.z));
        place.hasHeight = true;
    }
    for (int axis = 0; axis < 3; ++axis)
        if (problems.empty() && !worldCoordinates.contains(place.position[axis]))
            problems.push_back(rows.problem("", "expected coordinates " + worldCoordinates.text() +
                                                    " metres, found " + numberText(place.position[axis])));
    if (!problems.empty())
        return problems;
    return place;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventoryPlaces.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/io/SceneMap.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

/// The CRS of the places; empty: that of the forest.
Result<std::optional<Crs>> findSourceCrs(const std::string& text, const TreeRows& rows,
                                         const InventoryColumns& columns) {
    Result<Crs> crs = Crs();
    if (!text.empty())
        crs = Crs::parse(text);
    else if (columns.areInDegrees(rows))
        crs = Crs::wgs84();
    else if (rows.crs())
        crs = *rows.crs();
    else
        return std::optional<Crs>();
    if (!crs)
        return crs.problems();
    return std::optional(crs.value());
}

/// Parses a place in one cell: "POINT (2.30 48.88)", GeoJSON, or latitude and longitude, "48.88, 2.30".
Result<glm::dvec2> parsePoint(const TreeRows& rows, std::size_t column) {
    const std::string cell = rows.text(column);
    std::vector<double> numbers;
    for (std::size_t at = 0; (at = cell.find_first_of("+-.0123456789", at)) != std::string::npos;) {
        const std::size_t end = std::min(cell.find_first_not_of("+-.0123456789eE", at), cell.size());
        if (const auto number = parseNumber(std::string_view(cell).substr(at, end - at)))
            numbers.push_back(*number);
        at = end;
    }
    const bool isNamed = cell.find("oint") != std::string::npos || cell.find("OINT") != std::string::npos;
    if (numbers.size() < 2)
        return rows.problem(rows.nameOf(column),
                            expectedFound("a place such as 48.88, 2.30 or POINT (2.30 48.88)", cell));
    const bool isNorthFirst = !isNamed && std::abs(numbers[0]) <= 90.0;
    return isNorthFirst ? glm::dvec2(numbers[1], numbers[0]) : glm::dvec2(numbers[0], numbers[1]);
}

/// The place of a row: from its columns, not yet transformed, or else its transformed geometry.
Result<VectorPlace> readPlace(const TreeRows& rows, const InventoryColumns& columns) {
    VectorPlace place;
    Diagnostics problems;
    const auto valueOf = [&](const auto& result) {
        problems.insert(problems.end(), result.problems().begin(), result.problems().end());
        return result ? result.value() : std::decay_t<decltype(result.value())>();
    };
    if (columns.point) {
        place.position = {valueOf(parsePoint(rows, *columns.point)), 0.0};
    } else if (columns.hasPlaceColumns()) {
        const double x = valueOf(readMetres(rows, columns.x)), y = valueOf(readMetres(rows, columns.y));
        place.position = {x, y, 0.0};
    } else
        place = valueOf(rows.place());
    place.position.z *= columns.z.unit;
    if (columns.z.column && rows.has(*columns.z.column)) {
        place.position.z = valueOf(readMetres(rows, columns.z));
        place.hasHeight = true;
    }
    if (!problems.empty())
        return problems;
    return place;
}

/// The untransformed places of all rows; NaN if a row has none, which is reported later. @param maxCount
/// stops after that many valid places.
std::vector<glm::dvec2> readPlaces(TreeRows& rows, const InventoryColumns& columns,
                                   std::size_t maxCount = std::numeric_limits<std::size_t>::max()) {
    std::vector<glm::dvec2> places;
    std::vector<std::size_t> read;
    for (const MeasureColumn* measure : {&columns.x, &columns.y, &columns.z})
        if (measure->column)
            read.push_back(*measure->column);
    if (columns.point)
        read.push_back(*columns.point);
    rows.rewind({}, read);
    std::size_t count = 0;
    for (auto found = rows.next(); found && found.value() && count < maxCount; found = rows.next()) {
        const auto place = readPlace(rows, columns);
        count += place.ok();
        places.push_back(place ? glm::dvec2(place.value().position)
                               : glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
    }
    return places;
}

glm::dvec2 centreOf(const std::vector<glm::dvec2>& places) {
    glm::dvec2 low(1e300), high(-1e300);
    for (const glm::dvec2& place : places)
        if (!std::isnan(place.x)) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    return low.x <= high.x ? 0.5 * (low + high) : glm::dvec2(0.0);
}

/// The CRS for a scene at the places of the rows: their own if it is a map, or else a UTM zone.
/// @param places gets all places if the zone depends on them.
Result<Crs> findSceneCrs(TreeRows& rows, const InventoryColumns& columns, const Crs& from,
                         const SceneMap& map, TableReader& table, std::vector<glm::dvec2>& places) {
    if (from.problemOfMap().empty())
        return map.crsAt(centreOf(readPlaces(rows, columns, 1)), from, table);
    places = readPlaces(rows, columns);
    return utmZoneOf(centreOf(places), from, "crs");
}

} // namespace

std::optional<InventoryPlaces> InventoryPlaces::find(TableReader& table, TreeRows* rows,
                                                     const InventoryColumns& columns, SceneMap& map) {
    std::string text;
    table.read("crs", text);
    if (!rows || !columns.isComplete())
        return std::nullopt;
    const auto fail = [&](const Diagnostics& problems) {
        table.problem(text.empty() ? "file" : "crs", problems.front().message);
        return std::nullopt;
    };
    const auto source = findSourceCrs(text, *rows, columns);
    if (!source)
        return fail(source.problems());
    if (!source.value())
        return InventoryPlaces();
    const Crs& from = *source.value();
    if (columns.hasPlaceColumns() && (columns.x.unit != 1.0 || columns.y.unit != 1.0)) {
        table.problem("units", "expected no units for x and y, which " + from.name() + " defines");
        return std::nullopt;
    }
    std::vector<glm::dvec2> places;
    if (!map.crs()) {
        const Result<Crs> scene = findSceneCrs(*rows, columns, from, map, table, places);
        if (!scene)
            return fail(scene.problems());
        map.set(scene.value());
    }
    const auto transform = CrsTransform::between(from, *map.crs());
    if (!transform)
        return fail(transform.problems());
    InventoryPlaces found;
    found._transform = transform.value();
    if (columns.hasPlaceColumns() && !found._transform.isIdentity()) {
        found._transformed = places.empty() ? readPlaces(*rows, columns) : std::move(places);
        found._transform.apply(found._transformed);
    }
    return found;
}

void InventoryPlaces::rewind(TreeRows& rows, InventoryColumns& columns) const {
    rows.rewind(_transform, columns.allColumns());
}

Result<VectorPlace> InventoryPlaces::placeOf(const TreeRows& rows, const InventoryColumns& columns,
                                             std::size_t index) const {
    Result<VectorPlace> place = readPlace(rows, columns);
    if (!place)
        return place;
    glm::dvec3& position = place.value().position;
    if (!_transformed.empty()) {
        if (index >= _transformed.size() || std::isnan(_transformed[index].x))
            return rows.problem("", "the place (" + numberText(position.x) + ", " + numberText(position.y) +
                                        ") cannot be transformed to the crs of the forest");
        position = {_transformed[index], position.z};
    }
    Diagnostics problems;
    for (int axis = 0; axis < 3; ++axis)
        if (problems.empty() && !worldCoordinates.contains(position[axis]))
            problems.push_back(rows.problem("", "expected coordinates " + worldCoordinates.text() +
                                                    " metres, found " + numberText(position[axis])));
    if (!problems.empty())
        return problems;
    return place;
}

Result<double> readMetres(const TreeRows& rows, const MeasureColumn& measure) {
    return readMetres(rows, measure, rows.number(*measure.column));
}

Result<double> readMetres(const TreeRows& rows, const MeasureColumn& measure,
                          const std::optional<double>& number) {
    const double metres = number.value_or(0.0) * measure.unit;
    if (number && measure.range.contains(metres))
        return metres;
    const std::string cell = rows.text(*measure.column);
    return rows.problem(rows.nameOf(*measure.column),
                        number ? "expected " + measure.range.text() + " metres, found " + inQuotes(cell)
                               : expectedFound("a number", cell));
}

} // namespace osgTreeWind

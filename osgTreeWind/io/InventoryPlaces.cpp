// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventoryPlaces.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/StretchedMap.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The place that one cell holds: "POINT (2.30 48.88)", GeoJSON, or latitude and longitude, "48.88, 2.30".
Result<glm::dvec2> pointOf(const TreeRows& rows, std::size_t column) {
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
        return rows.problem(rows.columns()[column],
                            expectedFound("a place such as 48.88, 2.30 or POINT (2.30 48.88)", cell));
    const bool isNorthFirst = !isNamed && std::abs(numbers[0]) <= 90.0;
    return isNorthFirst ? glm::dvec2(numbers[1], numbers[0]) : glm::dvec2(numbers[0], numbers[1]);
}

/// Where a row says that it is: in columns as they are, else where the way of its rows has brought it.
Result<VectorPlace> stated(const TreeRows& rows, const InventoryColumns& columns) {
    VectorPlace place;
    Diagnostics problems;
    const auto take = [&](const auto& result) {
        problems.insert(problems.end(), result.problems().begin(), result.problems().end());
        return result ? result.value() : std::decay_t<decltype(result.value())>();
    };
    if (columns.point) {
        place.position = {take(pointOf(rows, *columns.point)), 0.0};
    } else if (columns.hasXY()) {
        const double x = take(metresOfRow(rows, columns.x)), y = take(metresOfRow(rows, columns.y));
        place.position = {x, y, 0.0};
    } else
        place = take(rows.place());
    place.position.z *= columns.z.unit;
    if (columns.z.column && rows.has(*columns.z.column)) {
        place.position.z = take(metresOfRow(rows, columns.z));
        place.hasHeight = true;
    }
    if (!problems.empty())
        return problems;
    return place;
}

/// Where all rows are as they say it; NaN for one that does not. What is wrong with rows is told when they
/// become trees.
/// @param most of those that do say it: where the first ones are is enough for some.
std::vector<glm::dvec2> statedPlaces(TreeRows& rows, const InventoryColumns& columns,
                                     std::size_t most = std::numeric_limits<std::size_t>::max()) {
    std::vector<glm::dvec2> places;
    std::vector<std::size_t> read; // none would mean all
    for (const Measure* measure : {&columns.x, &columns.y, &columns.z})
        if (measure->column)
            read.push_back(*measure->column);
    if (columns.point)
        read.push_back(*columns.point);
    rows.rewind({}, read);
    std::size_t count = 0;
    for (auto found = rows.next(); found && found.value() && count < most; found = rows.next()) {
        const auto place = stated(rows, columns);
        count += place.ok();
        places.push_back(place ? glm::dvec2(place.value().position)
                               : glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
    }
    return places;
}

/// The middle of all places.
glm::dvec2 middleOf(const std::vector<glm::dvec2>& places) {
    glm::dvec2 low(1e300), high(-1e300);
    for (const glm::dvec2& place : places)
        if (!std::isnan(place.x)) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    return low.x <= high.x ? 0.5 * (low + high) : glm::dvec2(0.0);
}

} // namespace

std::optional<InventoryPlaces> InventoryPlaces::find(TableReader& table, TreeRows* rows,
                                                     const InventoryColumns& columns,
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
        return InventoryPlaces();
    const Crs& from = *source.value();
    if (columns.hasXY() && (columns.x.unit != 1.0 || columns.y.unit != 1.0)) {
        table.problem("units", "expected no units of x and y: those of " + from.name() + " count");
        return std::nullopt;
    }
    std::vector<glm::dvec2> places;
    if (!reading.crs) {
        const bool isMap = from.problemOfMap().empty();
        if (!isMap)
            places = statedPlaces(*rows, columns);
        const glm::dvec2 middle = middleOf(isMap ? statedPlaces(*rows, columns, 1) : places);
        const Result<Crs> chosen = isMap ? trueMapAt(middle, from, reading) : utmZoneOf(middle, from, "crs");
        if (!chosen)
            return fail(chosen.problems());
        reading.choose(chosen.value());
    }
    const auto way = CrsWay::between(from, *reading.crs);
    if (!way)
        return fail(way.problems());
    InventoryPlaces found;
    found._way = way.value();
    if (columns.hasXY() && !found._way.staysHere()) {
        found._there = places.empty() ? statedPlaces(*rows, columns) : std::move(places);
        found._way.go(found._there);
    }
    return found;
}

void InventoryPlaces::rewind(TreeRows& rows, InventoryColumns& columns) const {
    rows.rewind(_way, columns.all());
}

Result<VectorPlace> InventoryPlaces::of(const TreeRows& rows, const InventoryColumns& columns,
                                        std::size_t index) const {
    Result<VectorPlace> place = stated(rows, columns);
    if (!place)
        return place;
    glm::dvec3& position = place.value().position;
    if (!_there.empty()) {
        if (index >= _there.size() || std::isnan(_there[index].x))
            return rows.problem("", "the place (" + numberText(position.x) + ", " + numberText(position.y) +
                                        ") cannot be brought into the crs of the forest");
        position = {_there[index], position.z};
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

Result<double> metresOfRow(const TreeRows& rows, const Measure& measure) {
    return metresOfRow(rows, measure, rows.number(*measure.column));
}

Result<double> metresOfRow(const TreeRows& rows, const Measure& measure, const Result<double>& number) {
    if (!number)
        return number;
    const double metres = number.value() * measure.unit;
    if (!measure.range.contains(metres))
        return rows.problem(rows.columns()[*measure.column], "expected " + measure.range.text() +
                                                                 " metres, found " +
                                                                 inQuotes(rows.text(*measure.column)));
    return metres;
}

} // namespace osgTreeWind

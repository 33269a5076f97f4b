// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventoryPlaces.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/io/ForestSections.h>

#include <glm/common.hpp>

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

/// Where a row says that it is: in columns as they are, else where the way of its rows has brought it.
Result<VectorPlace> stated(const TreeRows& rows, const InventoryColumns& columns) {
    VectorPlace place;
    Diagnostics problems;
    const auto take = [&](const auto& result) {
        problems.insert(problems.end(), result.problems().begin(), result.problems().end());
        return result ? result.value() : std::decay_t<decltype(result.value())>();
    };
    if (columns.hasXY()) {
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
std::vector<glm::dvec2> statedPlaces(TreeRows& rows, const InventoryColumns& columns) {
    std::vector<glm::dvec2> places;
    std::vector<std::size_t> read; // none would mean all
    for (const Measure* measure : {&columns.x, &columns.y, &columns.z})
        if (measure->column)
            read.push_back(*measure->column);
    rows.rewind({}, read);
    for (auto found = rows.next(); found && found.value(); found = rows.next()) {
        const auto place = stated(rows, columns);
        places.push_back(place ? glm::dvec2(place.value().position)
                               : glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
    }
    return places;
}

/// The UTM zone of the middle of all places.
Result<Crs> zoneOf(const std::vector<glm::dvec2>& places, const Crs& source) {
    glm::dvec2 low(1e300), high(-1e300);
    for (const glm::dvec2& place : places)
        if (!std::isnan(place.x)) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    return utmZoneOf(low.x <= high.x ? 0.5 * (low + high) : glm::dvec2(0.0), source, "crs");
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
        const Result<Crs> chosen = isMap ? Result<Crs>(from) : zoneOf(places, from);
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

} // namespace osgTreeWind

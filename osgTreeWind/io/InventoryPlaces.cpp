// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventoryPlaces.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/io/SceneMap.h>
#include <osgTreeWind/places/PlaceText.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

/// Whether the first row with x and y has them in degrees, such as 9°58'51"E.
bool hasDegreesInText(TreeRows& rows, const InventoryColumns& columns) {
    if (!columns.x.column || !columns.y.column)
        return false;
    const std::size_t x = *columns.x.column, y = *columns.y.column;
    rows.rewind({}, {x, y});
    for (auto found = rows.next(); found && found.value(); found = rows.next())
        if (rows.has(x) && rows.has(y)) {
            const auto first = parseCoordinate(rows.text(x)), second = parseCoordinate(rows.text(y));
            return first && second && first->isDegrees && second->isDegrees;
        }
    return false;
}

/// The CRS of the places; empty: that of the forest. @param text the key `crs`. @param points may be null.
Result<std::optional<Crs>> findSourceCrs(const std::string& text, TreeRows& rows,
                                         const InventoryColumns& columns, const PointColumn* points,
                                         TableReader& table) {
    const Result<std::optional<Crs>> stated = points ? points->crs() : std::optional<Crs>();
    if (!stated)
        return stated;
    Result<Crs> crs = Crs();
    if (!text.empty())
        crs = Crs::parse(text);
    else if (stated.value())
        return stated;
    else if (points || columns.areInDegrees(rows) || (!rows.crs() && hasDegreesInText(rows, columns)))
        crs = Crs::wgs84();
    else if (rows.crs())
        crs = *rows.crs();
    else
        return std::optional<Crs>();
    if (!crs)
        return crs.problems();
    if (stated.value() && !stated.value()->isSame(crs.value()))
        table.note("crs overrides " + stated.value()->name() + ", which the cells of " +
                   inQuotes(rows.nameOf(*columns.point)) + " state");
    return std::optional(crs.value());
}

/// A number in the unit of its column, or degrees with minutes or letters.
Result<CoordinateText> readCoordinate(const TreeRows& rows, const MeasureColumn& measure, bool isDegrees) {
    const std::optional<double> number = rows.number(*measure.column);
    const auto written = number ? std::nullopt : parseCoordinate(rows.text(*measure.column));
    if (written && written->isDegrees && isDegrees)
        return *written;
    if (written && written->isDegrees)
        return rows.problem(rows.nameOf(*measure.column),
                            expectedFound("a number in the unit of the crs, which is not in degrees",
                                          rows.text(*measure.column)));
    const Result<double> metres = readMetres(rows, measure, number);
    if (!metres)
        return metres.problems();
    return CoordinateText{metres.value()};
}

/// The place in x and y. Letters count more than the names of the columns.
Result<glm::dvec2> readColumns(const TreeRows& rows, const InventoryColumns& columns, bool isDegrees) {
    const auto x = readCoordinate(rows, columns.x, isDegrees), y = readCoordinate(rows, columns.y, isDegrees);
    Diagnostics problems = x.problems();
    problems.insert(problems.end(), y.problems().begin(), y.problems().end());
    if (!problems.empty())
        return problems;
    const char first = x.value().axis, second = y.value().axis;
    if (first && first == second)
        return rows.problem(
            rows.nameOf(*columns.y.column),
            expectedFound("one coordinate with N or S, and one with E or W", rows.text(*columns.y.column)));
    const glm::dvec2 place(x.value().value, y.value().value);
    return first == 'y' || second == 'x' ? glm::dvec2(place.y, place.x) : place;
}

/// Whether a z stands for none: NaN, -9999, -32768, or the lowest number.
bool isNoHeight(double z) {
    return !worldCoordinates.contains(z) || z == -32768.0 || (z <= -999.0 && isMissing(z));
}

/// The place of a row: from x and y, not yet transformed, or else its transformed geometry.
/// @param points may be null. @param index of the row.
Result<VectorPlace> readPlace(const TreeRows& rows, const InventoryColumns& columns, bool isDegrees,
                              const PointColumn* points, std::size_t index) {
    VectorPlace place;
    Diagnostics problems;
    const auto valueOf = [&](const auto& result) {
        problems.insert(problems.end(), result.problems().begin(), result.problems().end());
        return result ? result.value() : std::decay_t<decltype(result.value())>();
    };
    if (columns.x.column)
        place.position = {valueOf(readColumns(rows, columns, isDegrees)), 0.0};
    else
        place = valueOf(points ? points->placeOf(rows, index) : rows.place());
    bool isMarked = place.hasHeight && isNoHeight(place.position.z);
    place.position.z *= columns.z.unit;
    if (columns.z.column && rows.has(*columns.z.column)) {
        const auto number = rows.number(*columns.z.column);
        isMarked = number ? isNoHeight(*number) : isMissing(rows.text(*columns.z.column));
        place.position.z = isMarked ? 0.0 : valueOf(readMetres(rows, columns.z, number));
        place.hasHeight = true;
    }
    if (isMarked) {
        place.position.z = std::numeric_limits<double>::quiet_NaN();
        place.hasHeight = false;
    }
    if (!problems.empty())
        return problems;
    return place;
}

/// The untransformed places of all rows; NaN if a row has none, which is reported later. @param maxCount
/// stops after that many valid places.
std::vector<glm::dvec2> readPlaces(TreeRows& rows, const InventoryColumns& columns, bool isDegrees,
                                   std::size_t maxCount = std::numeric_limits<std::size_t>::max()) {
    std::vector<glm::dvec2> places;
    std::vector<std::size_t> read;
    for (const MeasureColumn* measure : {&columns.x, &columns.y, &columns.z})
        if (measure->column)
            read.push_back(*measure->column);
    rows.rewind({}, read);
    std::size_t count = 0;
    for (auto found = rows.next(); found && found.value() && count < maxCount; found = rows.next()) {
        const auto place = readPlace(rows, columns, isDegrees, nullptr, 0);
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
/// @param places of a column; otherwise gets all places if the zone depends on them.
Result<Crs> findSceneCrs(TreeRows& rows, const InventoryColumns& columns, const Crs& from,
                         const SceneMap& map, TableReader& table, std::vector<glm::dvec2>& places) {
    const bool isMap = from.problemOfMap().empty();
    if (places.empty()) {
        auto found = readPlaces(rows, columns, from.isDegrees(), isMap ? 1 : SIZE_MAX);
        if (isMap)
            return map.crsAt(centreOf(found), from, table);
        places = std::move(found);
    } else if (isMap)
        return map.crsAt(centreOf(places), from, table);
    return utmZoneOf(centreOf(places), from, "crs");
}

const char* const adviceOnOrder[] = {"if their latitude stands first, set inventory.axis_order = \"yx\"",
                                     "if their longitude stands first, set inventory.axis_order = \"xy\""};

/// Whether places in degrees are on the globe only with their longitude and latitude exchanged.
bool areExchanged(const std::vector<glm::dvec2>& places) {
    std::size_t count = 0;
    for (const glm::dvec2& place : places)
        if (!std::isnan(place.x)) {
            ++count;
            if (std::abs(place.y) <= 90.0 || std::abs(place.y) > 180.0 || std::abs(place.x) > 90.0)
                return false;
        }
    return count > 0;
}

/// Reads `axis_order`: whether y stands first. @return false after a problem.
bool readAxisOrder(TableReader& table, const InventoryColumns& columns, std::optional<bool>& isYFirst) {
    table.readChoice<std::optional<bool>>("axis_order", isYFirst, {{"xy", false}, {"yx", true}});
    if (!isYFirst || !columns.x.column)
        return true;
    table.problem("axis_order", "applies to places in one column and to geometries; exchange columns.x and "
                                "columns.y instead");
    return false;
}

} // namespace

std::optional<InventoryPlaces> InventoryPlaces::find(TableReader& table, TreeRows* rows,
                                                     const InventoryColumns& columns, SceneMap& map) {
    std::string text;
    std::optional<bool> isYFirst;
    table.read("crs", text);
    if (!readAxisOrder(table, columns, isYFirst) || !rows || !columns.isComplete())
        return std::nullopt;
    const auto fail = [&](const Diagnostics& problems) {
        const std::string& key = problems.front().key;
        table.problem(key == "axis_order" ? key : text.empty() ? "file" : "crs", problems.front().message);
        return std::nullopt;
    };
    InventoryPlaces found;
    if (columns.point)
        found._points.emplace(*rows, *columns.point);
    else if (isYFirst.value_or(false))
        rows->setYFirst();
    PointColumn* const points = found._points ? &*found._points : nullptr;
    const auto source = findSourceCrs(text, *rows, columns, points, table);
    if (!source)
        return fail(source.problems());
    if (!source.value())
        return found;
    const Crs& from = *source.value();
    found._isDegrees = from.isDegrees();
    if (columns.x.column && (columns.x.unit != 1.0 || columns.y.unit != 1.0)) {
        table.problem("units", "expected no units for x and y, which " + from.name() + " defines");
        return std::nullopt;
    }
    std::vector<glm::dvec2> places;
    if (points) {
        if (const auto problems = points->order(isYFirst, from.isDegrees(), rows->nameOf(*columns.point));
            !problems.empty())
            return fail(problems);
        if (!points->note().empty())
            table.note(rows->file() + ": " + points->note());
        places = points->places();
    } else if (from.isDegrees() && !columns.x.column) {
        constexpr std::size_t samples = 100;
        places = readPlaces(*rows, columns, true, map.crs() ? samples : SIZE_MAX);
    }
    const bool hasOrder = from.isDegrees() && !columns.x.column;
    const std::string advice = adviceOnOrder[isYFirst.value_or(false)];
    if (hasOrder && areExchanged(places))
        return fail({keyProblem("", "its places are no longitudes and latitudes; " + advice)});
    if (!map.crs()) {
        const Result<Crs> scene = findSceneCrs(*rows, columns, from, map, table, places);
        if (!scene)
            return fail(scene.problems());
        map.set(scene.value());
    }
    const auto transform = CrsTransform::between(from, *map.crs());
    if (!transform)
        return fail(transform.problems());
    found._transform = transform.value();
    const auto first = std::find_if(places.begin(), places.end(),
                                    [](const glm::dvec2& place) { return std::isfinite(place.x); });
    if (hasOrder && first != places.end()) {
        found._exchanged = {*first, {first->y, first->x}, advice};
        for (glm::dvec2* place : {&found._exchanged->place, &found._exchanged->exchanged})
            found._transform.apply(*place);
    }
    if (points)
        points->transform(*rows, found._transform);
    else if (columns.x.column && !found._transform.isIdentity()) {
        found._transformed =
            places.empty() ? readPlaces(*rows, columns, from.isDegrees()) : std::move(places);
        found._transform.apply(found._transformed);
    }
    return found;
}

void InventoryPlaces::rewind(TreeRows& rows, InventoryColumns& columns) const {
    rows.rewind(_transform, columns.allColumns());
}

Result<VectorPlace> InventoryPlaces::placeOf(const TreeRows& rows, const InventoryColumns& columns,
                                             std::size_t index) const {
    Result<VectorPlace> place = readPlace(rows, columns, _isDegrees, _points ? &*_points : nullptr, index);
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
        if (problems.empty() && !worldCoordinates.contains(position[axis]) && !std::isnan(position[axis]))
            problems.push_back(rows.problem("", "expected coordinates " + worldCoordinates.text() +
                                                    " metres, found " + numberText(position[axis])));
    if (!problems.empty())
        return problems;
    return place;
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

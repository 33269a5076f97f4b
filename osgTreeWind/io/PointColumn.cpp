// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/PointColumn.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/places/PlaceText.h>

#include <cmath>
#include <limits>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t maxBatch = 4096;

/// The order of coordinates that the name of a column tells: whether the latitude is first.
std::optional<bool> orderByName(const std::string& name) {
    const std::string low = lower(name);
    if (low.rfind("geo_point", 0) == 0 || low == "geopoint") // Opendatasoft's
        return true;
    const std::size_t latitude = low.find("lat"), longitude = std::min(low.find("lon"), low.find("lng"));
    if (latitude == low.npos || longitude == low.npos)
        return std::nullopt;
    return latitude < longitude;
}

} // namespace

void PointColumn::read(TreeRows& rows) {
    Batch batch;
    rows.rewind({}, {_column});
    for (auto found = rows.next(); found && found.value(); found = rows.next()) {
        const std::string cell = rows.text(_column);
        const PlaceText place = parsePlace(cell);
        const std::size_t row = _places.size();
        const bool isPair = place.kind == PlaceText::Kind::Pair;
        _places.push_back({{place.place, place.z.value_or(0.0)}, place.z.has_value()});
        _orders.push_back(!isPair ? Order::Geometry : place.isOrdered ? Order::Known : Order::Pair);
        if (place.srid > 0)
            _srids.try_emplace(place.srid, cell);
        if (place.kind == PlaceText::Kind::None)
            _places[row].position.x = std::numeric_limits<double>::quiet_NaN();
        else if (place.kind == PlaceText::Kind::Geometry) {
            batch.rows.push_back(row);
            batch.texts.emplace_back(place.geometry);
        } else if (isPair && !place.isOrdered) {
            _pair = _pair.empty() ? cell : _pair;
            _hasBrackets &= place.hasBrackets;
            _mayBeYFirst &= std::abs(place.place.x) <= 90.0;
            _mayBeXFirst &= std::abs(place.place.y) <= 90.0;
        }
        if (batch.rows.size() == maxBatch)
            readBatch(batch, {});
    }
    readBatch(batch, {});
}

void PointColumn::readBatch(Batch& batch, const CrsTransform& transform) {
    if (batch.rows.empty())
        return;
    _hasGeometries = true;
    batch.texts.insert(batch.texts.begin(), {transform.from().text(), transform.to().text()});
    auto answer = MapProgram::shared()->request<GeometryBatch>(
        {MapRequest::Task::ReadGeometries, batch.texts, {}, {}, _isYFirst});
    const bool isGood = answer && answer.value().places.size() == batch.rows.size() &&
                        answer.value().srids.size() == batch.rows.size();
    for (std::size_t i = 0; i < batch.rows.size(); ++i) {
        if (!isGood) {
            _problems[batch.rows[i]] =
                answer ? "the map program cannot read it" : answer.problems().front().message;
            continue;
        }
        _places[batch.rows[i]] = answer.value().places[i];
        if (const int srid = answer.value().srids[i]; srid > 0)
            _srids.try_emplace(srid, batch.texts[i + 2]);
    }
    if (isGood)
        for (const PlaceProblem& problem : answer.value().problems)
            if (problem.index < batch.rows.size())
                _problems[batch.rows[problem.index]] = problem.message;
    batch = {};
}

Result<std::optional<Crs>> PointColumn::crs() const {
    if (_srids.empty())
        return std::optional<Crs>();
    if (_srids.size() > 1)
        return keyProblem("", "expected one SRID, found " + std::to_string(_srids.begin()->first) + " and " +
                                  std::to_string(std::next(_srids.begin())->first));
    const std::string code = std::to_string(_srids.begin()->first);
    auto crs = Crs::parse("EPSG:" + code);
    if (!crs)
        return keyProblem("", "the SRID " + code + " is not known: " + crs.problems().front().message);
    return std::optional(crs.value());
}

Diagnostics PointColumn::order(std::optional<bool> isYFirst, bool isDegrees, const std::string& name) {
    bool isPairYFirst = isYFirst.value_or(false);
    if (!isYFirst && isDegrees && !_pair.empty()) {
        const std::optional<bool> named = orderByName(name);
        if (_mayBeXFirst && _mayBeYFirst && !named && !_hasBrackets)
            return {keyProblem("axis_order", "missing: " + inQuotes(_pair) + " in " + inQuotes(name) +
                                                 " may have either order; expected \"yx\" if the latitude "
                                                 "stands first, or \"xy\" if the longitude does")};
        isPairYFirst = _mayBeYFirst && (!_mayBeXFirst || named.value_or(true));
    }
    if (!isYFirst && !_pair.empty())
        _note = "places in " + inQuotes(name) + " such as " + inQuotes(_pair) + " are read as " +
                (!isDegrees     ? "easting, northing (for the other order, set axis_order = \"yx\")"
                 : isPairYFirst ? "latitude, longitude (for the other order, set axis_order = \"xy\")"
                                : "longitude, latitude (for the other order, set axis_order = \"yx\")");
    _isYFirst = isYFirst.value_or(false);
    for (std::size_t row = 0; row < _places.size(); ++row)
        if (_orders[row] == Order::Pair ? isPairYFirst : _orders[row] == Order::Geometry && _isYFirst)
            std::swap(_places[row].position.x, _places[row].position.y);
    return {};
}

std::vector<glm::dvec2> PointColumn::places() const {
    std::vector<glm::dvec2> places;
    places.reserve(_places.size());
    for (const VectorPlace& place : _places)
        places.emplace_back(place.position);
    for (const auto& [row, message] : _problems)
        places[row] = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    return places;
}

void PointColumn::transform(TreeRows& rows, const CrsTransform& transform) {
    if (transform.isIdentity())
        return;
    std::vector<glm::dvec2> places = this->places();
    transform.apply(places);
    for (std::size_t row = 0; row < _places.size(); ++row)
        _places[row].position = {places[row], _places[row].position.z};
    if (!_hasGeometries)
        return;
    Batch batch; // outlines, whose width depends on the CRS
    rows.rewind({}, {_column});
    std::size_t row = 0;
    for (auto found = rows.next(); found && found.value(); found = rows.next(), ++row) {
        if (!_places[row].width || _problems.count(row) > 0)
            continue;
        const std::string cell = rows.text(_column);
        batch.rows.push_back(row);
        batch.texts.emplace_back(parsePlace(cell).geometry);
        if (batch.rows.size() == maxBatch)
            readBatch(batch, transform);
    }
    readBatch(batch, transform);
}

Result<VectorPlace> PointColumn::placeOf(const TreeRows& rows, std::size_t index) const {
    const std::string& name = rows.nameOf(_column);
    if (const auto problem = _problems.find(index); problem != _problems.end())
        return rows.problem(name, problem->second);
    if (index < _places.size() && std::isfinite(_places[index].position.x))
        return _places[index];
    const std::string cell = rows.text(_column);
    if (parsePlace(cell).kind != PlaceText::Kind::None)
        return rows.problem(name, "the place " + inQuotes(cell) +
                                      " cannot be transformed to the crs of the forest");
    return rows.problem(name,
                        expectedFound("a place such as POINT (2.30 48.88), 48.88, 2.30 or "
                                      "48°52'48\"N 2°18'0\"E, or a geometry as WKT, EWKT, EWKB or GeoJSON",
                                      cell));
}

} // namespace osgTreeWind

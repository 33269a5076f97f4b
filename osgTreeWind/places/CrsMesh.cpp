// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsMesh.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/WholeTurns.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double spacing = 1000.0; // metres
constexpr double mostSquares = 256.0;

} // namespace

/// A mesh whose points say nothing yet.
CrsMesh CrsMesh::squares(const glm::dvec2& low, const glm::dvec2& high, double fewest) {
    CrsMesh mesh;
    const glm::dvec2 squares = glm::clamp(glm::ceil((high - low) / spacing), fewest, mostSquares);
    mesh._low = low;
    mesh._step = glm::max((high - low) / squares, 1.0);
    mesh._count = glm::ivec2(squares) + 1;
    return mesh;
}

/// Where its points are here.
std::vector<glm::dvec2> CrsMesh::corners() const {
    std::vector<glm::dvec2> places;
    for (int y = 0; y < _count.y; ++y)
        for (int x = 0; x < _count.x; ++x)
            places.push_back(_low + _step * glm::dvec2(x, y));
    return places;
}

Result<CrsMesh> CrsMesh::over(const Crs& from, const Crs& to, const glm::dvec2& low, const glm::dvec2& high) {
    const Result<CrsWay> way = CrsWay::between(from, to), back = CrsWay::between(to, from);
    if (!way || !back)
        return (way ? back : way).problems();
    CrsMesh mesh = squares(low, high, 1.0);
    const bool isDegrees = mesh._isDegrees = to.isDegrees();
    const double ahead = isDegrees ? 1e-4 : 10.0; // to the north, some metres
    const std::vector<glm::dvec2> here = mesh.corners();
    std::vector<glm::dvec2> there = here;
    there.push_back(0.5 * (low + high));
    way.value().go(there);
    const glm::dvec2 middle = there.back();
    there.pop_back();
    std::vector<glm::dvec2> next = there;
    const auto aheadOf = [&](const glm::dvec2& place) { // never across a pole
        return isDegrees && place.y > 0.0 ? -ahead : ahead;
    };
    for (glm::dvec2& place : next)
        place.y += aheadOf(place);
    back.value().go(next);
    for (std::size_t i = 0; i < here.size(); ++i) {
        if (std::isnan(there[i].x) || std::isnan(next[i].x) || std::isnan(middle.x))
            return keyProblem("crs", "places of " + from.name() + " are not on " + to.name());
        const double north = aheadOf(there[i]);
        if (isDegrees)
            there[i].x += wholeTurns(there[i].x, middle.x);
        mesh._points.push_back({there[i], glm::normalize((next[i] - here[i]) / north)});
    }
    return mesh;
}

Result<CrsMesh> CrsMesh::smooth(const Crs& from, const Crs& to, const glm::dvec2& low,
                                const glm::dvec2& high) {
    const Result<CrsWay> way = CrsWay::between(from, to);
    if (!way)
        return way.problems();
    CrsMesh mesh = squares(low, high, 3.0);
    mesh._isDegrees = to.isDegrees();
    mesh._isSmooth = true;
    std::vector<glm::dvec2> there = mesh.corners();
    way.value().go(there);
    const glm::dvec2 middle = there[there.size() / 2];
    for (glm::dvec2& place : there) {
        if (mesh._isDegrees && !std::isnan(middle.x))
            place.x += wholeTurns(place.x, middle.x);
        mesh._points.push_back({place, glm::dvec2(0.0, 1.0)});
    }
    return mesh;
}

bool CrsMesh::covers(const glm::dvec2& place) const {
    const glm::dvec2 at = pointAt(place);
    return at.x >= -1.0 && at.y >= -1.0 && at.x <= _count.x && at.y <= _count.y;
}

/// Lagrange's cubics through the four points about a place, each way.
glm::dvec2 CrsMesh::cubic(const glm::dvec2& at) const {
    const glm::dvec2 first =
        glm::clamp(glm::floor(at) - 1.0, glm::dvec2(0.0), glm::dvec2(_count) - glm::dvec2(4.0));
    const auto weights = [](double t) {
        return std::array{-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0,
                          -t * (t - 1.0) * (t - 3.0) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0};
    };
    const auto x = weights(at.x - first.x), y = weights(at.y - first.y);
    glm::dvec2 sum(0.0);
    for (std::size_t row = 0; row < 4; ++row) {
        const Point* points =
            &_points[(static_cast<std::size_t>(first.y) + row) * static_cast<std::size_t>(_count.x) +
                     static_cast<std::size_t>(first.x)];
        for (std::size_t column = 0; column < 4; ++column)
            sum += y[row] * x[column] * points[column].there;
    }
    return sum;
}

glm::dvec2 CrsMesh::pointAt(const glm::dvec2& place) const {
    return (place - _low) / _step;
}

/// @param at counted in points from the first.
template <typename Value>
Value CrsMesh::between(const glm::dvec2& at, Value Point::*member) const {
    const glm::dvec2 first = glm::clamp(glm::floor(at), glm::dvec2(0.0), glm::dvec2(_count - 2)),
                     f = at - first;
    const auto index = static_cast<std::size_t>(first.y) * static_cast<std::size_t>(_count.x) +
                       static_cast<std::size_t>(first.x);
    const Point *south = &_points[index], *north = south + _count.x;
    return glm::mix(glm::mix(south[0].*member, south[1].*member, f.x),
                    glm::mix(north[0].*member, north[1].*member, f.x), f.y);
}

glm::dvec2 CrsMesh::there(const glm::dvec2& place) const {
    return _isSmooth ? cubic(pointAt(place)) : between(pointAt(place), &Point::there);
}

glm::dvec2 CrsMesh::north(const glm::dvec2& place) const {
    return glm::normalize(
        between(glm::clamp(pointAt(place), glm::dvec2(0.0), glm::dvec2(_count - 1)), &Point::north));
}

} // namespace osgTreeWind

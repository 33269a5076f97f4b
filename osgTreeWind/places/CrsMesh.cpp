// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsMesh.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/WholeTurns.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgTreeWind {

namespace {

constexpr double spacing = 1000.0; // metres
constexpr double mostSquares = 256.0;

} // namespace

Result<CrsMesh> CrsMesh::over(const Crs& from, const Crs& to, const glm::dvec2& low, const glm::dvec2& high) {
    const Result<CrsWay> way = CrsWay::between(from, to), back = CrsWay::between(to, from);
    if (!way || !back)
        return (way ? back : way).problems();
    CrsMesh mesh;
    const glm::dvec2 squares = glm::clamp(glm::ceil((high - low) / spacing), 1.0, mostSquares);
    mesh._low = low;
    mesh._step = glm::max((high - low) / squares, 1.0);
    mesh._count = glm::ivec2(squares) + 1;
    const bool isDegrees = mesh._isDegrees = to.isDegrees();
    const double ahead = isDegrees ? 1e-4 : 10.0; // to the north, some metres
    glm::dvec2 middle = 0.5 * (low + high);
    bool isThere = way.value().go(middle);
    for (int y = 0; y < mesh._count.y && isThere; ++y)
        for (int x = 0; x < mesh._count.x && isThere; ++x) {
            const glm::dvec2 here = low + mesh._step * glm::dvec2(x, y);
            glm::dvec2 there = here;
            isThere = way.value().go(there);
            const double north = isDegrees && there.y > 0.0 ? -ahead : ahead; // never across a pole
            glm::dvec2 next = there + glm::dvec2(0.0, north);
            isThere = isThere && back.value().go(next);
            if (isDegrees)
                there.x += wholeTurns(there.x, middle.x);
            mesh._points.push_back({there, glm::normalize((next - here) / north)});
        }
    if (!isThere)
        return keyProblem("crs", "places of " + from.name() + " are not on " + to.name());
    return mesh;
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
    return between(pointAt(place), &Point::there);
}

glm::dvec2 CrsMesh::north(const glm::dvec2& place) const {
    return glm::normalize(
        between(glm::clamp(pointAt(place), glm::dvec2(0.0), glm::dvec2(_count - 1)), &Point::north));
}

} // namespace osgTreeWind

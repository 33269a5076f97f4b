// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsMesh.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/LongitudeWrap.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double spacing = 1000.0; // metres
constexpr double maxCells = 256.0;

} // namespace

CrsMesh CrsMesh::makeGrid(const glm::dvec2& low, const glm::dvec2& high, double minCells) {
    CrsMesh mesh;
    const glm::dvec2 cells = glm::clamp(glm::ceil((high - low) / spacing), minCells, maxCells);
    mesh._low = low;
    mesh._step = glm::max((high - low) / cells, 1.0);
    mesh._count = glm::ivec2(cells) + 1;
    return mesh;
}

std::vector<glm::dvec2> CrsMesh::gridPoints() const {
    std::vector<glm::dvec2> places;
    for (int y = 0; y < _count.y; ++y)
        for (int x = 0; x < _count.x; ++x)
            places.push_back(_low + _step * glm::dvec2(x, y));
    return places;
}

Result<CrsMesh> CrsMesh::makeLinear(const Crs& from, const Crs& to, const glm::dvec2& low,
                                    const glm::dvec2& high) {
    const Result<CrsTransform> transform = CrsTransform::between(from, to),
                               inverse = CrsTransform::between(to, from);
    if (!transform || !inverse)
        return (transform ? inverse : transform).problems();
    CrsMesh mesh = makeGrid(low, high, 1.0);
    const bool isDegrees = mesh._isDegrees = to.isDegrees();
    const double step = isDegrees ? 1e-4 : 10.0; // about 10 m
    const std::vector<glm::dvec2> sources = mesh.gridPoints();
    std::vector<glm::dvec2> targets = sources;
    targets.push_back(0.5 * (low + high));
    transform.value().apply(targets);
    const glm::dvec2 middle = targets.back();
    targets.pop_back();
    std::vector<glm::dvec2> shifted = targets; // northward, or southward to stay clear of the north pole
    const auto shiftAt = [&](const glm::dvec2& place) { return isDegrees && place.y > 0.0 ? -step : step; };
    for (glm::dvec2& place : shifted)
        place.y += shiftAt(place);
    inverse.value().apply(shifted);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (std::isnan(targets[i].x) || std::isnan(shifted[i].x) || std::isnan(middle.x))
            return keyProblem("crs", "places of " + from.name() + " are not on " + to.name());
        const double shift = shiftAt(targets[i]);
        if (isDegrees)
            targets[i].x += longitudeWrap(targets[i].x, middle.x);
        mesh._points.push_back({targets[i], glm::normalize((shifted[i] - sources[i]) / shift)});
    }
    return mesh;
}

Result<CrsMesh> CrsMesh::makeCubic(const Crs& from, const Crs& to, const glm::dvec2& low,
                                   const glm::dvec2& high) {
    const Result<CrsTransform> transform = CrsTransform::between(from, to);
    if (!transform)
        return transform.problems();
    CrsMesh mesh = makeGrid(low, high, 3.0);
    mesh._isDegrees = to.isDegrees();
    mesh._isCubic = true;
    std::vector<glm::dvec2> targets = mesh.gridPoints();
    transform.value().apply(targets);
    const glm::dvec2 middle = targets[targets.size() / 2];
    for (glm::dvec2& place : targets) {
        if (mesh._isDegrees && !std::isnan(middle.x))
            place.x += longitudeWrap(place.x, middle.x);
        mesh._points.push_back({place, glm::dvec2(0.0, 1.0)});
    }
    return mesh;
}

bool CrsMesh::covers(const glm::dvec2& place) const {
    const glm::dvec2 at = gridCoordinates(place);
    return at.x >= -1.0 && at.y >= -1.0 && at.x <= _count.x && at.y <= _count.y;
}

/// Lagrange interpolation through the nearest 4 x 4 points.
glm::dvec2 CrsMesh::interpolateCubic(const glm::dvec2& at) const {
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
            sum += y[row] * x[column] * points[column].target;
    }
    return sum;
}

glm::dvec2 CrsMesh::gridCoordinates(const glm::dvec2& place) const {
    return (place - _low) / _step;
}

template <typename Value>
Value CrsMesh::interpolateLinear(const glm::dvec2& at, Value Point::*member) const {
    const glm::dvec2 first = glm::clamp(glm::floor(at), glm::dvec2(0.0), glm::dvec2(_count - 2)),
                     f = at - first;
    const auto index = static_cast<std::size_t>(first.y) * static_cast<std::size_t>(_count.x) +
                       static_cast<std::size_t>(first.x);
    const Point *south = &_points[index], *north = south + _count.x;
    return glm::mix(glm::mix(south[0].*member, south[1].*member, f.x),
                    glm::mix(north[0].*member, north[1].*member, f.x), f.y);
}

glm::dvec2 CrsMesh::transformed(const glm::dvec2& place) const {
    return _isCubic ? interpolateCubic(gridCoordinates(place))
                    : interpolateLinear(gridCoordinates(place), &Point::target);
}

glm::dvec2 CrsMesh::north(const glm::dvec2& place) const {
    return glm::normalize(interpolateLinear(
        glm::clamp(gridCoordinates(place), glm::dvec2(0.0), glm::dvec2(_count - 1)), &Point::north));
}

} // namespace osgTreeWind

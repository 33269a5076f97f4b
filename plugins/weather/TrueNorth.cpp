// SPDX-License-Identifier: MIT
#include <plugins/weather/TrueNorth.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/places/CrsTransform.h>
#include <plugins/map/GdalErrors.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Transforms all places at once, ten times faster than one by one.
bool transformAll(const CrsTransform& transform, std::vector<glm::dvec2>& places) {
    if (!transform.handle() || places.empty())
        return true;
    const GdalErrors errors;
    std::vector<double> x, y;
    for (const glm::dvec2& place : places) {
        x.push_back(place.x);
        y.push_back(place.y);
    }
    if (!OCTTransform(transform.handle(), static_cast<int>(places.size()), x.data(), y.data(), nullptr))
        return false;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = {x[i], y[i]};
        if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
            return false;
    }
    return true;
}

/// Unit vectors toward true north at some points, in the axes of their CRS; empty if it does not cover them.
/// @param map CRS of the points, in metres or degrees.
std::vector<glm::dvec2> directionsOfTrueNorth(const Crs& map, std::vector<glm::dvec2> points) {
    const Crs globe = Crs::wgs84();
    const auto there = CrsTransform::between(map, globe), back = CrsTransform::between(globe, map);
    std::vector<glm::dvec2> places = points;
    if (!there || !back || !transformAll(there.value(), places))
        return {};
    std::vector<double> steps;
    for (glm::dvec2& place : places) {
        steps.push_back(place.y > 0.0 ? -1e-4 : 1e-4); // some metres, never across a pole
        place.y += steps.back();
    }
    // The start points are transformed back as well, so that datum and seam affect both ends equally.
    std::vector<glm::dvec2> starts = places;
    for (std::size_t i = 0; i < starts.size(); ++i)
        starts[i].y -= steps[i];
    if (!transformAll(back.value(), places) || !transformAll(back.value(), starts))
        return {};
    for (std::size_t i = 0; i < points.size(); ++i) {
        glm::dvec2 way = (places[i] - starts[i]) / steps[i];
        if (map.isDegrees())
            way.x = (way.x - 360.0 / steps[i] * std::round(way.x * steps[i] / 360.0)) *
                    math::cos(glm::radians(points[i].y));
        points[i] = glm::normalize(way);
    }
    return points;
}

/// For example "-15.75 to 15.75 degrees clockwise".
std::string rangeOf(const std::vector<glm::dvec2>& norths) {
    double least = 360.0, most = -360.0;
    for (const glm::dvec2& north : norths) {
        const double degrees = glm::degrees(math::atan2(north.x, north.y));
        least = std::min(least, degrees);
        most = std::max(most, degrees);
    }
    const auto rounded = [](double degrees) { return numberText(std::round(100.0 * degrees) / 100.0); };
    return rounded(least) + " to " + rounded(most) + " degrees clockwise";
}

} // namespace

std::optional<std::string> turnFromTrueNorth(GridWind::Grid& grid, const Crs& map, bool asStored) {
    std::vector<glm::dvec2> points;
    for (int y = 0; y < grid.points.y; ++y)
        for (int x = 0; x < grid.points.x; ++x)
            points.emplace_back(grid.origin.x + grid.cell.x * x, grid.origin.y + grid.cell.y * y);
    const std::vector<glm::dvec2> norths = directionsOfTrueNorth(map, points);
    if (norths.empty())
        return std::nullopt;
    for (std::size_t i = 0; !asStored && i < grid.values.size(); i += 3) {
        const glm::dvec2 north = norths[i / 3 % norths.size()];
        const double u = grid.values[i], v = grid.values[i + 1];
        grid.values[i] = static_cast<float>(u * north.y + v * north.x);
        grid.values[i + 1] = static_cast<float>(v * north.y - u * north.x);
    }
    return "velocities in the file are relative to true north; " +
           std::string(asStored ? "in a forest they" : "they") + " are turned to the grid's y axis, by " +
           rangeOf(norths);
}

} // namespace osgTreeWind

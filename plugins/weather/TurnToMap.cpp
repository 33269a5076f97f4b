// SPDX-License-Identifier: MIT
#include <plugins/weather/TurnToMap.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/places/CrsWay.h>
#include <plugins/map/GdalErrors.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// All places at once: one by one takes ten times as long.
bool go(const CrsWay& way, std::vector<glm::dvec2>& places) {
    if (!way.transformation() || places.empty())
        return true;
    const GdalErrors errors;
    std::vector<double> x, y;
    for (const glm::dvec2& place : places) {
        x.push_back(place.x);
        y.push_back(place.y);
    }
    if (!OCTTransform(way.transformation(), static_cast<int>(places.size()), x.data(), y.data(), nullptr))
        return false;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = {x[i], y[i]};
        if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
            return false;
    }
    return true;
}

/// The way true north lies at points of a map: unit vectors along its x and y. Empty where it cannot say.
/// @param map in metres, or on degrees. @param points on it.
std::vector<glm::dvec2> trueNorth(const Crs& map, std::vector<glm::dvec2> points) {
    const Crs globe = Crs::degrees();
    const auto there = CrsWay::between(map, globe), back = CrsWay::between(globe, map);
    std::vector<glm::dvec2> places = points;
    if (!there || !back || !go(there.value(), places))
        return {};
    std::vector<double> steps;
    for (glm::dvec2& place : places) {
        steps.push_back(place.y > 0.0 ? -1e-4 : 1e-4); // some metres, never across a pole
        place.y += steps.back();
    }
    // There and back again: what the way does to heights of the globe and its seam it does to both.
    std::vector<glm::dvec2> starts = places;
    for (std::size_t i = 0; i < starts.size(); ++i)
        starts[i].y -= steps[i];
    if (!go(back.value(), places) || !go(back.value(), starts))
        return {};
    for (std::size_t i = 0; i < points.size(); ++i) {
        glm::dvec2 way = (places[i] - starts[i]) / steps[i];
        if (map.isDegrees())
            way.x = (way.x - 360.0 / steps[i] * std::round(way.x * steps[i] / 360.0)) *
                    std::cos(glm::radians(points[i].y));
        points[i] = glm::normalize(way);
    }
    return points;
}

/// "-15.75 to 15.75 degrees clockwise"
std::string rangeOf(const std::vector<glm::dvec2>& norths) {
    double least = 360.0, most = -360.0;
    for (const glm::dvec2& north : norths) {
        const double degrees = glm::degrees(std::atan2(north.x, north.y));
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
    const std::vector<glm::dvec2> norths = trueNorth(map, points);
    if (norths.empty())
        return std::nullopt;
    for (std::size_t i = 0; !asStored && i < grid.values.size(); i += 3) {
        const glm::dvec2 north = norths[i / 3 % norths.size()];
        const double u = grid.values[i], v = grid.values[i + 1];
        grid.values[i] = static_cast<float>(u * north.y + v * north.x);
        grid.values[i + 1] = static_cast<float>(v * north.y - u * north.x);
    }
    return "the file counts from true north; " +
           std::string(asStored ? "in a forest its velocities" : "velocities here") +
           " are turned to the grid's y axis, by " + rangeOf(norths);
}

} // namespace osgTreeWind

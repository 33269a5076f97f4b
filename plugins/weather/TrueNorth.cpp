// SPDX-License-Identifier: MIT
#include <plugins/weather/TrueNorth.h>

#include <osgTreeWind/places/CrsWay.h>
#include <plugins/map/GdalErrors.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <ogr_srs_api.h>

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

} // namespace

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

} // namespace osgTreeWind

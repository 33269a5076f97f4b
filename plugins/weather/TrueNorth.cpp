// SPDX-License-Identifier: MIT
#include <plugins/weather/TrueNorth.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/places/CrsWay.h>
#include <osgTreeWind/places/GdalErrors.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Longitudes and latitudes on the same globe as a map; nothing where it has none.
Result<Crs> globeOf(const Crs& map) {
    const OGRSpatialReferenceH globe = OSRCloneGeogCS(map.reference());
    if (!globe)
        return Crs::degrees();
    OSRSetAxisMappingStrategy(globe, OAMS_TRADITIONAL_GIS_ORDER);
    return Crs(globe);
}

bool go(const CrsWay& way, std::vector<double>& x, std::vector<double>& y) {
    const GdalErrors errors;
    return !way.transformation() ||
           (OCTTransform(way.transformation(), static_cast<int>(x.size()), x.data(), y.data(), nullptr) &&
            std::all_of(x.begin(), x.end(), [](double each) { return std::isfinite(each); }));
}

} // namespace

std::vector<glm::dvec2> trueNorth(const Crs& map, const std::vector<glm::dvec2>& points) {
    const Result<Crs> globe = globeOf(map);
    if (!globe)
        return {};
    const auto toGlobe = CrsWay::between(map, globe.value()), toMap = CrsWay::between(globe.value(), map);
    std::vector<double> x, y, steps;
    for (const glm::dvec2& point : points) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    if (!toGlobe || !toMap || !go(toGlobe.value(), x, y))
        return {};
    for (double& latitude : y) {
        steps.push_back(latitude > 0.0 ? -1e-4 : 1e-4); // degrees: some metres, never across a pole
        latitude += steps.back();
    }
    if (!go(toMap.value(), x, y))
        return {};
    std::vector<glm::dvec2> norths;
    norths.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        norths.push_back(glm::normalize((glm::dvec2(x[i], y[i]) - points[i]) / steps[i]));
    return norths;
}

std::string rangeOfNorths(const std::vector<glm::dvec2>& norths) {
    double least = 360.0, most = -360.0;
    for (const glm::dvec2& north : norths) {
        const double degrees = glm::degrees(std::atan2(north.x, north.y));
        least = std::min(least, degrees);
        most = std::max(most, degrees);
    }
    const auto rounded = [](double degrees) { return numberText(std::round(100.0 * degrees) / 100.0); };
    return rounded(least) + " to " + rounded(most) + " degrees clockwise";
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindRequest.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/places/LongitudeWrap.h>

#include <glm/common.hpp>

namespace osgTreeWind {

namespace {

void setExtent(const AxisPart& points, const EvenAxis& axis, double mapOffset, double& low, double& high) {
    if (points.indices.size() < 2 || isCyclic(axis))
        return;
    low = points.first + mapOffset;
    high = low + points.step * static_cast<double>(points.indices.size() - 1);
}

} // namespace

WindExtent extentOf(const AxisPart& x, const EvenAxis& xAxis, const AxisPart& y, const EvenAxis& yAxis,
                    const glm::dvec2& mapOffset) {
    WindExtent extent;
    setExtent(x, xAxis, mapOffset.x, extent.low.x, extent.high.x);
    setExtent(y, yAxis, mapOffset.y, extent.low.y, extent.high.y);
    return extent;
}

Result<WindArea> areaOnMap(const std::string& crs, const WindArea& area) {
    WindArea there{crs, area.low, area.high};
    if (crs.empty() || area.crs.empty() || crs == area.crs)
        return there;
    const Result<Crs> from = Crs::parse(area.crs), to = Crs::parse(crs);
    if (!from || !to)
        return (from ? to : from).problems();
    const Result<CrsTransform> transform = CrsTransform::between(from.value(), to.value());
    if (!transform)
        return transform.problems();
    glm::dvec2 middle = 0.5 * (area.low + area.high);
    const auto notCovered = [&] {
        return keyProblem("crs", "the CRS of the file, " + to.value().name() +
                                     ", does not cover the area where wind is needed, in " +
                                     from.value().name());
    };
    if (!transform.value().apply(middle))
        return notCovered();
    there.low = there.high = middle;
    constexpr int steps = 8; // edges are curved in another CRS
    for (int y = 0; y <= steps; ++y)
        for (int x = 0; x <= steps; ++x) {
            glm::dvec2 place = glm::mix(area.low, area.high, glm::dvec2(x, y) / double(steps));
            if (!transform.value().apply(place))
                return notCovered();
            if (to.value().isDegrees())
                place.x += longitudeWrap(place.x, middle.x);
            there.low = glm::min(there.low, place);
            there.high = glm::max(there.high, place);
        }
    return there;
}

Result<GridPart> gridPartFor(const WindRequest& request, const std::string& crs, const EvenAxis& x,
                             const EvenAxis& y, const glm::dvec2& mapOffset) {
    const WindExtent fileExtent = extentOf(wholeAxis(x), x, wholeAxis(y), y, mapOffset);
    if (!request.area)
        return GridPart{wholeAxis(x), wholeAxis(y), fileExtent};
    const Result<WindArea> area = areaOnMap(crs, *request.area);
    if (!area)
        return area.problems();
    const glm::dvec2 low = area.value().low - mapOffset, high = area.value().high - mapOffset;
    return GridPart{partAround(x, low.x, high.x), partAround(y, low.y, high.y), fileExtent};
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindRequest.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/CrsWay.h>
#include <osgTreeWind/places/WholeTurns.h>

#include <glm/common.hpp>

namespace osgTreeWind {

namespace {

void takeExtent(const AxisPart& points, const EvenAxis& axis, double onMap, double& low, double& high) {
    if (points.indices.size() < 2 || isRound(axis))
        return;
    low = points.first + onMap;
    high = low + points.step * static_cast<double>(points.indices.size() - 1);
}

} // namespace

WindExtent extentOf(const AxisPart& x, const EvenAxis& xAxis, const AxisPart& y, const EvenAxis& yAxis,
                    const glm::dvec2& onMap) {
    WindExtent extent;
    takeExtent(x, xAxis, onMap.x, extent.low.x, extent.high.x);
    takeExtent(y, yAxis, onMap.y, extent.low.y, extent.high.y);
    return extent;
}

Result<WindArea> areaOn(const std::string& crs, const WindArea& area) {
    WindArea there{crs, area.low, area.high};
    if (crs.empty() || area.crs.empty() || crs == area.crs)
        return there;
    const Result<Crs> from = Crs::parse(area.crs), to = Crs::parse(crs);
    if (!from || !to)
        return (from ? to : from).problems();
    const Result<CrsWay> way = CrsWay::between(from.value(), to.value());
    if (!way)
        return way.problems();
    glm::dvec2 middle = 0.5 * (area.low + area.high);
    const auto nowhere = [&] {
        return keyProblem("crs", "the file's map, " + to.value().name() +
                                     ", does not hold the places where wind is "
                                     "wanted, on " +
                                     from.value().name());
    };
    if (!way.value().go(middle))
        return nowhere();
    there.low = there.high = middle;
    constexpr int steps = 8; // straight lines bend on another map
    for (int y = 0; y <= steps; ++y)
        for (int x = 0; x <= steps; ++x) {
            glm::dvec2 place = glm::mix(area.low, area.high, glm::dvec2(x, y) / double(steps));
            if (!way.value().go(place))
                return nowhere();
            if (to.value().isDegrees())
                place.x += wholeTurns(place.x, middle.x);
            there.low = glm::min(there.low, place);
            there.high = glm::max(there.high, place);
        }
    return there;
}

Result<GridPart> partFor(const WindRequest& request, const std::string& crs, const EvenAxis& x,
                         const EvenAxis& y, const glm::dvec2& onMap) {
    const WindExtent whole = extentOf(wholeOf(x), x, wholeOf(y), y, onMap);
    if (!request.area)
        return GridPart{wholeOf(x), wholeOf(y), whole};
    const Result<WindArea> area = areaOn(crs, *request.area);
    if (!area)
        return area.problems();
    const glm::dvec2 low = area.value().low - onMap, high = area.value().high - onMap;
    return GridPart{partAround(x, low.x, high.x), partAround(y, low.y, high.y), whole};
}

} // namespace osgTreeWind

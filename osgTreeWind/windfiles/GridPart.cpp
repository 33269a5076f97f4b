// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/GridPart.h>

namespace osgTreeWind {

Result<GridPart> partFor(const WindRequest& request, const std::string& crs, const EvenAxis& x,
                         const EvenAxis& y, const glm::dvec2& onMap) {
    if (!request.area)
        return GridPart{wholeOf(x), wholeOf(y)};
    const Result<WindArea> area = areaOn(crs, *request.area);
    if (!area)
        return area.problems();
    const glm::dvec2 low = area.value().low - onMap, high = area.value().high - onMap;
    return GridPart{partAround(x, low.x, high.x), partAround(y, low.y, high.y)};
}

} // namespace osgTreeWind

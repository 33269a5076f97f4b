// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/windfiles/EvenAxis.h>
#include <osgTreeWind/windfiles/WindRequest.h>

namespace osgTreeWind {

/// Points of a grid, in rows and columns.
struct GridPart {
    AxisPart x, y;
};

/// Those of a file that a request is for: around its area, or all. Problems as of areaOn().
/// @param crs of the file, as WindSummary::crs. @param onMap added to places on the axes it makes them those
/// of the file's map.
Result<GridPart> partFor(const WindRequest& request, const std::string& crs, const EvenAxis& x,
                         const EvenAxis& y, const glm::dvec2& onMap = glm::dvec2(0.0));

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/EvenAxis.h>
#include <osgTreeWind/windfiles/WindExtent.h>
#include <osgTreeWind/windfiles/WindSeriesColumns.h>

#include <glm/vec2.hpp>

#include <optional>
#include <string>

namespace osgTreeWind {

/// A rectangle on a map or on degrees: what lies well beyond it need not be read.
struct WindArea {
    std::string crs; ///< As Crs::text(); empty: that of the file, whatever it is.
    glm::dvec2 low{0.0}, high{0.0};
};

/// What is asked of the reader of a format.
struct WindRequest {
    WindSeriesColumns columns;    ///< Of a table.
    bool asStored = false;        ///< As in WindFileOptions.
    std::optional<WindArea> area; ///< Where wind is wanted; nothing: everywhere.
    std::string also;             ///< A second file with the other component, of NetCDF or GRIB; empty: none.
};

/// Where an area lies on the map of a file: what holds all of it, longitudes within half a turn of its
/// middle's. A file that does not say what its map is has that of the area. A problem where its map does not
/// hold it.
/// @param crs of the file, as WindSummary::crs.
Result<WindArea> areaOn(const std::string& crs, const WindArea& area);

/// Points of a grid, in rows and columns.
struct GridPart {
    AxisPart x, y;
    WindExtent whole; ///< Of the file.
};

/// Where points on two axes lie. @param onMap as below.
WindExtent extentOf(const AxisPart& x, const EvenAxis& xAxis, const AxisPart& y, const EvenAxis& yAxis,
                    const glm::dvec2& onMap);

/// Those of a file that a request is for: around its area, or all. Problems as of areaOn().
/// @param crs of the file, as WindSummary::crs. @param onMap added to places on the axes it makes them those
/// of the file's map.
Result<GridPart> partFor(const WindRequest& request, const std::string& crs, const EvenAxis& x,
                         const EvenAxis& y, const glm::dvec2& onMap = glm::dvec2(0.0));

} // namespace osgTreeWind

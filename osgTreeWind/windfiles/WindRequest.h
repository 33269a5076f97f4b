// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/EvenAxis.h>
#include <osgTreeWind/windfiles/WindExtent.h>
#include <osgTreeWind/windfiles/WindSeriesColumns.h>

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A rectangle in which wind is needed; readers may skip data far outside.
struct WindArea {
    std::string crs; ///< As Crs::text(); empty: the CRS of the file.
    glm::dvec2 low{0.0}, high{0.0};
};

/// Options for the reader of a format.
struct WindRequest {
    WindSeriesColumns columns;    ///< Columns of a table.
    bool asStored = false;        ///< As WindFileOptions::asStored.
    std::optional<WindArea> area; ///< Where wind is needed; empty: everywhere.
    std::string secondFile;       ///< NetCDF or GRIB file of the other component; empty if there is none.
    std::vector<std::string> variable; ///< As WindFileOptions::variable.
};

/// Bounding rectangle of an area in the CRS of a file, with longitudes within 180 degrees of its centre. A
/// problem if the CRS does not cover the area. @param crs as WindSummary::crs; if empty, the file is in the
/// CRS of the area.
Result<WindArea> areaOnMap(const std::string& crs, const WindArea& area);

/// A rectangular part of the grid of a file.
struct GridPart {
    AxisPart x, y;
    WindExtent fileExtent; ///< Extent of the whole file.
};

/// Extent of some points on two axes. @param mapOffset as for gridPartFor().
WindExtent extentOf(const AxisPart& x, const EvenAxis& xAxis, const AxisPart& y, const EvenAxis& yAxis,
                    const glm::dvec2& mapOffset);

/// The part of a grid around the requested area, or all of it. Problems as for areaOnMap().
/// @param crs as WindSummary::crs. @param mapOffset added to coordinates on the axes to get coordinates in
/// the CRS.
Result<GridPart> gridPartFor(const WindRequest& request, const std::string& crs, const EvenAxis& x,
                             const EvenAxis& y, const glm::dvec2& mapOffset = glm::dvec2(0.0));

} // namespace osgTreeWind

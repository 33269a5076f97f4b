// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
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
};

/// Where an area lies on the map of a file: what holds all of it, longitudes within half a turn of its
/// middle's. A file that does not say what its map is has that of the area. A problem where its map does not
/// hold it.
/// @param crs of the file, as WindSummary::crs.
Result<WindArea> areaOn(const std::string& crs, const WindArea& area);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfPoints.h>

#include <osgTreeWind/windfiles/WindContent.h>

#include <optional>

namespace osgTreeWind {

/// Reads the CRS of a wind array and the axes of the points in it; empty if the file has no CRS. Fails for
/// curvilinear grids, whose longitudes and latitudes are not axes.
std::optional<Crs> readCrs(NetCdfFile& file, const NetCdfArray& wind, NetCdfPoints& points,
                           WindSummary& summary);

/// The name of a CRS, or its PROJ text if it has no name.
std::string nameOf(const Crs& crs);

/// Whether its longitudes and latitudes are relative to a rotated pole.
bool isRotated(const Crs& crs);

} // namespace osgTreeWind

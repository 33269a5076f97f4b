// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfPoints.h>

#include <osgTreeWind/windfiles/WindContent.h>

#include <optional>

namespace osgTreeWind {

/// The map of an array of wind; nothing where the file does not say. Places the points' axes on it. Fails
/// where it is on degrees that are no axes of their own.
std::optional<Crs> mapOf(NetCdfFile& file, const NetCdfArray& wind, NetCdfPoints& points,
                         WindSummary& summary);

/// As people call it: its name, or its PROJ text where it has none.
std::string nameOf(const Crs& crs);

/// Whether its longitudes and latitudes are not those of the globe, but of a turned one.
bool isRotated(const Crs& crs);

} // namespace osgTreeWind

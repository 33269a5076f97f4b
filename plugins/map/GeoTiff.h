// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/MapCells.h>

namespace osgTreeWind {

/// As readGeoTiffCells() says.
Result<MapCells> readTiffCells(const std::string& path);

} // namespace osgTreeWind

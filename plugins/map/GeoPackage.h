// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/MapMessages.h>

namespace osgTreeWind {

/// As writeGeoPackage() says.
Result<MapDone> writeTable(const PointTable& table, const std::string& path);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/PointTable.h>

#include <osgTreeWind/places/MapProgram.h>

namespace osgTreeWind {

Diagnostics writeGeoPackage(PointTable table, const std::string& path) {
    return MapProgram({path}).ask<MapDone>({MapQuestion::Task::WriteTable, {path}}, table).problems();
}

} // namespace osgTreeWind

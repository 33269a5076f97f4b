// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/MapCells.h>

#include <osgTreeWind/places/MapProgram.h>

namespace osgTreeWind {

Result<MapCells> readGeoTiffCells(const std::string& path) {
    return MapProgram({path}).ask<MapCells>({MapQuestion::Task::ReadCells, {path}});
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/GridMapping.h>

#include <osgTreeWind/places/MapProgram.h>

namespace osgTreeWind {

Result<GridMapping> gridMappingOf(const Crs& map) {
    return MapProgram::shared()->ask<GridMapping>({MapQuestion::Task::DescribeMap, {map.text()}});
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/map/GdalCrs.h>

#include <osgTreeWind/places/GridMapping.h>

namespace osgTreeWind {

/// As gridMappingOf() says.
GridMapping cfGridMapping(const GdalCrs& map);

} // namespace osgTreeWind

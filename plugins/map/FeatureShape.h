// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsWay.h>
#include <osgTreeWind/places/MapMessages.h>

namespace osgTreeWind {

/// Where an OGRGeometryH is, if it is a point or an outline; null is an error, too.
Result<VectorPlace> placeOf(void* geometry, const CrsWay& way);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/species/Appearance.h>

namespace osgTreeWind {

/// One blade, leaflet or needle of a form, as floras draw it.
LeafOutline leafOutline(LeafForm form);

} // namespace osgTreeWind

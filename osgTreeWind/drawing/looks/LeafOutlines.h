// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/species/Appearance.h>

namespace osgTreeWind {

/// The outline of one blade, leaflet or needle of a form, as drawn in floras.
LeafOutline leafOutline(LeafForm form);

} // namespace osgTreeWind

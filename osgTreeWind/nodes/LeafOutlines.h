// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/Appearance.h>
#include <osgTreeWind/nodes/SprayCanvas.h>

namespace osgTreeWind {

/// One blade, leaflet or needle of a form, as floras draw it.
LeafOutline leafOutline(LeafForm form);

} // namespace osgTreeWind

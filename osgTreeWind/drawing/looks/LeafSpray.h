// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>
#include <osgTreeWind/species/Appearance.h>

namespace osgTreeWind {

/// Paints what a leaf card of about half a metre shows: a twig that springs from the middle of its lower
/// edge, branches, and bears leaves as large and in such order as the genus has them. A frond is one leaf.
LeafTexels paintSpray(LeafForm form);

} // namespace osgTreeWind

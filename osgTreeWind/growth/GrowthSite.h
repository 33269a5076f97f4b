// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace osgTreeWind {

/// What stands around a tree while it grows. Neighbours grow as high as the tree.
struct GrowthSite {
    float shade = 0.0f;            ///< Of the neighbours: 0 in the open, 1 in a closed wood.
    float distance = 5.0f;         ///< From trunk to trunk, metres, 0.5 to 100.
    std::optional<float> openSide; ///< Azimuth of the side without neighbours, radians from +x to +y.
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace osgTreeWind {

/// Neighbours of a tree while it grows. They are as high as the tree.
struct GrowthSite {
    float shade = 0.0f;            ///< Shade of the neighbours: 0 in the open, 1 in a closed stand.
    float distance = 5.0f;         ///< Trunk to trunk, metres, 0.5 to 100.
    std::optional<float> openSide; ///< Azimuth of the side without neighbours, radians from +x to +y.
};

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/LeafClusters.h>

#include <glm/vec4.hpp>

namespace osgTreeWind {

/// The ellipsoid that the anchors of leaves fill: it shades the crown.
struct CrownEllipsoid {
    explicit CrownEllipsoid(const std::vector<LeafCluster>& leaves);

    /// xyz: outward of the crown; w: depth in it, 0 inside to 1 at its surface.
    glm::vec4 at(const glm::vec3& point) const;

    glm::vec3 centre{0.0f}, halfAxes{1e-3f}; ///< Metres, tree frame.
};

} // namespace osgTreeWind

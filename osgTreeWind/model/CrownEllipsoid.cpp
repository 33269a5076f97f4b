// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/CrownEllipsoid.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgTreeWind {

CrownEllipsoid::CrownEllipsoid(const std::vector<LeafCluster>& leaves) {
    if (leaves.empty())
        return;
    glm::vec3 low(1e9f), high(-1e9f);
    for (const LeafCluster& leaf : leaves) {
        low = glm::min(low, leaf.anchor);
        high = glm::max(high, leaf.anchor);
    }
    centre = 0.5f * (low + high);
    halfAxes = glm::max(0.5f * (high - low), glm::vec3(1e-3f));
}

glm::vec4 CrownEllipsoid::at(const glm::vec3& point) const {
    const glm::vec3 inside = (point - centre) / halfAxes;
    const glm::vec3 gradient = inside / halfAxes + glm::vec3(0, 0, 1e-3f);
    return {glm::normalize(gradient), glm::min(glm::length(inside), 1.0f)};
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/Skeleton.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgTreeWind {

float Skeleton::height() const {
    float height = 0.0f;
    for (const BranchUnit& unit : units)
        height = glm::max(height, unit.tip.z);
    return height;
}

float Skeleton::radius(std::size_t unit, int ring) const {
    const float t = static_cast<float>(ring) / static_cast<float>(ringsPerBranch - 1);
    return glm::mix(units[unit].baseRadius, units[unit].tipRadius, t);
}

glm::vec3 Skeleton::tangent(std::size_t unit, int ring) const {
    const glm::vec3& before = point(unit, glm::max(ring - 1, 0));
    const glm::vec3& after = point(unit, glm::min(ring + 1, ringsPerBranch - 1));
    return glm::normalize(after - before);
}

} // namespace osgTreeWind

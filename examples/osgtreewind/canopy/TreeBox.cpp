// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/TreeBox.h>

#include <glm/common.hpp>

#include <cmath>

namespace osgTreeWind {

TreeBox treeBox(const PlacedForest& forest, const PlacedTree& tree) {
    const std::array<float, 5> reach = forest.modelOf(tree).extents.reach(tree.scale);
    const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
    glm::vec3 low(0.0f), high(0.0f, 0.0f, reach[4]);
    for (const float x : {reach[0], -reach[1]})
        for (const float y : {reach[2], -reach[3]}) {
            const glm::vec3 corner = turnHeading({x, y, 0.0f}, sine, cosine);
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    // Room for the rounding of floats.
    const glm::vec3 rounding =
        1e-4f * (high - low) * glm::vec3(1.0f, 1.0f, 0.0f) + glm::vec3(0, 0, 1e-4f * reach[4]);
    const glm::dvec3 foot = glm::dvec3(tree.position) + forest.description().origin;
    return {foot + glm::dvec3(low - rounding * glm::vec3(1.0f, 1.0f, 0.0f)),
            foot + glm::dvec3(high + rounding)};
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/sway/PullAndRelease.h>

#include <osgTreeWind/motion/sway/FreeSwayTree.h>

namespace osgTreeWind {

std::optional<FreeSway> pullAndRelease(const Species& species, const TreePlacement& placement, double pull) {
    FreeSwayTree tree(species, placement);
    const std::vector<std::vector<glm::vec3>> shifts = tree.tipDisplacementsByMode();
    const std::size_t top = tree.topUnit();
    std::vector<float> amplitudes; // for a pull of 1 N
    double shift = 0.0, largest = 0.0;
    std::size_t first = 0;
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        const double x = shifts[k][top].x, speed = tree.omega(k);
        amplitudes.push_back(static_cast<float>(x / (speed * speed)));
        const double part = x * x / (speed * speed);
        shift += part;
        if (part > largest) {
            largest = part;
            first = k;
        }
    }
    if (!(shift > 0.0))
        return {};
    for (float& amplitude : amplitudes)
        amplitude *= static_cast<float>(pull * tree.trunkHeight() / shift);
    tree.setAmplitudes(amplitudes);
    return tree.measureFreeSway(first, [&] { return static_cast<double>(tree.tipDisplacements()[top].x); });
}

} // namespace osgTreeWind

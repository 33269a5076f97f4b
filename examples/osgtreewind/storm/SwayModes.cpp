// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/SwayModes.h>

#include <osgTreeWind/motion/sway/FreeSwayTree.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace osgTreeWind {

std::vector<SwayMode> swayModes(const Species& species, const TreePlacement& placement) {
    constexpr double displacement = 0.01; // of the trunk's length
    FreeSwayTree tree(species, placement);
    const std::vector<std::vector<glm::vec3>> shifts = tree.tipDisplacementsByMode();
    std::vector<SwayMode> modes;
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        float most = 1e-9f;
        for (const glm::vec3& shift : shifts[k])
            most = std::max(most, glm::length(shift));
        std::vector<float> amplitudes(shifts.size(), 0.0f);
        amplitudes[k] = static_cast<float>(displacement * tree.trunkHeight()) / most;
        tree.setAmplitudes(amplitudes);
        const auto sway = tree.measureFreeSway(k, [&] { return static_cast<double>(tree.amplitude(k)); });
        modes.push_back({tree.omega(k) / glm::two_pi<double>(), sway ? sway->dampingRatio : 1.0,
                         static_cast<double>(tree.modes()[k].energyShare)});
    }
    return modes;
}

} // namespace osgTreeWind

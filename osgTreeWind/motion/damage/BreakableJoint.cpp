// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/BreakableJoint.h>

#include <osgTreeWind/species/GrowthLaws.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

double BreakableJoint::moment(const ModalMotion& motion, std::size_t tree,
                              const ModalMotion::PoseVector& vector) const {
    return static_cast<double>(stiffness) *
           static_cast<double>(glm::length(motion.unitAngles(tree, unit, vector)));
}

std::vector<BreakableJoint> thickestBoughs(const TreeForm& tree, const std::vector<UnitLoad>& loads) {
    constexpr std::size_t most = 32;
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    std::vector<BreakableJoint> boughs;
    for (std::size_t i = 1; i < units.size(); ++i)
        if (units[i].level > units[static_cast<std::size_t>(units[i].parent)].level) {
            const double diameter = 2.0 * static_cast<double>(tree.scale.radius * units[i].baseRadius);
            boughs.push_back({static_cast<unsigned>(i), loads[i].stiffness,
                              static_cast<float>(breakingMoment(tree.species->wood, diameter))});
        }
    std::stable_sort(boughs.begin(), boughs.end(),
                     [](const BreakableJoint& a, const BreakableJoint& b) { return a.limit > b.limit; });
    boughs.resize(std::min(boughs.size(), most));
    boughs.shrink_to_fit();
    return boughs;
}

} // namespace osgTreeWind

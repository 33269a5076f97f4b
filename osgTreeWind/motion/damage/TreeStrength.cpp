// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// Height at which the wind load acts, metres: the middle of the crown above its lowest green bough.
double crownMiddle(const TreeModel& model, const TreeScale& scale) {
    const std::vector<BranchUnit>& units = model.skeleton.units;
    const float height = model.skeleton.height();
    float lowest = height;
    for (const LeafCluster& leaf : model.leaves) {
        auto bough = static_cast<std::size_t>(leaf.unit);
        while (units[bough].level > 1)
            bough = static_cast<std::size_t>(units[bough].parent);
        lowest = std::min(lowest, units[bough].level == 1 ? units[bough].base.z : leaf.anchor.z);
    }
    return 0.5f * scale.axes.z * (lowest + height);
}

} // namespace

TreeStrength::TreeStrength(const TreeModel& model, const TreeScale& scale, const Species& species) {
    const double diameter = breastDiameter(model, scale), height = scale.axes.z * model.skeleton.height();
    const double pushed = crownMiddle(model, scale), breast = breastHeight(static_cast<float>(height));
    uproot = overturningMoment(species.wood, diameter, height);
    breaking = breakingMoment(species.wood, diameter) * pushed / (pushed - breast);
}

double TreeStrength::limit() const {
    return uproot > 0.0 && breaking > 0.0 ? std::min(uproot, breaking) : std::max(uproot, breaking);
}

} // namespace osgTreeWind

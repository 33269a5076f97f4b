// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// Where the wind pushes, metres: the middle of the crown.
double crownMiddle(const TreeModel& model, const TreeScale& scale) {
    const float height = model.skeleton.height();
    float lowest = height;
    for (const BranchUnit& unit : model.skeleton.units)
        if (unit.level > 0)
            lowest = std::min(lowest, unit.base.z);
    return 0.5f * scale.axes.z * (lowest + height);
}

} // namespace

TreeStrength::TreeStrength(const TreeModel& model, const TreeScale& scale, const Species& species) {
    const double diameter = breastDiameter(model, scale), height = scale.axes.z * model.skeleton.height();
    const double pushed = crownMiddle(model, scale), breast = breastHeight(static_cast<float>(height));
    uproot = overturningMoment(species.wood, diameter, height);
    breaking = breakingMoment(species.wood, diameter) * pushed / (pushed - breast);
}

} // namespace osgTreeWind

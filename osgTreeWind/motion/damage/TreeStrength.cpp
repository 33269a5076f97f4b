// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/species/GrowthLaws.h>

namespace osgTreeWind {

TreeStrength::TreeStrength(const TreeModel& model, const TreeScale& scale, const Species& species) {
    const double diameter = breastDiameter(model, scale);
    uproot = overturningMoment(species.wood, diameter, scale.axes.z * model.skeleton.height());
    breaking = breakingMoment(species.wood, diameter);
}

} // namespace osgTreeWind

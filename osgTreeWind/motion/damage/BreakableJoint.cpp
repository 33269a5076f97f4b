// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/BreakableJoint.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/damage/TreeStrength.h>
#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/modal/ModalPoses.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// Breaking moment of the base of a unit, N m.
double tearingMoment(const TreeForm& tree, const BranchUnit& unit) {
    return breakingMoment(tree.species->wood, 2.0 * static_cast<double>(tree.scale.radius * unit.baseRadius));
}

} // namespace

std::vector<BreakableJoint> thickestBoughs(const TreeForm& tree, const std::vector<UnitLoad>& loads) {
    constexpr std::size_t most = 32;
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    std::vector<BreakableJoint> boughs;
    for (std::size_t i = 1; i < units.size(); ++i)
        if (!continuesParentAxis(units, i))
            boughs.push_back({static_cast<unsigned>(i), loads[i].stiffness,
                              static_cast<float>(tearingMoment(tree, units[i]))});
    std::stable_sort(boughs.begin(), boughs.end(),
                     [](const BreakableJoint& a, const BreakableJoint& b) { return a.limit > b.limit; });
    boughs.resize(std::min(boughs.size(), most));
    boughs.shrink_to_fit();
    return boughs;
}

std::vector<BranchLoad> branchLoadsOf(const PlacedForest& forest, std::size_t slot,
                                      const ModalMotion& motion) {
    const PlacedTree& tree = forest.trees[slot];
    const TreeForm form = makeModalTree(forest, tree).form;
    const std::vector<BranchUnit>& units = form.model->skeleton.units;
    const std::vector<UnitLoad> loads = makeUnitLoads(*form.model, form.scale, *form.species, form.leaves);
    const ModalMotion::PoseVector vector = motion.poseVector(slot);
    const std::vector<UnitPose> poses = modalPoses(forest, slot, motion, vector);
    const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
    const double gain = exaggerationOf(forest);
    std::vector<BranchLoad> result(units.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        const ScaledUnit unit(units[i], tree.scale);
        const glm::vec3 direction = unit.direction();
        const glm::vec3 bent = swing(motion.unitAngles(slot, i, vector), direction);
        BranchLoad& load = result[i];
        load.moment =
            static_cast<double>(loads[i].stiffness) / gain * glm::dvec3(rotateAboutZ(bent, sine, cosine));
        if (i == 0)
            load.limit = TreeStrength(*form.model, form.scale, *form.species).limit();
        else if (!continuesParentAxis(units, i))
            load.limit = tearingMoment(form, units[i]);
        const double diameter =
            i == 0 ? breastDiameter(*form.model, form.scale) : static_cast<double>(unit.baseDiameter);
        load.strain = strainPerMoment(static_cast<double>(loads[i].modulus), diameter);
        load.tilt = rotateAboutZ(poses[i].rotation * direction - direction, sine, cosine);
    }
    return result;
}

} // namespace osgTreeWind

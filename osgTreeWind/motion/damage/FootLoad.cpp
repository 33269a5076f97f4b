// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/FootLoad.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/damage/BreakableJoint.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/modal/ModalPoses.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

FootLoad::FootLoad(const TreeForm& tree) : _strength(*tree.model, tree.scale, *tree.species) {
    JointTree joints = makeJointTree(*tree.model, tree.scale, *tree.species, tree.leaves);
    _stiffness = joints.links.front().stiffness;
    _weights = std::move(joints.points);
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    _direction = ScaledUnit(units.front(), tree.scale).direction();
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].level == 0)
            _top = i;
}

glm::dvec2 FootLoad::moment(const glm::vec2& angles) const {
    return _stiffness * glm::dvec2(swing(angles, _direction));
}

glm::dvec2 FootLoad::weightMoment(const std::vector<UnitPose>& poses) const {
    glm::dvec2 moment(0.0);
    for (const JointTree::Point& point : _weights) {
        const glm::vec3 place(point.place);
        moment += gravity * point.mass * glm::dvec2(poses[point.link].apply(place) - place);
    }
    return moment;
}

std::size_t highestUnit(const Skeleton& skeleton) {
    const auto isLower = [](const BranchUnit& a, const BranchUnit& b) { return a.tip.z < b.tip.z; };
    return static_cast<std::size_t>(std::max_element(skeleton.units.begin(), skeleton.units.end(), isLower) -
                                    skeleton.units.begin());
}

TreeSway swayOf(const PlacedForest& forest, std::size_t slot, const ModalMotion& motion) {
    constexpr float instant = 1e-3f; // seconds
    const PlacedTree& tree = forest.trees[slot];
    const FootLoad load(makeModalTree(forest, tree).form);
    const ModalMotion::PoseVector vector = motion.poseVector(slot);
    const std::vector<UnitPose> now = modalPoses(forest, slot, motion, vector),
                                next = modalPoses(forest, slot, motion, motion.poseVector(slot, instant));
    const Skeleton& skeleton = forest.modelOf(tree).skeleton;
    const std::size_t topUnit = highestUnit(skeleton);
    const glm::vec3 top = tree.scale.axes * skeleton.units[topUnit].tip, shifted = now[topUnit].apply(top);
    const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
    const auto inForest = [&](const glm::vec2& own) {
        return glm::vec2(rotateAboutZ(glm::vec3(own, 0.0f), sine, cosine));
    };
    TreeSway sway;
    sway.displacement = inForest(glm::vec2(shifted - top));
    sway.velocity = inForest(glm::vec2(next[topUnit].apply(top) - shifted) / instant);
    sway.lean = math::atan2(glm::length(glm::cross(top, shifted)), glm::dot(top, shifted));
    const double gain = exaggerationOf(forest);
    sway.weightMoment = glm::dvec2(inForest(glm::vec2(load.weightMoment(now)))) / gain;
    sway.windMoment =
        glm::dvec2(inForest(glm::vec2(load.moment(motion.unitAngles(slot, 0, vector))))) / gain -
        sway.weightMoment;
    sway.limit = load.strength().limit();
    if (!motion.model(slot).modes.empty())
        sway.frequency = static_cast<double>(motion.omega(slot, 0)) / glm::two_pi<double>();
    return sway;
}

} // namespace osgTreeWind

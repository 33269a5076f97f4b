// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/FootLoad.h>

#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/modal/ModalPoses.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

FootLoad::FootLoad(const TreeForm& tree) : _strength(*tree.model, tree.scale, *tree.species) {
    JointTree joints = makeJointTree(*tree.model, tree.scale, *tree.species, tree.leaves);
    _stiffness = joints.links.front().stiffness;
    _weights = std::move(joints.points);
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].level == 0)
            _top = i;
}

glm::dvec2 FootLoad::moment(const std::vector<UnitPose>& poses) const {
    const glm::vec3 up(0.0f, 0.0f, 1.0f);
    const glm::dvec2 turned(glm::vec2(poses.front().rotation * up - up));
    const double sine = std::min(glm::length(turned), 1.0);
    return turned * (_stiffness * (sine > 1e-9 ? std::asin(sine) / sine : 1.0));
}

glm::dvec2 FootLoad::weightMoment(const std::vector<UnitPose>& poses) const {
    glm::dvec2 moment(0.0);
    for (const JointTree::Point& point : _weights) {
        const glm::vec3 place(point.place);
        moment += gravity * point.mass * glm::dvec2(poses[point.link].apply(place) - place);
    }
    return moment;
}

TreeSway swayOf(const PlacedForest& forest, std::size_t slot, const ModalMotion& motion) {
    constexpr float instant = 1e-3f; // seconds
    const PlacedTree& tree = forest.trees[slot];
    const FootLoad load(makeModalTree(forest, tree).form);
    const std::vector<UnitPose> now = modalPoses(forest, slot, motion, motion.poseVector(slot)),
                                next = modalPoses(forest, slot, motion, motion.poseVector(slot, instant));
    const std::vector<BranchUnit>& units = forest.modelOf(tree).skeleton.units;
    const auto isLower = [](const BranchUnit& a, const BranchUnit& b) { return a.tip.z < b.tip.z; };
    const auto highest = std::max_element(units.begin(), units.end(), isLower);
    const auto topUnit = static_cast<std::size_t>(highest - units.begin());
    const glm::vec3 top = tree.scale.axes * highest->tip, shifted = now[topUnit].apply(top);
    const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
    const auto inForest = [&](const glm::vec2& own) {
        return glm::vec2(cosine * own.x - sine * own.y, sine * own.x + cosine * own.y);
    };
    TreeSway sway;
    sway.displacement = inForest(glm::vec2(shifted - top));
    sway.velocity = inForest(glm::vec2(next[topUnit].apply(top) - shifted) / instant);
    sway.lean = std::atan2(glm::length(glm::cross(top, shifted)), glm::dot(top, shifted));
    // The gain exaggerates what is seen, not the loads.
    const double gain = static_cast<double>(std::max(forest.description().gain, 1e-3f));
    sway.weightMoment = glm::dvec2(inForest(glm::vec2(load.weightMoment(now)))) / gain;
    sway.windMoment = glm::dvec2(inForest(glm::vec2(load.moment(now)))) / gain - sway.weightMoment;
    const double uproot = load.strength().uproot, breaking = load.strength().breaking;
    sway.limit = uproot > 0.0 && breaking > 0.0 ? std::min(uproot, breaking) : std::max(uproot, breaking);
    if (!motion.model(slot).modes.empty())
        sway.frequency = static_cast<double>(motion.omega(slot, 0)) / glm::two_pi<double>();
    return sway;
}

} // namespace osgTreeWind

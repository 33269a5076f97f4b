// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalLean.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/model/LeafClusters.h>
#include <osgTreeWind/model/MeasureTree.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// A point that moves with a unit.
struct CrownPoint {
    std::size_t unit;
    glm::dvec3 place;
};

std::vector<CrownPoint> crownOf(const TreeModel& model, const TreeScale& scale) {
    std::vector<CrownPoint> crown;
    for (const LeafCluster& leaf : model.leaves)
        crown.push_back({static_cast<std::size_t>(leaf.unit), scale.axes * leaf.anchor});
    for (std::size_t i = 0; model.leaves.empty() && i < model.skeleton.units.size(); ++i)
        crown.push_back({i, scale.axes * model.skeleton.units[i].tip});
    return crown;
}

/// Mean horizontal displacement of the crown points per element of the pose vector (modal amplitudes, then
/// patch forces), metres.
std::vector<glm::dvec2> crownDisplacements(const std::vector<CrownPoint>& crown, const JointTree& joints,
                                           const ModalModel& modal) {
    std::vector<glm::dvec2> displacements(modal.columns(), glm::dvec2(0.0));
    for (const CrownPoint& point : crown)
        for (int i = static_cast<int>(point.unit); i >= 0;
             i = joints.links[static_cast<std::size_t>(i)].parent)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const auto carrier = static_cast<std::size_t>(i);
                const JointTree::Link& link = joints.links[carrier];
                const glm::dvec2 arm(glm::cross(link.axes[axis], point.place - link.base));
                const float* angles = modal.poses.data() + (2 * carrier + axis) * modal.columns();
                for (std::size_t c = 0; c < displacements.size(); ++c)
                    displacements[c] += static_cast<double>(angles[c]) * arm;
            }
    for (glm::dvec2& move : displacements)
        move /= static_cast<double>(std::max<std::size_t>(crown.size(), 1));
    return displacements;
}

/// Displacement of the crown in a steady wind over that of its modes alone; the residual flexibility follows
/// the same wind.
double staticCorrection(const std::vector<glm::dvec2>& displacements, const ModalModel& modal) {
    const std::size_t modes = modal.modes.size();
    double byModes = 0.0, residual = 0.0;
    for (int axis = 0; axis < 2; ++axis)
        for (std::size_t p = 0; p < modal.patches.size(); ++p) {
            const auto c = static_cast<std::size_t>(axis);
            const double force = static_cast<double>(modal.patches[p].woodDrag) +
                                 static_cast<double>(modal.patches[p].leafDrag);
            for (std::size_t k = 0; k < modes; ++k) {
                const double omega = modal.modes[k].omega;
                byModes += force * static_cast<double>(modal.levers[(3 * p + c) * modes + k]) /
                           (omega * omega) * displacements[k][axis];
            }
            residual += force * displacements[modes + 3 * p + c][axis];
        }
    return byModes > 0.0 ? std::max(1.0 + residual / byModes, 0.0) : 1.0;
}

} // namespace

std::vector<glm::vec2> modalLeans(const TreeModel& model, const TreeScale& scale, const JointTree& joints,
                                  const ModalModel& modal) {
    const double height = std::max(static_cast<double>(measureTree(model, scale).height), 1.0e-6);
    const std::vector<CrownPoint> crown = crownOf(model, scale);
    double shares = 1.0e-30;
    for (const CrownPoint& point : crown)
        shares += math::pow(std::max(point.place.z / height, 0.0), static_cast<double>(leanPower));
    const double mean = shares / static_cast<double>(std::max<std::size_t>(crown.size(), 1));
    const std::vector<glm::dvec2> displacements = crownDisplacements(crown, joints, modal);
    const double whole = staticCorrection(displacements, modal);
    std::vector<glm::vec2> leans;
    for (std::size_t k = 0; k < modal.modes.size(); ++k)
        leans.emplace_back(whole / mean * displacements[k]);
    return leans;
}

} // namespace osgTreeWind

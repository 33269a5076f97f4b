// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalLean.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// A place that moves with a unit.
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

} // namespace

std::vector<glm::vec2> modalLeans(const TreeModel& model, const TreeScale& scale, const JointTree& joints,
                                  const ModalModel& modal, float power) {
    const double height = std::max(static_cast<double>(measureTree(model, scale).height), 1.0e-6);
    std::vector<glm::dvec2> sums(modal.modes.size(), glm::dvec2(0.0));
    double squares = 1.0e-30;
    for (const CrownPoint& point : crownOf(model, scale)) {
        const double share = std::pow(std::max(point.place.z / height, 0.0), static_cast<double>(power));
        squares += share * share;
        for (int i = static_cast<int>(point.unit); i >= 0;
             i = joints.links[static_cast<std::size_t>(i)].parent)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const auto carrier = static_cast<std::size_t>(i);
                const JointTree::Link& link = joints.links[carrier];
                const glm::dvec2 moved =
                    share * glm::dvec2(glm::cross(link.axes[axis], point.place - link.base));
                const float* angles = modal.poses.data() + (2 * carrier + axis) * modal.columns();
                for (std::size_t k = 0; k < sums.size(); ++k)
                    sums[k] += static_cast<double>(angles[k]) * moved;
            }
    }
    std::vector<glm::vec2> leans;
    for (const glm::dvec2& sum : sums)
        leans.emplace_back(sum / squares);
    return leans;
}

} // namespace osgTreeWind

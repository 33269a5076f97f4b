// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/JointTree.h>

#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

namespace {

constexpr int pointsPerUnit = 8;

/// Lever of a point at distance `at` on a bent unit: its deflection under a force at the tip of the axis,
/// over the angle of the equivalent joint (jointStiffness()). The beam is uniform.
double bentLever(double at, double length, double reach) {
    const double rest = reach - length;
    return at * at * (3.0 * reach - at) * reach / (2.0 * (reach * reach + reach * rest + rest * rest)) /
           length;
}

} // namespace

glm::dvec3 JointTree::displacement(const Point& point, std::size_t link, std::size_t axis) const {
    const glm::dvec3 arm = point.link == link ? point.lever : point.place - links[link].base;
    return glm::cross(links[link].axes[axis], arm);
}

JointTree makeJointTree(const TreeModel& model, const TreeScale& scale, const Species& species,
                        float leaves) {
    const std::vector<BranchUnit>& units = model.skeleton.units;
    const std::vector<UnitLoad> loads = makeUnitLoads(model, scale, species, leaves);
    const std::vector<float> reach = distancesToAxisTip(units, scale);
    JointTree tree;
    tree.links.reserve(units.size());
    tree.points.reserve(units.size() * (pointsPerUnit + 1));
    for (std::size_t i = 0; i < units.size(); ++i) {
        const ScaledUnit unit(units[i], scale);
        const glm::vec3 direction = unit.direction();
        const glm::dvec3 along(direction);
        JointTree::Link link;
        link.parent = units[i].parent;
        link.base = unit.base;
        link.axes = {glm::cross(direction, Laws().branchAxis1(direction)),
                     glm::cross(direction, Laws().branchAxis3(direction))};
        link.stiffness = loads[i].stiffness;
        tree.links.push_back(link);

        const double d0 = unit.baseDiameter, d1 = unit.tipDiameter, length = unit.length;
        for (int slice = 0; slice < pointsPerUnit; ++slice) {
            const double start = static_cast<double>(slice) / pointsPerUnit,
                         end = start + 1.0 / pointsPerUnit;
            const double a = d0 + (d1 - d0) * start, b = d0 + (d1 - d0) * end;
            const double at = 0.5 * (start + end) * length;
            JointTree::Point point;
            point.link = i;
            point.place = link.base + at * along;
            point.lever = bentLever(at, length, reach[i]) * along;
            const double share = (a * a + a * b + b * b) / (d0 * d0 + d0 * d1 + d1 * d1);
            point.mass = (share * static_cast<double>(loads[i].woodMass) +
                          static_cast<double>(loads[i].shootMass + loads[i].leafMass)) /
                         pointsPerUnit;
            tree.points.push_back(point);
        }
        JointTree::Point air;
        air.link = i;
        air.place = unit.middle();
        air.lever = static_cast<double>(unit.dragLever()) * along;
        air.woodDrag = loads[i].woodDrag;
        air.leafDrag = loads[i].leafDrag;
        air.stillDrag = static_cast<double>(species.wood.stillDrag * loads[i].leafArea);
        tree.points.push_back(air);
    }
    return tree;
}

} // namespace osgTreeWind

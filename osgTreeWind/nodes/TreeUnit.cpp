// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeUnit.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osg/Math>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

float distance2(const TreeUnit& unit, const osg::Vec3& point) {
    const osg::Vec3 along = unit.tip - unit.base, way = point - unit.base;
    const float length2 = along.length2();
    const float part = length2 > 0.0f ? osg::clampBetween(way * along / length2, 0.0f, 1.0f) : 0.0f;
    return (way - along * part).length2();
}

} // namespace

std::vector<TreeUnit> unitsOf(const ForestSimulation& simulation, std::size_t slot) {
    const PlacedTree& tree = simulation.trees()[slot];
    UnitValues values;
    const TreeMotion motion = simulation.motion(slot, values);
    const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
    std::vector<TreeUnit> units;
    for (const BranchUnit& rest : simulation.forest().modelOf(tree).skeleton.units) {
        const UnitPose& pose = motion.poses[units.size()];
        const auto now = [&](const glm::vec3& point) {
            return toOsg(turnHeading(pose.apply(point), sine, cosine) + tree.position);
        };
        const glm::vec3 base = tree.scale.axes * rest.base, tip = tree.scale.axes * rest.tip;
        units.push_back({rest.parent, rest.level, tree.scale.radius * rest.baseRadius,
                         tree.scale.radius * rest.tipRadius, toOsg(base), toOsg(tip), now(base), now(tip)});
    }
    return units;
}

std::optional<unsigned> nearestUnit(const std::vector<TreeUnit>& units, const osg::Vec3& point) {
    const auto nearest =
        std::min_element(units.begin(), units.end(), [&](const TreeUnit& a, const TreeUnit& b) {
            return distance2(a, point) < distance2(b, point);
        });
    if (nearest == units.end())
        return {};
    return static_cast<unsigned>(nearest - units.begin());
}

} // namespace osgTreeWind

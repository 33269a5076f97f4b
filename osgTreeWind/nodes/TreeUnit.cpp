// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeUnit.h>

#include <osg/Math>

#include <algorithm>

namespace osgTreeWind {
namespace {

float squaredDistance(const TreeUnit& unit, const osg::Vec3& point) {
    const osg::Vec3 along = unit.tip - unit.base, way = point - unit.base;
    const float length2 = along.length2();
    const float part = length2 > 0.0f ? osg::clampBetween(way * along / length2, 0.0f, 1.0f) : 0.0f;
    return (way - along * part).length2();
}

} // namespace

std::optional<unsigned> nearestUnit(const std::vector<TreeUnit>& units, const osg::Vec3& point) {
    const auto nearest =
        std::min_element(units.begin(), units.end(), [&](const TreeUnit& a, const TreeUnit& b) {
            return squaredDistance(a, point) < squaredDistance(b, point);
        });
    if (nearest == units.end())
        return {};
    return static_cast<unsigned>(nearest - units.begin());
}

} // namespace osgTreeWind

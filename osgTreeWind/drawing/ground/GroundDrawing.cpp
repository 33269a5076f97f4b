// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ground/GroundDrawing.h>

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/drawing/ground/GroundTile.h>

#include <glm/common.hpp>

namespace osgTreeWind {

osg::ref_ptr<osg::Node> createGroundDrawing(const GroundPtr& ground, const glm::dvec3& origin,
                                            const glm::dvec2& centre, double radius) {
    constexpr double beyond = 50000.0, finest = 4.0; // metres
    constexpr Range cells = within(0.001, 1e8);
    if (!ground)
        return {};
    const GroundArea area = ground->area();
    const DrawnGround drawn{ground, origin, glm::max(area.low, centre - (radius + beyond)),
                            glm::min(area.high, centre + (radius + beyond))};
    if (!(drawn.high.x > drawn.low.x && drawn.high.y > drawn.low.y && cells.contains(area.cell)))
        return {};
    double spacing = 0.5 * area.cell; // between cells, too: a bilinear surface is not flat there
    while (spacing > finest)
        spacing *= 0.5;
    return GroundTile::ofAll(std::make_shared<const DrawnGround>(drawn), spacing);
}

} // namespace osgTreeWind

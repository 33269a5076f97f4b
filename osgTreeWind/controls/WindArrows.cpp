// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/WindArrows.h>

#include <osgTreeWind/controls/WindOverlay.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

namespace {

constexpr unsigned pointsPerArrow = 6; // a shaft and two barbs
constexpr float clearance = 2.0f;      // metres above the highest tree

} // namespace

WindArrows::WindArrows() : SceneGeometry(sharedProgram("lines", "color")) {
    setUpLines(*this, pointsPerArrow * across * across);
}

void WindArrows::show(const ForestSimulation& simulation, double time, const glm::vec2& middle, float reach) {
    auto& points = static_cast<osg::Vec3Array&>(*getVertexArray());
    auto& colours = static_cast<osg::Vec4Array&>(*getColorArray());
    const WindFieldPtr wind = movingForest(simulation).openWind();
    const float above = maxTreeHeight(movingForest(simulation).placed()) + clearance;
    std::size_t next = 0;
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) {
            const glm::vec2 share = (2.0f * glm::vec2(i, j) + 1.0f) / static_cast<float>(across) - 1.0f,
                            at = middle + reach * share;
            const float ground = groundHeight(simulation.description(), at);
            const glm::vec3 foot(at, ground + above);
            const glm::vec3 air = wind ? wind->velocity(WindPlace(foot, ground), time) : glm::vec3(0.0f);
            const glm::vec3 side(-air.y, air.x, 0.0f), tip = foot + 0.5f * air, tail = foot - 0.5f * air;
            const glm::vec3 ends[pointsPerArrow] = {
                tail, tip, tip, tip - 0.25f * air + 0.12f * side, tip, tip - 0.25f * air - 0.12f * side};
            const osg::Vec4 colour = windColour(glm::length(air));
            for (const glm::vec3& end : ends) {
                points[next] = toOsg(end);
                colours[next++] = colour;
            }
        }
    points.dirty();
    colours.dirty();
    dirtyBound();
}

} // namespace osgTreeWind

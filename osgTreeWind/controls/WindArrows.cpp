// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/WindArrows.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/wind/GivenWind.h>

#include <osg/LineWidth>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr unsigned pointsOfArrow = 6; // a shaft and two barbs
constexpr float fastest = 20.0f;      // m/s
constexpr float clearance = 2.0f;     // metres above the highest tree
constexpr std::size_t mostMeasured = 2000;

/// Viridis in three colours.
osg::Vec4 colourOf(float speed) {
    const osg::Vec3 calm(0.267f, 0.005f, 0.329f), fresh(0.128f, 0.567f, 0.551f),
        strong(0.993f, 0.906f, 0.144f);
    const float share = 2.0f * std::clamp(speed / fastest, 0.0f, 1.0f);
    return {share < 1.0f ? calm + (fresh - calm) * share : fresh + (strong - fresh) * (share - 1.0f), 1.0f};
}

/// Of the highest tree, above its foot, metres; of one in so many where there are very many.
float heightOf(const PlacedForest& forest) {
    const std::size_t every = forest.trees.size() / mostMeasured + 1;
    float height = 0.0f;
    for (std::size_t slot = 0; slot < forest.trees.size(); slot += every)
        if (forest.trees[slot].alive)
            height = std::max(height, forest.measured(forest.trees[slot]).height);
    return height;
}

float groundAt(const ForestDescription& forest, const glm::vec2& place) {
    if (!forest.ground)
        return 0.0f;
    const auto height = forest.ground->height(glm::dvec2(forest.origin) + glm::dvec2(place));
    return height ? static_cast<float>(*height - forest.origin.z) : 0.0f;
}

} // namespace

WindArrows::WindArrows() {
    constexpr unsigned points = pointsOfArrow * across * across;
    setDataVariance(DYNAMIC);
    setUseDisplayList(false);
    setUseVertexBufferObjects(true);
    setVertexArray(new osg::Vec3Array(points));
    setColorArray(new osg::Vec4Array(points), osg::Array::BIND_PER_VERTEX);
    addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, points));
    setCullingActive(false);
    osg::StateSet* state = getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    state->setAttributeAndModes(new osg::LineWidth(2.0f));
}

void WindArrows::show(const ForestSimulation& simulation, double time, const glm::vec2& middle, float reach) {
    auto& points = static_cast<osg::Vec3Array&>(*getVertexArray());
    auto& colours = static_cast<osg::Vec4Array&>(*getColorArray());
    const WindFieldPtr wind = simulation.givenWind()->here();
    const float above = heightOf(simulation.forest()) + clearance;
    std::size_t next = 0;
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i) {
            const glm::vec2 share = (2.0f * glm::vec2(i, j) + 1.0f) / static_cast<float>(across) - 1.0f,
                            at = middle + reach * share;
            const float ground = groundAt(simulation.description(), at);
            const glm::vec3 foot(at, ground + above);
            const glm::vec3 air = wind ? wind->velocity(WindPlace(foot, ground), time) : glm::vec3(0.0f);
            const glm::vec3 side(-air.y, air.x, 0.0f), tip = foot + 0.5f * air, tail = foot - 0.5f * air;
            const glm::vec3 ends[pointsOfArrow] = {
                tail, tip, tip, tip - 0.25f * air + 0.12f * side, tip, tip - 0.25f * air - 0.12f * side};
            const osg::Vec4 colour = colourOf(glm::length(air));
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

// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/WindOverlay.h>

#include <osgTreeWind/base/Viridis.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>

#include <osg/LineWidth>

#include <algorithm>

namespace osgTreeWind {

osg::Vec4 windColour(float speed) {
    constexpr double fastest = 20.0; // m/s
    const glm::vec3 color = viridis(static_cast<double>(speed) / fastest);
    return {color.r, color.g, color.b, 1.0f};
}

float maxTreeHeight(const PlacedForest& forest) {
    constexpr std::size_t maxMeasuredTrees = 2000;
    const std::size_t every = forest.trees.size() / maxMeasuredTrees + 1;
    float height = 0.0f;
    for (std::size_t slot = 0; slot < forest.trees.size(); slot += every)
        if (forest.trees[slot].alive)
            height = std::max(height, forest.sizeOf(forest.trees[slot]).height);
    return height;
}

float groundHeight(const ForestDescription& forest, const glm::vec2& place) {
    if (!forest.ground)
        return 0.0f;
    const auto height = forest.ground->height(glm::dvec2(forest.origin) + glm::dvec2(place));
    return height ? static_cast<float>(*height - forest.origin.z) : 0.0f;
}

void setUpLines(osg::Geometry& geometry, unsigned points) {
    geometry.setDataVariance(osg::Object::DYNAMIC);
    geometry.setVertexArray(new osg::Vec3Array(points));
    geometry.setColorArray(new osg::Vec4Array(points), osg::Array::BIND_PER_VERTEX);
    geometry.addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, static_cast<int>(points)));
    geometry.setCullingActive(false);
    osg::StateSet* state = geometry.getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    state->setAttributeAndModes(new CompatibilityOnly<osg::LineWidth>(2.0f));
}

} // namespace osgTreeWind

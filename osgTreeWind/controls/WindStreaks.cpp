// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/WindStreaks.h>

#include <osgTreeWind/controls/WindOverlay.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/BlendFunc>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

WindStreaks::WindStreaks() : SceneGeometry(sharedProgram("lines", "color")) {
    setUpLines(*this, count * 2 * (points - 1));
    getOrCreateStateSet()->setAttributeAndModes(new osg::BlendFunc);
    getOrCreateStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
}

void WindStreaks::restart(Streak& streak, const ForestDescription& forest, const glm::vec2& middle,
                          float reach, float highest) {
    constexpr float longest = 5.0f; // seconds
    const glm::vec2 place = middle + reach * (2.0f * glm::vec2(randomUnit(), randomUnit()) - 1.0f);
    streak.trail.fill(glm::vec3(place, groundHeight(forest, place) + 0.5f + 1.3f * highest * randomUnit()));
    streak.life = longest * (0.3f + 0.7f * randomUnit());
}

void WindStreaks::show(const ForestSimulation& simulation, double time, const glm::vec2& middle,
                       float reach) {
    constexpr double longestStep = 0.2, between = 1.0 / (points - 1); // seconds
    const ForestDescription& forest = simulation.description();
    const float highest = std::max(maxTreeHeight(movingForest(simulation).placed()), 2.0f);
    const bool isRestart = !_hasStarted || time < _time || time - _time > longestStep;
    const float step = isRestart ? 0.0f : static_cast<float>(time - _time);
    const bool addsPoint = time - _lastTrailTime >= between || isRestart;
    _hasStarted = true;
    _time = time;
    if (addsPoint)
        _lastTrailTime = time;

    const WindFieldPtr wind = movingForest(simulation).openWind();
    auto& places = static_cast<osg::Vec3Array&>(*getVertexArray());
    auto& colours = static_cast<osg::Vec4Array&>(*getColorArray());
    std::size_t next = 0;
    for (Streak& streak : _streaks) {
        streak.life -= step;
        const glm::vec2 off = glm::abs(glm::vec2(streak.trail[0]) - middle);
        if (isRestart || streak.life <= 0.0f || std::max(off.x, off.y) > reach)
            restart(streak, forest, middle, reach, highest);
        const float ground = groundHeight(forest, streak.trail[0]);
        const glm::vec3 air =
            wind ? wind->velocity(WindPlace(streak.trail[0], ground), time) : glm::vec3(0.0f);
        if (addsPoint)
            std::copy_backward(streak.trail.begin(), streak.trail.end() - 1, streak.trail.end());
        streak.trail[0] += step * air;
        streak.trail[0].z = std::max(streak.trail[0].z, ground + 0.2f);
        const osg::Vec4 colour = windColour(glm::length(air)) * 0.4f + osg::Vec4(0.6f, 0.6f, 0.6f, 0.0f);
        for (unsigned i = 0; i + 1 < points; ++i)
            for (const unsigned end : {i, i + 1}) {
                places[next] = toOsg(streak.trail[end]);
                colours[next] = colour;
                colours[next++].a() = 1.0f - static_cast<float>(end) / (points - 1);
            }
    }
    places.dirty();
    colours.dirty();
    dirtyBound();
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/WindStreaks.h>

#include <osgTreeWind/controls/WindOverForest.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/SimulationParts.h>
#include <osgTreeWind/wind/GivenWind.h>

#include <osg/BlendFunc>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

WindStreaks::WindStreaks() {
    becomeLines(*this, count * 2 * (points - 1), 2.0f);
    getOrCreateStateSet()->setAttributeAndModes(new osg::BlendFunc);
    getOrCreateStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
}

void WindStreaks::begin(Streak& streak, const ForestDescription& forest, const glm::vec2& middle, float reach,
                        float highest) {
    constexpr float longest = 5.0f; // seconds
    const glm::vec2 place = middle + reach * (2.0f * glm::vec2(chance(), chance()) - 1.0f);
    streak.way.fill(glm::vec3(place, groundAt(forest, place) + 0.5f + 1.3f * highest * chance()));
    streak.life = longest * (0.3f + 0.7f * chance());
}

void WindStreaks::show(const ForestSimulation& simulation, double time, const glm::vec2& middle,
                       float reach) {
    constexpr double longestStep = 0.2, between = 1.0 / (points - 1); // seconds
    const ForestDescription& forest = simulation.description();
    const float highest = std::max(highestTree(SimulationParts::forest(simulation)), 2.0f);
    const bool anew = !_began || time < _time || time - _time > longestStep;
    const float step = anew ? 0.0f : static_cast<float>(time - _time);
    const bool marks = time - _marked >= between || anew;
    _began = true;
    _time = time;
    if (marks)
        _marked = time;

    const WindFieldPtr wind = SimulationParts::wind(simulation)->here();
    auto& places = static_cast<osg::Vec3Array&>(*getVertexArray());
    auto& colours = static_cast<osg::Vec4Array&>(*getColorArray());
    std::size_t next = 0;
    for (Streak& streak : _streaks) {
        streak.life -= step;
        const glm::vec2 off = glm::abs(glm::vec2(streak.way[0]) - middle);
        if (anew || streak.life <= 0.0f || std::max(off.x, off.y) > reach)
            begin(streak, forest, middle, reach, highest);
        const float ground = groundAt(forest, streak.way[0]);
        const glm::vec3 air = wind ? wind->velocity(WindPlace(streak.way[0], ground), time) : glm::vec3(0.0f);
        if (marks)
            std::copy_backward(streak.way.begin(), streak.way.end() - 1, streak.way.end());
        streak.way[0] += step * air;
        streak.way[0].z = std::max(streak.way[0].z, ground + 0.2f);
        const osg::Vec4 colour = colourOfWind(glm::length(air)) * 0.4f + osg::Vec4(0.6f, 0.6f, 0.6f, 0.0f);
        for (unsigned i = 0; i + 1 < points; ++i)
            for (const unsigned end : {i, i + 1}) {
                places[next] = toOsg(streak.way[end]);
                colours[next] = colour;
                colours[next++].a() = 1.0f - static_cast<float>(end) / (points - 1);
            }
    }
    places.dirty();
    colours.dirty();
    dirtyBound();
}

} // namespace osgTreeWind

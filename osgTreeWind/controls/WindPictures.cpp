// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/WindPictures.h>

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/SimulationParts.h>
#include <osgTreeWind/wind/GivenWind.h>

#include <osg/BlendFunc>
#include <osg/LineWidth>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr unsigned pointsOfArrow = 6; // a shaft and two barbs
constexpr float clearance = 2.0f;     // metres above the highest tree

/// Viridis in three colours: from dark blue (calm) over green to yellow (20 m/s and more). @param speed m/s.
osg::Vec4 colourOfWind(float speed) {
    constexpr float fastest = 20.0f; // m/s
    const osg::Vec3 calm(0.267f, 0.005f, 0.329f), fresh(0.128f, 0.567f, 0.551f),
        strong(0.993f, 0.906f, 0.144f);
    const float share = 2.0f * std::clamp(speed / fastest, 0.0f, 1.0f);
    return {share < 1.0f ? calm + (fresh - calm) * share : fresh + (strong - fresh) * (share - 1.0f), 1.0f};
}

/// Of one in so many where there are very many, metres.
float highestTree(const PlacedForest& forest) {
    constexpr std::size_t mostMeasured = 2000;
    const std::size_t every = forest.trees.size() / mostMeasured + 1;
    float height = 0.0f;
    for (std::size_t slot = 0; slot < forest.trees.size(); slot += every)
        if (forest.trees[slot].alive)
            height = std::max(height, forest.measured(forest.trees[slot]).height);
    return height;
}

/// The forest's coordinates, metres; 0 where there is none.
float groundAt(const ForestDescription& forest, const glm::vec2& place) {
    if (!forest.ground)
        return 0.0f;
    const auto height = forest.ground->height(glm::dvec2(forest.origin) + glm::dvec2(place));
    return height ? static_cast<float>(*height - forest.origin.z) : 0.0f;
}

/// Makes of it lines without light that change from frame to frame, each point of a colour of its own.
void becomeLines(osg::Geometry& geometry, unsigned points, float width) {
    geometry.setDataVariance(osg::Object::DYNAMIC);
    geometry.setUseDisplayList(false);
    geometry.setUseVertexBufferObjects(true);
    geometry.setVertexArray(new osg::Vec3Array(points));
    geometry.setColorArray(new osg::Vec4Array(points), osg::Array::BIND_PER_VERTEX);
    geometry.addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, static_cast<int>(points)));
    geometry.setCullingActive(false);
    osg::StateSet* state = geometry.getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    state->setAttributeAndModes(new osg::LineWidth(width));
}

} // namespace

WindArrows::WindArrows() {
    becomeLines(*this, pointsOfArrow * across * across, 2.0f);
}

void WindArrows::show(const ForestSimulation& simulation, double time, const glm::vec2& middle, float reach) {
    auto& points = static_cast<osg::Vec3Array&>(*getVertexArray());
    auto& colours = static_cast<osg::Vec4Array&>(*getColorArray());
    const WindFieldPtr wind = SimulationParts::wind(simulation)->here();
    const float above = highestTree(SimulationParts::forest(simulation)) + clearance;
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
            const osg::Vec4 colour = colourOfWind(glm::length(air));
            for (const glm::vec3& end : ends) {
                points[next] = toOsg(end);
                colours[next++] = colour;
            }
        }
    points.dirty();
    colours.dirty();
    dirtyBound();
}

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

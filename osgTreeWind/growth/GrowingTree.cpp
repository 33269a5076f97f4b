// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowingTree.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/growth/AllotGrowth.h>
#include <osgTreeWind/growth/GrowShoots.h>
#include <osgTreeWind/growth/ShedBranches.h>
#include <osgTreeWind/growth/SinkBoughs.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <array>

namespace osgTreeWind {
namespace {

/// A tree stops growing if it has not risen by a hundredth of its intended height in this time.
constexpr int maxYearsWithoutRise = 12;
constexpr int maxAge = 250;
/// Years for which a mature tree with `rounding` 1 fills its crown.
constexpr float fillingYears = 9.0f;
/// A tree with more metamers stops growing.
constexpr std::size_t maxMetamers = 40000;
/// Lean of a stem at its foot / random bends of its shoots per metre.
constexpr float stemLean = 1.2f;
/// Length of shoot whose leaves a resting tip bears, metres.
constexpr float restingShootLength = 0.12f;

} // namespace

GrowingTree::GrowingTree(const TreeHabit& habit, const GrowthGoal& goal, const glm::vec3& foot,
                         std::uint32_t seed, float spread)
    : _foot(foot) {
    _state.habit = habit;
    _state.goal = goal;
    _state.goal.crownWidth *= spread;
    _state.spread = spread;
    _state.random = Random(seed);
    const auto lean = [&](float most) {
        const float leaning = most * habit.wander[0] * (0.4f + 1.2f * _state.random.uniform());
        const float towards = glm::pi<float>() * _state.random.symmetric();
        return leaning * glm::vec2(cosine(towards), sine(towards));
    };
    _state.leanAtFoot = lean(stemLean);
    _state.leanAbove = lean(0.9f * stemLean);
    Metamer first;
    first.heading = directionOr(_state.stemDirection(0.0f), {0.0f, 0.0f, 1.0f});
    _state.metamers.push_back(first);
    ShootAxis trunk;
    trunk.leading = true;
    trunk.phase = 3.0f * _state.random.symmetric();
    _state.axes.push_back(trunk);
    Bud top;
    top.terminal = true;
    top.heading = first.heading;
    _state.buds.push_back(top);
}

void GrowingTree::unfoldLeaves(glm::vec3& lowest, glm::vec3& highest) {
    const TreeHabit& habit = _state.habit;
    for (Metamer& metamer : _state.metamers) {
        const auto age = static_cast<float>(_state.year - metamer.born);
        metamer.leafArea = metamer.died < 0 && age < static_cast<float>(habit.leafYears)
                               ? habit.leafArea * metamer.length
                               : 0.0f;
        lowest = glm::min(lowest, _foot + metamer.position);
        highest = glm::max(highest, _foot + metamer.position);
    }
    for (const Bud& bud : _state.buds) {
        float& area = _state.metamers[static_cast<std::size_t>(bud.node)].leafArea;
        if (bud.terminal)
            area = std::max(area, habit.leafArea * restingShootLength);
    }
}

void GrowingTree::addLeaves(ShadeGrid& grid) const {
    for (const Metamer& metamer : _state.metamers)
        if (metamer.leafArea > 0.0f)
            grid.addLeaves(_foot + metamer.position, metamer.leafArea);
}

void GrowingTree::growYear(const ShadeGrid& grid) {
    for (Metamer& metamer : _state.metamers)
        if (metamer.leafArea > 0.0f)
            metamer.light = grid.light(_foot + metamer.position);
    for (Bud& bud : _state.buds) {
        const Metamer& metamer = _state.metamers[static_cast<std::size_t>(bud.node)];
        bud.light = grid.light(_foot + metamer.position + 0.7f * grid.cellSize() * bud.heading);
    }
    measureSideLight(grid);
    ++_state.year;
    shedBranches(_state);
    allotGrowth(_state);
    growShoots(_state, grid, _foot);
    sinkBoughs(_state);
    measureCrown();
}

void GrowingTree::measureSideLight(const ShadeGrid& grid) {
    const float out = 1.5f * _state.crownRadius + grid.cellSize();
    const glm::vec3 middle = _foot + glm::vec3(0.0f, 0.0f, 0.75f * _state.height);
    _state.sideLight = 0.0f;
    for (const glm::vec2& side :
         {glm::vec2(out, 0), glm::vec2(-out, 0), glm::vec2(0, out), glm::vec2(0, -out)})
        _state.sideLight += 0.25f * grid.light(middle + glm::vec3(side, 0.0f));
}

void GrowingTree::measureCrown() {
    float highest = 0.0f;
    for (const Metamer& metamer : _state.metamers) {
        if (metamer.died < 0)
            highest = std::max(highest, metamer.position.z);
        if (metamer.axis == 0)
            _state.crownCentre = glm::vec2(metamer.position);
    }
    if (highest > _lastRiseHeight + 0.01f * _state.goal.height) {
        _lastRiseHeight = highest;
        _lastRiseYear = _state.year;
    }
    _state.height = highest;
    if (!_state.mature && highest >= 0.995f * _state.goal.height) {
        _state.mature = true;
        _matureYear = _state.year;
    }
    _state.crownRadius = meanCrownRadius(_state.metamers);
}

bool GrowingTree::isFullyGrown() const {
    if (_state.mature)
        return static_cast<float>(_state.year - _matureYear) >= fillingYears * _state.habit.rounding;
    return _state.year - _lastRiseYear > maxYearsWithoutRise || _state.year >= maxAge ||
           _state.metamers.size() > maxMetamers;
}

float meanCrownRadius(const std::vector<Metamer>& metamers) {
    constexpr float half = 0.70710678f;
    std::array<float, 8> reach{};
    for (const Metamer& metamer : metamers) {
        if (metamer.died >= 0)
            continue;
        const float x = metamer.position.x, y = metamer.position.y;
        const float a = half * (x + y), b = half * (x - y);
        const std::array<float, 4> along = {x, y, a, b};
        for (std::size_t i = 0; i < 4; ++i) {
            reach[i] = std::max(reach[i], along[i]);
            reach[i + 4] = std::max(reach[i + 4], -along[i]);
        }
    }
    float sum = 0.0f;
    for (const float r : reach)
        sum += r;
    return sum / 8.0f;
}

} // namespace osgTreeWind

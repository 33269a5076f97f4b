// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowTree.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/growth/GrowthKeys.h>

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <optional>

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

/// Mean horizontal reach of the living nodes in eight directions, metres.
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
        return leaning * glm::vec2(math::cos(towards), math::sin(towards));
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
        float& area = _state.metamerOf(bud).leafArea;
        if (bud.terminal)
            area = std::max(area, habit.leafArea * restingShootLength);
    }
}

void GrowingTree::addLeaves(ShadeGrid& grid) const {
    for (const Metamer& metamer : _state.metamers)
        if (metamer.leafArea > 0.0f)
            grid.addLeaves(_foot + metamer.position, metamer.leafArea);
}

void GrowingTree::grow(const ShadeGrid& grid) {
    for (Metamer& metamer : _state.metamers)
        if (metamer.leafArea > 0.0f)
            metamer.light = grid.light(_foot + metamer.position);
    for (Bud& bud : _state.buds) {
        const Metamer& metamer = _state.metamerOf(bud);
        bud.light = grid.light(_foot + metamer.position + 0.7f * grid.cellSize() * bud.heading);
    }
    measureSideLight(grid);
    growYear(_state, grid, _foot);
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

namespace {

/// Height of neighbours that do not grow here / height of the tree among them.
constexpr float neighbourHeight = 0.94f;
/// Distance between seedlings / between the grown trees.
constexpr float seedlingDistance = 0.4f;

} // namespace

float lightCellSize(const TreeHabit& habit) {
    return std::clamp(1.8f * habit.internode[0], 0.3f, 1.0f);
}

void GrowingStand::growYear(const GrowthSite& site) {
    if (_trees.empty())
        return;
    glm::vec3 lowest = _trees.front().foot(), highest = lowest;
    for (GrowingTree& tree : _trees)
        tree.unfoldLeaves(lowest, highest);
    _grid.reset(lowest, highest);
    for (const GrowingTree& tree : _trees)
        tree.addLeaves(_grid);
    const GrowingTree& first = _trees.front();
    GrowthSite now = site;
    now.distance *= glm::mix(seedlingDistance, 1.0f, first.state().relativeHeight());
    _grid.addNeighbours(now, glm::vec2(first.foot()) + first.state().crownCentre,
                        std::max(neighbourHeight * first.height(), 1.0f));
    _grid.computeLight();
    for (GrowingTree& tree : _trees)
        tree.grow(_grid);
}

namespace {

constexpr float stemTaper = 0.6f;
constexpr float maxBranchRatio = 0.88f;
/// Lower limit of the radius of the trunk's top / at breast height.
constexpr float minTopRatio = 1e-3f;

/// Number of shoot tips that each metamer bears.
std::vector<int> countTips(const std::vector<GrownMetamer>& metamers) {
    std::vector<int> ends(metamers.size(), 0);
    for (std::size_t i = metamers.size(); i-- > 0;) {
        ends[i] = std::max(ends[i], 1);
        if (metamers[i].parent >= 0)
            ends[static_cast<std::size_t>(metamers[i].parent)] += ends[i];
    }
    return ends;
}

/// Radius of wood from the number of its shoot tips. Boughs together have about the cross-section of the
/// trunk (Leonardo's rule); twigs taper faster, to the radius of the thinnest.
class PipeModel {
public:
    PipeModel(float trunk, float twig, int ends)
        : _trunk(trunk), _logEnds(math::log(static_cast<float>(ends))),
          _thinning(std::min(math::log(twig / trunk) + area * _logEnds, 0.4f * area * _logEnds)) {}

    float radius(int ends) const {
        const float share = math::log(static_cast<float>(ends)) / _logEnds, thin = 1.0f - share;
        return _trunk * static_cast<float>(
                            math::exp(static_cast<double>(thin * (thin * _thinning - area * _logEnds))));
    }

private:
    static constexpr float area = 0.46f;
    float _trunk, _logEnds, _thinning;
};

/// Sets the radii of a form by the pipe model (Shinozaki et al. 1964): a radius is a power of the number of
/// shoot tips that the wood bears, scaled to the trunk's diameter. The trunk tapers as (height - z)^0.6, like
/// measured stems with a form factor of 0.5. An axis gets thinner from base to tip, and is thinner than 0.9
/// of its parent. @param twigRadius radius of the thinnest shoots, metres.
void setRadii(GrownForm& form, const GrowthGoal& goal, float twigRadius) {
    std::vector<GrownMetamer>& metamers = form.metamers;
    const std::vector<int> ends = countTips(metamers);
    const float breast = std::min(1.3f, 0.1f * goal.height), atBreast = 0.5f * goal.trunkDiameter;
    const float twig = std::min(twigRadius, 0.2f * atBreast);
    const PipeModel pipes(atBreast, twig, std::max(ends[0], 3));
    float trunkTop = 0.0f;
    for (const GrownMetamer& metamer : metamers)
        if (metamer.axis == 0)
            trunkTop = std::max(trunkTop, metamer.position.z);
    const bool dissolves = trunkTop < 0.93f * goal.height;
    std::vector<float> factor(metamers.size(), 1.0f);
    for (std::size_t i = 0; i < metamers.size(); ++i) {
        GrownMetamer& metamer = metamers[i];
        const float pipe = pipes.radius(ends[i]);
        const auto parent = static_cast<std::size_t>(std::max(metamer.parent, 0));
        if (metamer.axis == 0) {
            const float above = std::max(goal.height - metamer.position.z, 0.0f) / (goal.height - breast);
            metamer.radius = std::max(atBreast * math::pow(above, stemTaper), minTopRatio * atBreast);
            metamer.radius = std::max(metamer.radius, 0.8f * twig);
            if (dissolves) {
                // Where limbs branch off, the rest of the trunk follows the pipe model.
                const float along =
                    std::max(metamer.position.z - breast, 0.0f) / std::max(trunkTop - breast, 0.01f);
                metamer.radius += std::min(along * along, 1.0f) * std::min(pipe - metamer.radius, 0.0f);
            }
            if (i > 0)
                metamer.radius = std::min(metamer.radius, metamers[parent].radius);
            continue;
        }
        const float parentRadius = metamers[parent].radius;
        const bool first = metamers[parent].axis != metamer.axis;
        factor[i] = first ? std::min(1.0f, maxBranchRatio * parentRadius / pipe) : factor[parent];
        metamer.radius = std::min(pipe * factor[i], parentRadius);
    }
}

/// Form of a tree's present state, stretched to fit `goal`, with radii.
GrownForm fittedForm(const TreeState& tree, const GrowthGoal& goal) {
    GrownForm form;
    form.years = tree.year;
    form.spread = tree.spread;
    form.heightFactor = goal.height / std::max(tree.height, 0.01f);
    form.widthFactor = 0.5f * goal.crownWidth / std::max(tree.crownRadius, 0.01f);
    form.metamers.reserve(tree.metamers.size());
    for (const Metamer& metamer : tree.metamers) {
        GrownMetamer to;
        to.position = metamer.position * glm::vec3(form.widthFactor, form.widthFactor, form.heightFactor);
        to.parent = metamer.parent;
        to.axis = metamer.axis;
        to.order = metamer.order;
        to.born = metamer.born;
        to.dead = metamer.died >= 0;
        to.light = metamer.light;
        to.leafArea = metamer.leafArea;
        form.metamers.push_back(to);
    }
    setRadii(form, goal, tree.habit.twigRadius);
    return form;
}

/// Limit of the growths that search the crown's width.
constexpr std::size_t maxGrowths = 6;
/// Large trees get fewer growths: limit of the sum of metamers times years.
constexpr std::size_t maxWork = 1'500'000;
/// Height times crown width above which metamers get longer, m².
constexpr float referenceCrown = 150.0f;
/// Accepted relative difference between the stretches of height and width.
constexpr float stretchTolerance = 0.08f;

GrowthSite inRange(GrowthSite site) {
    constexpr GrowthSite usual;
    site.shade = clampOr(site.shade, 0.0f, 1.0f, usual.shade);
    site.distance = clampOr(site.distance, 0.5f, 100.0f, usual.distance);
    if (site.openSide && !std::isfinite(*site.openSide))
        site.openSide.reset();
    return site;
}

/// Lengthens the metamers of large trees, which bounds their number.
TreeHabit scaleMetamers(const GrowthGoal& goal, TreeHabit habit) {
    const float longer = math::pow(std::max(goal.height * goal.crownWidth / referenceCrown, 1.0f), 0.65f);
    for (float& internode : habit.internode)
        internode *= longer;
    habit.leafArea *= longer;
    habit.twigRadius *= longer;
    return habit;
}

TreeState growOnce(const TreeHabit& habit, const GrowthSite& site, const GrowthGoal& goal, std::uint32_t seed,
                   float spread) {
    GrowingStand stand(lightCellSize(habit));
    stand.add(GrowingTree(habit, goal, glm::vec3(0.0f), seed, spread));
    while (!stand.trees().front().isFullyGrown())
        stand.growYear(site);
    return stand.trees().front().state();
}

/// Searches the vigour of boughs that gives the crown its width.
class SpreadSearch {
public:
    float next() const { return _spread; }
    /// @param widthRatio intended / grown width of a tree with the spread of next().
    void update(float widthRatio) {
        (widthRatio > 1.0f ? _narrow : _wide) = _spread;
        _spread = _narrow > 0.0f && _wide > 0.0f
                      ? std::sqrt(_narrow * _wide)
                      : std::clamp(_spread * math::pow(widthRatio, 1.2f), 0.3f, 3.0f);
    }

private:
    float _spread = 1.0f;
    float _narrow = 0.0f, _wide = 0.0f; ///< Latest spreads of too narrow and too wide crowns; 0 if unknown.
};

} // namespace

GrownForm growTree(const GrowthParameters& parameters) {
    const GrowthSite site = inRange(parameters.site);
    const GrowthParameters growth = clampedKeys(parameters);
    const GrowthGoal goal = growth.size;
    const TreeHabit habit = scaleMetamers(goal, growth.habit);
    std::optional<TreeState> best;
    SpreadSearch search;
    float bestError = 0.0f;
    std::size_t work = 0;
    for (std::size_t i = 0; i < maxGrowths && work < maxWork; ++i) {
        TreeState tree = growOnce(habit, site, goal, growth.seed, search.next());
        work += tree.metamers.size() * static_cast<std::size_t>(tree.year);
        const float widthRatio = 0.5f * goal.crownWidth / std::max(tree.crownRadius, 0.01f) *
                                 std::max(tree.height, 0.01f) / goal.height;
        const float error = std::max(widthRatio, 1.0f / widthRatio) - 1.0f;
        if (!best || error < bestError) {
            best = std::move(tree);
            bestError = error;
        }
        if (bestError <= stretchTolerance)
            break;
        search.update(widthRatio);
    }
    return fittedForm(*best, goal);
}

} // namespace osgTreeWind

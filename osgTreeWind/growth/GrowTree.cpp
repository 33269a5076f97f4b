// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowTree.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/growth/GrowingStand.h>
#include <osgTreeWind/growth/GrowthFields.h>
#include <osgTreeWind/growth/PipeRadii.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace osgTreeWind {
namespace {

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
    const float longer = power(std::max(goal.height * goal.crownWidth / referenceCrown, 1.0f), 0.65f);
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
        _spread = _narrow > 0.0f && _wide > 0.0f ? std::sqrt(_narrow * _wide)
                                                 : std::clamp(_spread * power(widthRatio, 1.2f), 0.3f, 3.0f);
    }

private:
    float _spread = 1.0f;
    float _narrow = 0.0f, _wide = 0.0f; ///< Latest spreads of too narrow and too wide crowns; 0 if unknown.
};

} // namespace

GrownForm growTree(const GrowthParameters& parameters) {
    const GrowthSite site = inRange(parameters.site);
    const GrowthParameters growth = clampedFields(parameters);
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

} // namespace osgTreeWind

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

/// Growths until the crown has its width.
constexpr std::size_t mostGrowths = 6;
/// Of them a large tree gets fewer: metamers times years of all of them.
constexpr std::size_t mostWork = 1'500'000;
/// Height times width of a crown above which pieces get longer, m².
constexpr float usualCrown = 150.0f;
/// Height and width may be stretched by factors that differ by so much.
constexpr float nearEnough = 0.08f;

GrowthSite inRange(GrowthSite site) {
    constexpr GrowthSite usual;
    site.shade = clampOr(site.shade, 0.0f, 1.0f, usual.shade);
    site.distance = clampOr(site.distance, 0.5f, 100.0f, usual.distance);
    if (site.openSide && !std::isfinite(*site.openSide))
        site.openSide.reset();
    return site;
}

/// A large tree grows in longer pieces, so that it has no more of them than one in its middle age.
TreeHabit inPiecesFor(const GrowthGoal& goal, TreeHabit habit) {
    const float longer = power(std::max(goal.height * goal.crownWidth / usualCrown, 1.0f), 0.65f);
    for (float& internode : habit.internode)
        internode *= longer;
    habit.leafArea *= longer;
    habit.twigRadius *= longer;
    return habit;
}

TreeState grownTree(const TreeHabit& habit, const GrowthSite& site, const GrowthGoal& goal,
                    std::uint32_t seed, float spread) {
    GrowingStand stand(lightCell(habit));
    stand.add(GrowingTree(habit, goal, glm::vec3(0.0f), seed, spread));
    while (!stand.trees().front().grown())
        stand.growYear(site);
    return stand.trees().front().state();
}

/// Looks for the vigour of side shoots that makes a crown as wide as it is to be.
class SpreadSearch {
public:
    float next() const { return _spread; }
    /// @param tooNarrow wanted over grown width, of a tree with the spread that next() gave.
    void learn(float tooNarrow) {
        (tooNarrow > 1.0f ? _narrow : _wide) = _spread;
        _spread = _narrow > 0.0f && _wide > 0.0f ? std::sqrt(_narrow * _wide)
                                                 : std::clamp(_spread * power(tooNarrow, 1.2f), 0.3f, 3.0f);
    }

private:
    float _spread = 1.0f;
    float _narrow = 0.0f, _wide = 0.0f; ///< Spreads that made a crown too narrow, too wide; 0: none yet.
};

} // namespace

GrownForm growTree(const GrowthParameters& parameters) {
    const GrowthSite site = inRange(parameters.site);
    const GrowthParameters growth = clampedFields(parameters);
    const GrowthGoal goal = growth.size;
    const TreeHabit habit = inPiecesFor(goal, growth.habit);
    std::optional<TreeState> best;
    SpreadSearch search;
    float leastMiss = 0.0f;
    std::size_t work = 0;
    for (std::size_t i = 0; i < mostGrowths && work < mostWork; ++i) {
        TreeState tree = grownTree(habit, site, goal, growth.seed, search.next());
        work += tree.metamers.size() * static_cast<std::size_t>(tree.year);
        const float tooNarrow =
            0.5f * goal.crownWidth / std::max(tree.reach, 0.01f) * std::max(tree.height, 0.01f) / goal.height;
        const float miss = std::max(tooNarrow, 1.0f / tooNarrow) - 1.0f;
        if (!best || miss < leastMiss) {
            best = std::move(tree);
            leastMiss = miss;
        }
        if (leastMiss <= nearEnough)
            break;
        search.learn(tooNarrow);
    }
    return fittedForm(*best, goal);
}

GrownForm fittedForm(const TreeState& tree, const GrowthGoal& goal) {
    GrownForm form;
    form.years = tree.year;
    form.spread = tree.spread;
    form.heightFactor = goal.height / std::max(tree.height, 0.01f);
    form.widthFactor = 0.5f * goal.crownWidth / std::max(tree.reach, 0.01f);
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

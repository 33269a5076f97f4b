// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowTree.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/growth/GrowingStand.h>
#include <osgTreeWind/growth/HabitNumbers.h>
#include <osgTreeWind/growth/PipeRadii.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace osgTreeWind {
namespace {

/// Growths until the crown has its width.
constexpr int mostTries = 3;
/// Height and width may be stretched by factors that differ by so much.
constexpr float nearEnough = 0.08f;

GrowthGoal clamped(GrowthGoal goal) {
    const auto within = [](float value, float least, float most, float usual) {
        return std::isnan(value) ? usual : std::clamp(value, least, most);
    };
    goal.height = within(goal.height, 1.0f, 100.0f, 15.0f);
    goal.trunkDiameter = within(goal.trunkDiameter, 0.01f, 5.0f, 0.4f);
    goal.crownWidth = within(goal.crownWidth, 0.2f, 60.0f, 8.0f);
    return goal;
}

GrowthSite clamped(GrowthSite site) {
    site.shade = std::isnan(site.shade) ? 0.0f : std::clamp(site.shade, 0.0f, 1.0f);
    site.distance = std::isnan(site.distance) ? 5.0f : std::clamp(site.distance, 0.5f, 100.0f);
    if (site.openSide && !std::isfinite(*site.openSide))
        site.openSide.reset();
    return site;
}

TreeState grownTree(const TreeHabit& habit, const GrowthSite& site, const GrowthGoal& goal,
                    std::uint32_t seed, float spread) {
    GrowingStand stand(gridCell(habit));
    stand.add(GrowingTree(habit, goal, glm::vec3(0.0f), seed, spread));
    while (!stand.trees().front().grown())
        stand.growYear(site);
    return stand.trees().front().state();
}

} // namespace

GrownForm growTree(const TreeHabit& wanted, const GrowthSite& place, const GrowthGoal& size,
                   std::uint32_t seed) {
    const TreeHabit habit = clampedHabit(wanted);
    const GrowthSite site = clamped(place);
    const GrowthGoal goal = clamped(size);
    std::optional<TreeState> best;
    float spread = 1.0f, leastMiss = 0.0f;
    for (int i = 0; i < mostTries; ++i) {
        TreeState tree = grownTree(habit, site, goal, seed, spread);
        const float tooNarrow =
            0.5f * goal.crownWidth / std::max(tree.reach, 0.01f) * std::max(tree.height, 0.01f) / goal.height;
        const float miss = std::max(tooNarrow, 1.0f / tooNarrow) - 1.0f;
        if (!best || miss < leastMiss) {
            best = std::move(tree);
            leastMiss = miss;
        }
        if (leastMiss <= nearEnough)
            break;
        spread = std::clamp(spread * power(tooNarrow, 1.2f), 0.2f, 5.0f);
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

// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/ShedBranches.h>

#include <vector>

namespace osgTreeWind {
namespace {

enum class Fate : unsigned char { Lives, Dies, Falls };

/// When a bough dies, the wood that grew after this share of its life breaks off.
constexpr float snapShare = 0.5f;
/// Below this share of the clean stem, branches are browsed or mown.
constexpr float browsingShare = 0.6f;

/// Light that the wood of a branch needs: this share of full light on leaves along all of it.
constexpr float woodUpkeep = 0.04f;

/// Sums over all that a metamer bears: leaf area, leaf area times light, and length of living wood.
struct Foliage {
    float area = 0.0f, light = 0.0f, wood = 0.0f;
};

std::vector<Foliage> sumFoliage(const std::vector<Metamer>& metamers) {
    std::vector<Foliage> foliage(metamers.size());
    for (std::size_t i = metamers.size() - 1; i > 0; --i) {
        foliage[i].area += metamers[i].leafArea;
        foliage[i].light += metamers[i].leafArea * metamers[i].light;
        foliage[i].wood += metamers[i].died < 0 ? metamers[i].length : 0.0f;
        Foliage& parent = foliage[static_cast<std::size_t>(metamers[i].parent)];
        parent.area += foliage[i].area;
        parent.light += foliage[i].light;
        parent.wood += foliage[i].wood;
    }
    return foliage;
}

/// Whether a branch, given by its first metamer, dies this year.
bool branchDies(TreeState& tree, const Metamer& first, const Foliage& foliage) {
    const TreeHabit& habit = tree.habit;
    const int age = tree.year - first.born;
    if (age < 2)
        return false;
    const float clean = habit.cleanStem * tree.goal.height;
    if (age > 4 && first.position.z < browsingShare * clean && tree.height > 0.5f * tree.goal.height)
        return true;
    if (first.order == 1 && age > 8 && tree.random.uniform() < habit.breakage)
        return true;
    if (first.order == 1 && !tree.axes[static_cast<std::size_t>(first.axis)].leading) {
        if (first.position.z < clean && tree.height > 2.0f * first.position.z + 1.0f && age > 4)
            return true;
    }
    if (age > 4 && foliage.light < woodUpkeep * habit.leafArea * foliage.wood)
        return true;
    return foliage.area <= 0.0f || foliage.light < tree.lightNeed() * foliage.area;
}

std::vector<Fate> decideFates(TreeState& tree) {
    std::vector<Metamer>& metamers = tree.metamers;
    const std::vector<Foliage> foliage = sumFoliage(metamers);
    std::vector<Fate> fates(metamers.size(), Fate::Lives);
    const int deadYears = tree.habit.deadYears;
    for (std::size_t i = 1; i < metamers.size(); ++i) {
        Metamer& metamer = metamers[i];
        const auto parent = static_cast<std::size_t>(metamer.parent);
        const bool first = metamer.axis != metamers[parent].axis;
        if (fates[parent] == Fate::Falls) {
            fates[i] = Fate::Falls;
        } else if (metamer.died >= 0) {
            // The twigs of a dead bough fall first.
            const int stays = metamer.order == 1 ? deadYears : metamer.order == 2 ? deadYears / 2 : 0;
            fates[i] = first && tree.year - metamer.died >= stays ? Fate::Falls : Fate::Dies;
        } else if (fates[parent] == Fate::Dies) {
            const int since = tree.axes[static_cast<std::size_t>(metamer.axis)].born;
            const bool outer =
                static_cast<float>(metamer.born - since) > snapShare * static_cast<float>(tree.year - since);
            fates[i] = metamer.order > 2 || outer ? Fate::Falls : Fate::Dies;
        } else if (first && branchDies(tree, metamer, foliage[i])) {
            fates[i] = metamer.order == 1 && deadYears > 0 ? Fate::Dies : Fate::Falls;
        }
        if (fates[i] == Fate::Dies && metamer.died < 0)
            metamer.died = tree.year;
    }
    return fates;
}

} // namespace

void shedBranches(TreeState& tree) {
    const std::vector<Fate> fates = decideFates(tree);
    std::vector<int> place(tree.metamers.size(), -1);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < tree.metamers.size(); ++i) {
        if (fates[i] == Fate::Falls)
            continue;
        Metamer metamer = tree.metamers[i];
        if (metamer.parent >= 0)
            metamer.parent = place[static_cast<std::size_t>(metamer.parent)];
        place[i] = static_cast<int>(kept);
        tree.metamers[kept++] = metamer;
    }
    tree.metamers.resize(kept);
    std::size_t buds = 0;
    for (const Bud& bud : tree.buds) {
        if (bud.spent || fates[static_cast<std::size_t>(bud.node)] != Fate::Lives)
            continue;
        tree.buds[buds] = bud;
        tree.buds[buds++].node = place[static_cast<std::size_t>(bud.node)];
    }
    tree.buds.resize(buds);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <osgTreeWind/base/Batches.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/ShapeCount.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace osgTreeWind {
namespace {

/// Numbers of trees by their heights, in steps.
using Steps = std::map<int, std::size_t>;

constexpr double step = 1.25;
constexpr int mostSteps = 12; // from the usual height
/// Of the trees of a stand by height, those that forms are grown for: small, middling and large ones.
constexpr std::array<double, 3> grownFor{0.15, 0.5, 0.85};

/// Trees of a stand by which its forms get their proportions.
constexpr std::size_t mostMeasured = 1000;

int stepOf(float height, float usual) {
    if (!(height > 0.0f) || !(usual > 0.0f))
        return 0;
    const double steps = std::log(static_cast<double>(height / usual)) / std::log(step);
    return static_cast<int>(std::clamp<double>(std::round(steps), -mostSteps, mostSteps));
}

float heightOf(int steps, float usual) {
    double height = static_cast<double>(usual);
    for (int i = 0; i < std::abs(steps); ++i)
        height = steps > 0 ? height * step : height / step;
    return static_cast<float>(height);
}

/// The step of a tree below which a share of all are.
int stepAt(const Steps& steps, double share) {
    std::size_t all = 0, below = 0;
    for (const auto& [at, trees] : steps)
        all += trees;
    for (const auto& [at, trees] : steps) {
        below += trees;
        if (static_cast<double>(below) >= share * static_cast<double>(all))
            return at;
    }
    return 0;
}

Steps::iterator nearest(Steps& steps, int to) {
    return std::min_element(steps.begin(), steps.end(), [to](const auto& a, const auto& b) {
        return std::abs(a.first - to) < std::abs(b.first - to);
    });
}

/// The steps that forms are grown for, with the trees nearest to each. @param usual whether the usual height
/// is one of them.
Steps grownSteps(const Steps& steps, bool usual) {
    Steps few;
    if (usual)
        few[0] = 0;
    for (const double share : grownFor)
        few[stepAt(steps, share)] = 0;
    for (const auto& [at, trees] : steps)
        nearest(few, at)->second += trees;
    return few;
}

/// Rounded to a power of 1.1, and at most a third or three times; 1 of none.
float medianInTenths(std::vector<float>& factors) {
    if (factors.empty())
        return 1.0f;
    const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
    std::nth_element(factors.begin(), middle, factors.end());
    const double steps = std::round(std::log(static_cast<double>(*middle)) / std::log(1.1));
    return static_cast<float>(std::pow(1.1, std::clamp(steps, -11.0, 11.0)));
}

/// Takes away the step with the fewest trees, which others then stand for. @return false where it has to
/// stay.
bool dropOne(Steps& steps, bool usual) {
    auto least = steps.end();
    for (auto at = steps.begin(); at != steps.end(); ++at)
        if (!(usual && at->first == 0) && (least == steps.end() || at->second < least->second))
            least = at;
    if (steps.size() < 2 || least == steps.end())
        return false;
    const auto [at, trees] = *least;
    steps.erase(least);
    nearest(steps, at)->second += trees;
    return true;
}

} // namespace

ShapeFamilies::ShapeFamilies(const ForestDescription& forest) {
    std::vector<Stands> stands(forest.species.size());
    for (const TreePlacement& tree : forest.trees) {
        if (tree.species >= stands.size())
            continue;
        const Species& species = forest.species[tree.species];
        Stand& stand = stands[tree.species][companyOf(tree, species)];
        const int at = stepOf(tree.size.height, usualHeight(species));
        ++stand.trees[at];
        if (!(tree.size.height > 0.0f))
            stand.usual = true;
        else if (growsByLight(species))
            stand.sizes.emplace_back(at, withCrown(tree.size, species.crown, tree.openGrown));
    }
    for (std::size_t i = 0; i < stands.size(); ++i) {
        const auto namedIn = [&](const std::vector<std::string>& names) {
            return std::find(names.begin(), names.end(), forest.species[i].name) != names.end();
        };
        if (forest.tiles && namedIn(forest.tiles->inForest))
            addUsual(stands[i][InForest]);
        if (forest.tiles && namedIn(forest.tiles->inOpen))
            addUsual(stands[i][InOpen]);
        add(forest.species[i], stands[i]);
    }
}

void ShapeFamilies::addUsual(Stand& stand) {
    ++stand.trees[0];
    stand.usual = true;
}

/// Gives forms the median proportions of their trees, in steps of a tenth.
void ShapeFamilies::proportion(Family& family, const Species& species, Stand& stand, int at) {
    std::vector<float> trunks, crowns; // over what the laws of the species say
    const std::size_t apart = 1 + stand.sizes.size() / mostMeasured;
    for (std::size_t i = 0; i < stand.sizes.size(); i += apart) {
        const auto& [step, size] = stand.sizes[i];
        if (nearest(stand.trees, step)->first != at)
            continue;
        const TreeSize usual = wholeSize({size.height, 0.0f, 0.0f}, species, family.openGrown);
        trunks.push_back(size.trunkDiameter > 0.0f ? size.trunkDiameter / usual.trunkDiameter : 1.0f);
        crowns.push_back(size.crownWidth > 0.0f ? size.crownWidth / usual.crownWidth : 1.0f);
    }
    GrowthParameters& growth = *family.tree.growth;
    growth.size.trunkDiameter *= medianInTenths(trunks);
    growth.size.crownWidth *= medianInTenths(crowns);
    if (!family.openGrown)
        growth.site.distance = growth.size.crownWidth;
}

ShapeFamilies::Company ShapeFamilies::companyOf(const TreePlacement& tree, const Species& species) {
    return tree.openGrown ? InOpen : tree.atEdge && growsByLight(species) ? AtEdge : InForest;
}

void ShapeFamilies::add(const Species& species, bool inForest, bool inOpen) {
    Stands stands;
    if (inForest)
        addUsual(stands[InForest]);
    if (inOpen)
        addUsual(stands[InOpen]);
    add(species, stands);
}

void ShapeFamilies::add(const Species& species, Stands stands) {
    const bool bySize = growsByLight(species);
    const float usual = usualHeight(species);
    if (stands[InForest].trees.empty() && stands[AtEdge].trees.empty() && stands[InOpen].trees.empty())
        addUsual(stands[InForest]);
    if (!bySize && !stands[InForest].trees.empty())
        stands[InOpen].trees.clear();
    std::size_t families = 0;
    for (Stand& stand : stands) {
        if (!stand.trees.empty())
            stand.trees = bySize ? grownSteps(stand.trees, stand.usual) : Steps{{0, stand.trees.size()}};
        families += stand.trees.size();
    }
    const std::size_t shapes = shapeCount(species);
    const std::size_t most = std::max<std::size_t>(shapes / 2, 1); // so that trees of a family differ
    for (bool some = true; some && families > most;) {
        some = false;
        for (Stand& stand : stands)
            if (families > most && dropOne(stand.trees, stand.usual)) {
                some = true;
                --families;
            }
    }
    std::vector<std::size_t> trees; // of each family
    const std::size_t first = _all.size();
    for (const Company company : {InForest, AtEdge, InOpen})
        for (const auto& [at, count] : stands[company].trees) {
            Family family;
            family.species = _ofSpecies.size();
            family.openGrown = company == InOpen;
            family.atEdge = company == AtEdge;
            family.height = heightOf(at, usual);
            family.tree = growthOf(species, family.openGrown, family.atEdge, family.height);
            if (bySize && !(at == 0 && stands[company].usual))
                proportion(family, species, stands[company], at);
            _all.push_back(std::move(family));
            trees.push_back(count);
        }
    // The next shape goes to the family that has most trees for each.
    for (std::size_t i = families; i < shapes; ++i) {
        std::size_t neediest = 0;
        for (std::size_t other = 1; other < families; ++other)
            if (trees[other] * _all[first + neediest].shapes > trees[neediest] * _all[first + other].shapes)
                neediest = other;
        ++_all[first + neediest].shapes;
    }
    _ofSpecies.emplace_back(first, _all.size());
    _usualHeights.push_back(usual);
}

std::size_t ShapeFamilies::indexOf(const TreePlacement& tree) const {
    const auto [first, end] = _ofSpecies[tree.species];
    const float usual = _usualHeights[tree.species];
    const float height = tree.size.height > 0.0f ? tree.size.height : usual;
    // If its own company has no family, wood and edge stand for each other before the open does.
    const auto strangeness = [&](const Family& family) {
        const int company = family.openGrown != tree.openGrown                ? 2
                            : !tree.openGrown && family.atEdge != tree.atEdge ? 1
                                                                              : 0;
        const float off =
            family.height > 0.0f && height > 0.0f ? std::abs(std::log(height / family.height)) : 0.0f;
        return std::make_tuple(company, off);
    };
    std::size_t best = first;
    for (std::size_t i = first + 1; i < end; ++i)
        if (strangeness(_all[i]) < strangeness(_all[best]))
            best = i;
    return best;
}

std::vector<TreeCounts> ShapeFamilies::countLargest() const {
    std::vector<TreeCounts> counts(_all.size());
    runJobs(ThreadPool::executor(), counts.size(), [&](std::size_t i) {
        counts[i] = osgTreeWind::countLargest(_all[i].tree, static_cast<int>(_all[i].shapes));
    });
    return counts;
}

} // namespace osgTreeWind

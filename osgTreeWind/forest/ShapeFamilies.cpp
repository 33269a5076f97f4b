// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/ShapeCount.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace osgTreeWind {
namespace {

/// Number of trees by height class.
using HeightClasses = std::map<int, std::size_t>;

constexpr double classRatio = 1.25;
constexpr int maxClass = 12; // on both sides of the default height
/// Quantiles of the heights in a group that get shapes: small, medium and large trees.
constexpr std::array<double, 3> shapeQuantiles{0.15, 0.5, 0.85};
/// Number of trees of a group that determine the proportions of its shapes.
constexpr std::size_t maxSamples = 1000;

int heightClass(float height, float defaultHeight) {
    if (!(height > 0.0f) || !(defaultHeight > 0.0f))
        return 0;
    const double steps = math::log(static_cast<double>(height / defaultHeight)) / math::log(classRatio);
    return static_cast<int>(std::clamp<double>(std::round(steps), -maxClass, maxClass));
}

float classHeight(int index, float defaultHeight) {
    double height = static_cast<double>(defaultHeight);
    for (int i = 0; i < std::abs(index); ++i)
        height = index > 0 ? height * classRatio : height / classRatio;
    return static_cast<float>(height);
}

int quantileClass(const HeightClasses& classes, double quantile) {
    std::size_t all = 0, below = 0;
    for (const auto& [index, trees] : classes)
        all += trees;
    for (const auto& [index, trees] : classes) {
        below += trees;
        if (static_cast<double>(below) >= quantile * static_cast<double>(all))
            return index;
    }
    return 0;
}

HeightClasses::iterator nearestClass(HeightClasses& classes, int index) {
    return std::min_element(classes.begin(), classes.end(), [index](const auto& a, const auto& b) {
        return std::abs(a.first - index) < std::abs(b.first - index);
    });
}

/// The height classes to grow shapes for, with the trees nearest to each.
HeightClasses shapeClasses(const HeightClasses& classes, bool hasDefaultHeight) {
    HeightClasses selected;
    if (hasDefaultHeight)
        selected[0] = 0;
    for (const double quantile : shapeQuantiles)
        selected[quantileClass(classes, quantile)] = 0;
    for (const auto& [index, trees] : classes)
        nearestClass(selected, index)->second += trees;
    return selected;
}

/// The median rounded to a power of 1.1 and clamped to about [1/3, 3]; 1 for an empty list.
float roundedMedian(std::vector<float>& factors) {
    if (factors.empty())
        return 1.0f;
    const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
    std::nth_element(factors.begin(), middle, factors.end());
    const double steps = std::round(math::log(static_cast<double>(*middle)) / math::log(1.1));
    return static_cast<float>(math::pow(1.1, std::clamp(steps, -11.0, 11.0)));
}

/// Merges the class with the fewest trees into the nearest one. @return false if none can be merged.
bool mergeSmallestClass(HeightClasses& classes, bool hasDefaultHeight) {
    auto smallest = classes.end();
    for (auto it = classes.begin(); it != classes.end(); ++it)
        if (!(hasDefaultHeight && it->first == 0) &&
            (smallest == classes.end() || it->second < smallest->second))
            smallest = it;
    if (classes.size() < 2 || smallest == classes.end())
        return false;
    const auto [index, trees] = *smallest;
    classes.erase(smallest);
    nearestClass(classes, index)->second += trees;
    return true;
}

/// Shares shapes among families: one each, and each further one to the family with the most trees per shape.
void shareShapes(std::size_t shapes, const std::vector<std::size_t>& trees, ShapeFamilies::Family* families) {
    for (std::size_t i = trees.size(); i < shapes; ++i) {
        std::size_t neediest = 0;
        for (std::size_t other = 1; other < trees.size(); ++other)
            if (trees[other] * families[neediest].shapes > trees[neediest] * families[other].shapes)
                neediest = other;
        ++families[neediest].shapes;
    }
}

} // namespace

ShapeFamilies::ShapeFamilies(const ForestDescription& forest) {
    std::vector<TreeGroups> groups(forest.species.size());
    for (const TreePlacement& tree : forest.trees) {
        if (tree.species >= groups.size())
            continue;
        const Species& species = forest.species[tree.species];
        TreeGroup& group = groups[tree.species][growingSpaceOf(tree, species)];
        const int index = heightClass(tree.size.height, usualHeight(species));
        ++group.trees[index];
        if (!(tree.size.height > 0.0f))
            group.hasDefaultHeight = true;
        else if (growsByLight(species))
            group.sizes.emplace_back(index, withCrown(tree.size, species.crown, tree.openGrown));
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const auto isNamedIn = [&](const std::vector<std::string>& names) {
            return std::find(names.begin(), names.end(), forest.species[i].name) != names.end();
        };
        if (forest.tiles && isNamedIn(forest.tiles->inForest))
            addDefaultHeight(groups[i][InForest]);
        if (forest.tiles && isNamedIn(forest.tiles->inOpen))
            addDefaultHeight(groups[i][Open]);
        add(forest.species[i], groups[i]);
    }
}

void ShapeFamilies::addDefaultHeight(TreeGroup& group) {
    ++group.trees[0];
    group.hasDefaultHeight = true;
}

/// Gives the shapes of a height class the median proportions of its trees, rounded to a power of 1.1.
void ShapeFamilies::applyProportions(Family& family, const Species& species, TreeGroup& group, int index) {
    std::vector<float> trunks, crowns; // relative to the allometry of the species
    const std::size_t stride = 1 + group.sizes.size() / maxSamples;
    for (std::size_t i = 0; i < group.sizes.size(); i += stride) {
        const auto& [sizeClass, size] = group.sizes[i];
        if (nearestClass(group.trees, sizeClass)->first != index)
            continue;
        const TreeSize expected = completeSize({size.height, 0.0f, 0.0f}, species, family.openGrown);
        trunks.push_back(size.trunkDiameter > 0.0f ? size.trunkDiameter / expected.trunkDiameter : 1.0f);
        crowns.push_back(size.crownWidth > 0.0f ? size.crownWidth / expected.crownWidth : 1.0f);
    }
    GrowthParameters& growth = *family.tree.growth;
    growth.size.trunkDiameter *= roundedMedian(trunks);
    growth.size.crownWidth *= roundedMedian(crowns);
    if (!family.openGrown)
        growth.site.distance = growth.size.crownWidth;
}

ShapeFamilies::GrowingSpace ShapeFamilies::growingSpaceOf(const TreePlacement& tree, const Species& species) {
    return tree.openGrown ? Open : tree.atEdge && growsByLight(species) ? AtEdge : InForest;
}

void ShapeFamilies::add(const Species& species, bool inForest, bool inOpen) {
    TreeGroups groups;
    if (inForest)
        addDefaultHeight(groups[InForest]);
    if (inOpen)
        addDefaultHeight(groups[Open]);
    add(species, groups);
}

void ShapeFamilies::add(const Species& species, TreeGroups groups) {
    const std::size_t shapes = shapeCount(species), first = _all.size();
    // At least two shapes for most families, so that trees of a family differ.
    selectClasses(groups, growsByLight(species), std::max<std::size_t>(shapes / 2, 1));
    std::vector<std::size_t> trees; // by family
    for (const GrowingSpace space : {InForest, AtEdge, Open})
        for (const auto& [index, count] : groups[space].trees) {
            addFamily(species, groups[space], space, index);
            trees.push_back(count);
        }
    shareShapes(shapes, trees, &_all[first]);
    _familyRanges.emplace_back(first, _all.size());
    _defaultHeights.push_back(usualHeight(species));
}

void ShapeFamilies::selectClasses(TreeGroups& groups, bool bySize, std::size_t maxFamilies) {
    if (groups[InForest].trees.empty() && groups[AtEdge].trees.empty() && groups[Open].trees.empty())
        addDefaultHeight(groups[InForest]);
    if (!bySize && !groups[InForest].trees.empty())
        groups[Open].trees.clear();
    std::size_t families = 0;
    for (TreeGroup& group : groups) {
        if (!group.trees.empty())
            group.trees = bySize ? shapeClasses(group.trees, group.hasDefaultHeight)
                                 : HeightClasses{{0, group.trees.size()}};
        families += group.trees.size();
    }
    for (bool isMerged = true; isMerged && families > maxFamilies;) {
        isMerged = false;
        for (TreeGroup& group : groups)
            if (families > maxFamilies && mergeSmallestClass(group.trees, group.hasDefaultHeight)) {
                isMerged = true;
                --families;
            }
    }
}

void ShapeFamilies::addFamily(const Species& species, TreeGroup& group, GrowingSpace space, int index) {
    Family family;
    family.species = _familyRanges.size();
    family.openGrown = space == Open;
    family.atEdge = space == AtEdge;
    family.height = classHeight(index, usualHeight(species));
    family.tree = growthOf(species, family.openGrown, family.atEdge, family.height);
    if (growsByLight(species) && !(index == 0 && group.hasDefaultHeight))
        applyProportions(family, species, group, index);
    _all.push_back(std::move(family));
}

std::size_t ShapeFamilies::indexOf(const TreePlacement& tree) const {
    const auto [first, end] = _familyRanges[tree.species];
    const float height = tree.size.height > 0.0f ? tree.size.height : _defaultHeights[tree.species];
    // If the tree's growing space has no family, stand and edge are closer to each other than to the open.
    const auto mismatch = [&](const Family& family) {
        const int space = family.openGrown != tree.openGrown                ? 2
                          : !tree.openGrown && family.atEdge != tree.atEdge ? 1
                                                                            : 0;
        const float logRatio =
            family.height > 0.0f && height > 0.0f ? std::abs(math::log(height / family.height)) : 0.0f;
        return std::make_tuple(space, logRatio);
    };
    std::size_t best = first;
    for (std::size_t i = first + 1; i < end; ++i)
        if (mismatch(_all[i]) < mismatch(_all[best]))
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

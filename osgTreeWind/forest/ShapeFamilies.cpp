// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <osgTreeWind/base/Batches.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/ShapeCount.h>

#include <algorithm>
#include <array>

namespace osgTreeWind {

ShapeFamilies::ShapeFamilies(const ForestDescription& forest) {
    std::vector<std::array<bool, 2>> stand(forest.species.size(), {false, false}); // in a forest, in the open
    for (const TreePlacement& tree : forest.trees)
        if (tree.species < stand.size())
            stand[tree.species][tree.openGrown ? 1 : 0] = true;
    for (std::size_t i = 0; forest.tiles && i < stand.size(); ++i) {
        const auto namedIn = [&](const std::vector<std::string>& names) {
            return std::find(names.begin(), names.end(), forest.species[i].name) != names.end();
        };
        stand[i][0] |= namedIn(forest.tiles->inForest);
        stand[i][1] |= namedIn(forest.tiles->inOpen);
    }
    for (std::size_t i = 0; i < stand.size(); ++i)
        add(forest.species[i], stand[i][0], stand[i][1]);
}

void ShapeFamilies::add(const Species& species, bool inForest, bool inOpen) {
    inForest = inForest || !inOpen;
    if (inOpen && inForest)
        inForest = growsByCompany(species);
    const auto family = [&](bool openGrown) {
        _all.push_back({_ofSpecies.size(), openGrown, growthOf(species, openGrown), shapeCount(species)});
        return _all.size() - 1;
    };
    const std::size_t first = family(!inForest);
    _ofSpecies.emplace_back(first, inForest && inOpen ? family(true) : first);
}

std::vector<TreeCounts> ShapeFamilies::countLargest() const {
    std::vector<TreeCounts> counts(_all.size());
    runJobs(ThreadPool::executor(), counts.size(), [&](std::size_t i) {
        counts[i] = osgTreeWind::countLargest(_all[i].tree, static_cast<int>(_all[i].shapes));
    });
    return counts;
}

} // namespace osgTreeWind

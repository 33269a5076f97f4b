// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/StandOnGround.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/CheckForest.h>
#include <osgTreeWind/forest/GroundPlacer.h>

namespace osgTreeWind {

Diagnostics standOnGround(ForestDescription& forest, const std::vector<std::size_t>& trees) {
    if (!forest.ground)
        return {};
    if (Diagnostics problems = check(forest); !problems.empty())
        return problems;
    for (const std::size_t tree : trees)
        if (tree >= forest.trees.size())
            return {keyProblem("tree", "there is no tree " + std::to_string(tree))};
    GroundPlacer placer(forest);
    placer.place(forest.trees, trees);
    return placer.problems();
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/StandOnGround.h>

#include <osgTreeWind/forest/FeetOnGround.h>

namespace osgTreeWind {

Diagnostics standOnGround(ForestDescription& forest, const std::vector<std::size_t>& trees) {
    if (!forest.ground)
        return {};
    FeetOnGround feet(forest);
    feet.put(forest.trees, trees);
    return feet.problems();
}

} // namespace osgTreeWind

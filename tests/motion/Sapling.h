// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

/// A small flexible tree of 2 + 3 + 9 units.
inline osgTreeWind::Species sapling() {
    osgTreeWind::Species species;
    species.name = "sapling";
    species.tree.wood.levels = 2;
    species.tree.leaves.clustersPerBranch = 2;
    species.wood.elasticModulus = 2.0e6f;
    return species;
}

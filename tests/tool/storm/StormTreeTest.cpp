// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/StormTree.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

// ForestGALES: its limits with the moment of the wind of 111.7 d^2 h U^2 (Hale et al. 2012), times 1.136 for
// the overhanging weight (Hale et al. 2015).
TEST(StormTree, FallsNearTheWindsOfForestGales) {
    const Species spruce = *findSpecies("Norway spruce");
    TreePlacement tree;
    tree.size.height = 20.0f;
    tree.size.trunkDiameter = 0.24f;
    const Storm stand{10.0, 2.8, 1}; // crowns cover the ground
    const CriticalSpeeds critical = criticalSpeedsOf(spruce, tree, stand);
    const double hale = 1.136 * 111.7 * 0.24 * 0.24 * 20.0;
    const TreeStrength strength = StormTree(spruce, tree, stand).strength();
    // Computed ratios: 0.71 and 0.71. The largest moment of an hour is greater than that of ForestGALES
    // (docs/validation.md).
    EXPECT_NEAR(critical.uproot.value() / std::sqrt(strength.uproot / hale), 0.85, 0.15);
    EXPECT_NEAR(critical.breaking.value() / std::sqrt(strength.breaking / hale), 0.85, 0.15);
}

} // namespace osgTreeWind

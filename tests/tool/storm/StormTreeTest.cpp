// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/StormTree.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

// ForestGALES: its limits under the wind's moment of 111.7 d^2 h U^2 (Hale et al. 2012) and that of what
// hangs over, 1.136 of it (Hale et al. 2015).
TEST(StormTree, FallsInTheWindThatForestGalesHas) {
    const Species spruce = *findSpecies("Norway spruce");
    TreePlacement tree;
    tree.size.height = 20.0f;
    tree.size.trunkDiameter = 0.24f;
    const Storm stand{10.0, 2.8, 1}; // their crowns fill the ground
    const CriticalSpeeds critical = criticalSpeedsOf(spruce, tree, stand);
    const double hale = 1.136 * 111.7 * 0.24 * 0.24 * 20.0;
    const TreeStrength bears = StormTree(spruce, tree, stand).strength();
    // 0.79 and 0.80 of it: crowns of a stand have their measured depth, so the wind takes hold higher up.
    EXPECT_NEAR(critical.uproot.value() / std::sqrt(bears.uproot / hale), 0.85, 0.15);
    EXPECT_NEAR(critical.breaking.value() / std::sqrt(bears.breaking / hale), 0.85, 0.15);
}

} // namespace osgTreeWind

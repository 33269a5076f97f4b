// SPDX-License-Identifier: MIT
// Prints a column of docs/species.md: edgesOverSingleLeaves() of a built-in species at 10, 20, 40 and 80 m.
// Usage: leaf_edges SPECIES
#include <tests/tool/portraits/LeafEdges.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/species/GrowthLaws.h>

#include <cstdio>

int main(int count, char** words) {
    using namespace osgTreeWind;
    const auto species = findSpecies(count == 2 ? words[1] : "");
    if (!species)
        return 2;
    const TreeModel model = makeTreeModel(growthOf(*species, true));
    for (const float distance : {10.0f, 20.0f, 40.0f, 80.0f})
        std::printf("%s%.2f", distance == 10.0f ? "" : "/",
                    static_cast<double>(edgesOverSingleLeaves(model, species->appearance, distance)));
}

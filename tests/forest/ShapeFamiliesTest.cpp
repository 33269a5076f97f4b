// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// A forest of two species whose trees stand in the open or not.
ForestDescription standing(std::initializer_list<std::pair<std::size_t, bool>> trees) {
    ForestDescription forest;
    forest.species = {*findSpecies("Sitka spruce"), *findSpecies("palm")};
    forest.species[0].crown.depthPerHeight = 0.5f;
    for (Species& species : forest.species)
        species.shapes = 3;
    for (const auto& [species, openGrown] : trees) {
        TreePlacement tree;
        tree.species = species;
        tree.openGrown = openGrown;
        tree.size.height = 20.0f;
        tree.seed = static_cast<std::uint32_t>(forest.trees.size());
        forest.trees.push_back(tree);
    }
    return forest;
}

} // namespace

TEST(ShapeFamilies, OneCompanyIsGrownOnce) {
    const auto shapes = [](const ForestDescription& forest) { return PlacedForest(forest).models().size(); };
    EXPECT_EQ(Species().shapes, 8);
    EXPECT_EQ(shapes(standing({})), 6u);
    EXPECT_EQ(shapes(standing({{0, false}, {0, false}})), 6u);
    EXPECT_EQ(shapes(standing({{0, true}})), 6u);
    EXPECT_EQ(shapes(standing({{0, true}, {0, false}})), 9u);
    EXPECT_EQ(shapes(standing({{1, true}, {1, false}})), 6u) << "palms grow alike";
}

TEST(ShapeFamilies, ModelsKnowTheirSpecies) {
    const PlacedForest forest(standing({{0, true}, {0, false}, {1, true}}));
    for (std::size_t model = 0; model < forest.models().size(); ++model)
        EXPECT_EQ(forest.speciesOfModel(model), model < 6 ? 0u : 1u) << model;
    for (const PlacedTree& tree : forest.trees)
        EXPECT_EQ(forest.speciesOfModel(tree.model), tree.species);
}

TEST(ShapeFamilies, ATreeInTheOpenKeepsItsCrown) {
    const PlacedForest forest(standing({{0, true}, {0, false}}));
    const Skeleton alone = makeTreeModel(findSpecies("Sitka spruce")->tree, 0).skeleton;
    EXPECT_EQ(forest.modelOf(forest.trees[0]).skeleton.points, alone.points);
    EXPECT_NE(forest.modelOf(forest.trees[1]).skeleton.points, alone.points);
}

TEST(ShapeFamilies, ATreeThatComesLaterTakesTheShapesThatAreThere) {
    const PlacedForest forest(standing({{0, false}}));
    TreePlacement tree = standing({{0, true}}).trees.front();
    EXPECT_EQ(forest.fitted(tree).model, forest.trees[0].model);
    EXPECT_TRUE(forest.fitted(tree).openGrown);
}

TEST(ShapeFamilies, APlacementGivesTheSameCrownAgain) {
    const PlacedForest forest(standing({{0, true}, {0, false}}));
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const PlacedTree again = forest.fitted(forest.placementOf(slot));
        EXPECT_EQ(again.model, forest.trees[slot].model);
        EXPECT_NEAR(again.scale.axes.z, forest.trees[slot].scale.axes.z, 0.02f);
    }
}

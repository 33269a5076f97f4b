// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ShapeFamilies.h>

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// A forest of two species. Each tree is given by its species and whether it is open-grown.
ForestDescription twoSpeciesForest(std::initializer_list<std::pair<std::size_t, bool>> trees) {
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

TEST(ShapeFamilies, GrowingSpacesShareTheShapesOfASpecies) {
    const auto shapes = [](const ForestDescription& forest) { return PlacedForest(forest).models().size(); };
    EXPECT_EQ(shapes(twoSpeciesForest({})), 6u);
    EXPECT_EQ(shapes(twoSpeciesForest({{0, false}, {0, false}})), 6u);
    EXPECT_EQ(shapes(twoSpeciesForest({{0, true}})), 6u);
    EXPECT_EQ(shapes(twoSpeciesForest({{0, true}, {0, false}})), 6u) << "both share 3";
    EXPECT_EQ(shapes(twoSpeciesForest({{1, true}, {1, false}})), 6u) << "palms ignore the growing space";
}

TEST(ShapeFamilies, ModelsKnowTheirSpecies) {
    const PlacedForest forest(twoSpeciesForest({{0, true}, {0, false}, {1, true}}));
    for (std::size_t model = 0; model < forest.models().size(); ++model)
        EXPECT_EQ(forest.speciesOfModel(model), model < 3 ? 0u : 1u) << model;
    for (const PlacedTree& tree : forest.trees)
        EXPECT_EQ(forest.speciesOfModel(tree.model), tree.species);
}

TEST(ShapeFamilies, OpenGrownTreesKeepTheSpeciesCrown) {
    const PlacedForest forest(twoSpeciesForest({{0, true}, {0, false}}));
    const Skeleton alone = makeTreeModel(findSpecies("Sitka spruce")->tree, 0).skeleton;
    EXPECT_EQ(forest.modelOf(forest.trees[0]).skeleton.points, alone.points);
    EXPECT_NE(forest.modelOf(forest.trees[1]).skeleton.points, alone.points);
}

TEST(ShapeFamilies, TreesAddedLaterUseExistingShapes) {
    const PlacedForest forest(twoSpeciesForest({{0, false}}));
    TreePlacement tree = twoSpeciesForest({{0, true}}).trees.front();
    EXPECT_EQ(forest.makePlacedTree(tree).model, forest.trees[0].model);
    EXPECT_TRUE(forest.makePlacedTree(tree).openGrown);
}

TEST(ShapeFamilies, PlacementOfATreeGivesTheSameTree) {
    const PlacedForest forest(twoSpeciesForest({{0, true}, {0, false}}));
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const PlacedTree again = forest.makePlacedTree(forest.placementOf(slot));
        EXPECT_EQ(again.model, forest.trees[slot].model);
        EXPECT_NEAR(again.scale.axes.z, forest.trees[slot].scale.axes.z, 0.02f);
    }
}

namespace {

/// A species that grows by light to 16 m, with trees of these heights. 0: not given.
ForestDescription growingTo(const std::vector<float>& heights, int shapes = 8) {
    ForestDescription forest;
    forest.species = {Species()};
    forest.species.front().shapes = shapes;
    forest.species.front().tree.growth = GrowthParameters();
    forest.species.front().tree.growth->size = {16.0f, 0.4f, 8.0f};
    for (const float height : heights) {
        TreePlacement tree;
        tree.size.height = height;
        forest.trees.push_back(tree);
    }
    return forest;
}

std::vector<float> heightsOf(const ShapeFamilies& families) {
    std::vector<float> heights;
    for (const ShapeFamilies::Family& family : families.all())
        heights.push_back(family.tree.growth->size.height);
    return heights;
}

std::uint32_t shapesOf(const ShapeFamilies& families) {
    std::uint32_t sum = 0;
    for (const ShapeFamilies::Family& family : families.all())
        sum += family.shapes;
    return sum;
}

} // namespace

TEST(ShapeFamilies, ShapesAreGrownForSmallMediumAndLargeTrees) {
    const ShapeFamilies families(growingTo({4, 4, 4, 4, 16, 16, 16, 16, 16, 16, 16, 16, 25, 25, 25, 25}));
    const std::vector<float> heights = heightsOf(families);
    ASSERT_EQ(heights.size(), 3u);
    EXPECT_NEAR(heights[0], 4.0f, 0.3f);
    EXPECT_EQ(heights[1], 16.0f);
    EXPECT_EQ(heights[2], 25.0f);
    EXPECT_EQ(shapesOf(families), 8u);
    EXPECT_EQ(families.all()[1].shapes, 4u) << "half of the trees";
    const ShapeFamilies similar(growingTo({15, 15.5f, 16, 16, 17}));
    EXPECT_EQ(heightsOf(similar), std::vector<float>{16.0f});
    EXPECT_EQ(shapesOf(similar), 8u);
}

TEST(ShapeFamilies, TreesUseTheFamilyNearestInHeight) {
    const ForestDescription forest = growingTo({4, 4, 4, 4, 16, 16, 16, 16, 16, 16, 16, 16, 25, 25, 25, 25});
    const ShapeFamilies families(forest);
    const auto familyFor = [&](float height) {
        TreePlacement tree;
        tree.size.height = height;
        return families.indexOf(tree);
    };
    EXPECT_EQ(familyFor(2.0f), 0u);
    EXPECT_EQ(familyFor(15.0f), 1u);
    EXPECT_EQ(familyFor(19.0f), 1u);
    EXPECT_EQ(familyFor(21.0f), 2u);
    EXPECT_EQ(familyFor(60.0f), 2u);
    EXPECT_EQ(familyFor(0.0f), 1u) << "not given: the default height";
}

TEST(ShapeFamilies, TreesWithoutASizeHaveTheHeightOfTheirSpecies) {
    const ShapeFamilies families(growingTo({0, 4, 4, 4, 4, 4, 4, 25, 25, 25, 25, 25, 25, 25}));
    TreePlacement tree;
    EXPECT_EQ(families.all()[families.indexOf(tree)].tree.growth->size.height, 16.0f);
}

TEST(ShapeFamilies, EachGrowingSpaceHasItsOwnFamily) {
    ForestDescription forest = growingTo({16, 16, 16, 16, 16, 16, 16, 16, 16, 16});
    forest.trees[0].openGrown = true;
    forest.trees[1].atEdge = forest.trees[2].atEdge = true;
    const ShapeFamilies families(forest);
    ASSERT_EQ(families.all().size(), 3u);
    EXPECT_EQ(shapesOf(families), 8u);
    const auto siteOf = [&](std::size_t tree) {
        return families.all()[families.indexOf(forest.trees[tree])].tree.growth->site;
    };
    EXPECT_EQ(siteOf(0).shade, 0.0f);
    EXPECT_EQ(siteOf(1).shade, 1.0f);
    EXPECT_EQ(siteOf(1).openSide, 0.0f);
    EXPECT_EQ(siteOf(9).shade, 1.0f);
    EXPECT_FALSE(siteOf(9).openSide);
    for (const int shapes : {1, 2, 3}) {
        forest.species.front().shapes = shapes;
        EXPECT_EQ(shapesOf(ShapeFamilies(forest)), 3u) << "at least one each";
    }
}

TEST(ShapeFamilies, FewShapesGiveFewHeights) {
    EXPECT_EQ(heightsOf(ShapeFamilies(growingTo({4, 4, 16, 16, 16, 25, 25}, 1))), std::vector<float>{16.0f});
    EXPECT_EQ(heightsOf(ShapeFamilies(growingTo({4, 4, 4, 16, 25, 25, 25, 25}, 5))).size(), 2u);
}

TEST(ShapeFamilies, ShapesHaveTheProportionsOfTheirTrees) {
    ForestDescription forest = growingTo({16, 16, 16, 16, 16});
    for (TreePlacement& tree : forest.trees)
        tree.size = {16.0f, 0.8f, 12.0f};
    const PlacedForest stout(forest);
    for (const PlacedTree& tree : stout.trees) {
        EXPECT_NEAR(tree.scale.axes.x / tree.scale.axes.z, 1.0f, 0.12f);
        EXPECT_NEAR(tree.scale.radius / tree.scale.axes.z, 1.0f, 0.12f);
    }
}

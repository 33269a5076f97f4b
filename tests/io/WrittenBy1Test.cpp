// SPDX-License-Identifier: MIT
// Files written by version 1.0, which must always load (tests/data/written-by-1.0/README.md).
#include <osgTreeWind/io/CrownSummary.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <tests/Folders.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace osgTreeWind;

namespace {

const std::string folder = OSGTREEWIND_TEST_DATA "/written-by-1.0/";

/// Notes on species with [species.growth] of version 1.
std::vector<std::string> legacyGrowthNotes(const std::vector<std::string>& species) {
    std::vector<std::string> notes;
    for (const std::string& name : species)
        notes.push_back(
            "species \"" + name +
            "\": [species.growth] of version 1 is read as [species.habit]: its size is kept, angles and "
            "bends are approximated, and the rest of the form is grown");
    return notes;
}

/// Reads a forest. @param notes that are expected.
ForestDescription writtenForest(const std::string& name, const std::vector<std::string>& notes = {}) {
    const Result<ForestFile> forest = readForestFile(folder + name);
    EXPECT_TRUE(forest) << toString(forest.problems());
    EXPECT_EQ(forest.value().notes, notes) << name;
    return forest.value();
}

glm::vec3 windAt(const ForestDescription& forest, const WindPlace& place, double time) {
    return forest.wind.field ? asField(forest.wind)->velocity(place, time) : glm::vec3(0.0f);
}

/// Checks everything.treewind except for its trees.
void expectEverything(const ForestDescription& forest) {
    EXPECT_EQ(forest.crs, "EPSG:25832");
    EXPECT_EQ(forest.origin, glm::dvec3(400000.0, 5600000.0, 120.0));
    EXPECT_EQ(forest.season, 2.75f);
    EXPECT_EQ(forest.law, MotionLaw::Modal);
    EXPECT_EQ(forest.gain, 1.25f);
    EXPECT_TRUE(forest.damage);
    EXPECT_EQ(forest.noiseExponent, 1.5f);
    EXPECT_EQ(forest.wind.frame, WindFrame::Scene);
    EXPECT_EQ(forest.canopy.source, CanopySource::Forest);
    EXPECT_EQ(forest.canopy.reference, 55.0);
    EXPECT_EQ(forest.drawing.full, 700.0f);
    EXPECT_EQ(forest.drawing.reduced, 200.0f);
    EXPECT_EQ(forest.drawing.impostor, 60.0f);
    EXPECT_EQ(forest.drawing.blend, 0.15f);
    EXPECT_EQ(forest.drawing.budget, 20.0f);

    ASSERT_EQ(forest.species.size(), 3u);
    const Species& recursive = forest.species[0];
    EXPECT_EQ(recursive.name, "recursive");
    EXPECT_EQ(recursive.aliases, (std::vector<std::string>{"thesis tree", "Arbor thesis"}));
    EXPECT_EQ(recursive.shapes, 2);
    EXPECT_EQ(recursive.tree.wood.levels, 3);
    EXPECT_EQ(recursive.tree.wood.seed, 8u);
    EXPECT_EQ(recursive.tree.leaves.clustersPerBranch, 6);
    EXPECT_EQ(recursive.wood.elasticModulus, 7.0e9f);
    EXPECT_EQ(recursive.branch.levelFactor, 0.5f);
    EXPECT_EQ(recursive.leaf.partialSteps, 9.0f);
    EXPECT_EQ(recursive.appearance.leafForm, LeafForm::Palmate);
    EXPECT_EQ(recursive.appearance.barkForm, BarkForm::Smooth);
    const Species& grown = forest.species[1];
    ASSERT_TRUE(grown.tree.growth);
    EXPECT_GT(grown.tree.growth->size.height, 1.0f);
    EXPECT_EQ(grown.height.scale, 30.0f);
    EXPECT_EQ(grown.crown.perDiameter, 18.0f);
    EXPECT_EQ(forest.species[2].name, "Norway spruce");

    const std::vector<WindSource>& sources = forest.wind.sources;
    using Kind = WindSource::Kind;
    const std::vector<Kind> kinds = {Kind::Rotor,   Kind::Jet,     Kind::Vortex,
                                     Kind::Shelter, Kind::Vehicle, Kind::Explosion};
    ASSERT_EQ(sources.size(), kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i)
        EXPECT_EQ(sources[i].kind, kinds[i]) << i;
    EXPECT_EQ(sources[0].thrust, 70000.0);
    EXPECT_EQ(sources[5].time, 8.0);
    EXPECT_EQ(forest.wind.clock.start, 30.0);
    EXPECT_EQ(forest.wind.clock.scale, 1.5);
    const auto mean = std::dynamic_pointer_cast<const UniformWind>(forest.wind.field);
    ASSERT_TRUE(mean);
    EXPECT_EQ(forest.wind.gusts.intensity, 0.25);
    EXPECT_EQ(forest.wind.gusts.seed, 5u);
    EXPECT_NEAR(glm::length(mean->velocity()), 9.0f, 1e-5f);
}

const TreePlacement& treeNamed(const ForestDescription& forest, std::string_view name) {
    return *std::find_if(forest.trees.begin(), forest.trees.end(),
                         [&](const TreePlacement& tree) { return tree.name == name; });
}

void expectTheTreesOfEverything(const ForestDescription& forest) {
    ASSERT_EQ(forest.trees.size(), 12u);
    const TreePlacement& first = treeNamed(forest, "the \"first\" tree");
    EXPECT_EQ(first.species, 0u);
    EXPECT_EQ(first.position, glm::dvec3(400000.0, 5600000.0, 121.5));
    EXPECT_EQ(first.size.height, 8.0f);
    EXPECT_EQ(first.size.trunkDiameter, 0.21f);
    EXPECT_EQ(first.size.crownWidth, 4.5f);
    EXPECT_NEAR(first.heading, 0.5235988f, 1e-6f);
    EXPECT_EQ(first.leaves, 0.5f);
    EXPECT_EQ(first.seed, 3u);
    const TreePlacement& second = treeNamed(forest, "7");
    EXPECT_EQ(second.species, 1u);
    EXPECT_TRUE(second.openGrown);
    EXPECT_TRUE(second.estimated.height);
    EXPECT_FALSE(second.estimated.trunkDiameter);
}

} // namespace

TEST(WrittenBy1, forestOfEverything) {
    const ForestDescription forest =
        writtenForest("everything.treewind", legacyGrowthNotes({"grown", "Norway spruce"}));
    expectEverything(forest);
    expectTheTreesOfEverything(forest);
}

TEST(WrittenBy1, windOnAGrid) {
    const ForestDescription forest =
        writtenForest("grid.treewind", {"motion.law: \"damped\" no longer exists; it is read as \"modal\""});
    EXPECT_EQ(forest.law, MotionLaw::Modal);
    EXPECT_EQ(forest.gain, 2.0f);
    ASSERT_EQ(forest.trees.size(), 2u);
    EXPECT_EQ(forest.trees[1].size.height, 5.0f);
    const glm::vec3 wind = windAt(forest, WindPlace(0.0f, 0.0f, 10.0f), 0.0);
    EXPECT_NEAR(wind.x, 5.9f, 1e-5f); // from `osgtreewind info` of 1.0
    EXPECT_NEAR(wind.y, 0.9f, 1e-5f);
}

TEST(WrittenBy1, windInTheArrayOfTheThesis) {
    const ForestDescription forest = writtenForest("array.treewind");
    EXPECT_EQ(forest.law, MotionLaw::ThesisSmooth);
    ASSERT_EQ(forest.trees.size(), 1u);
    EXPECT_EQ(forest.trees[0].leaves, 0.25f);
    EXPECT_EQ(windAt(forest, WindPlace(0.0f, 0.0f, 10.0f), 0.0).x, 4.0f);
    EXPECT_EQ(windAt(forest, WindPlace(-0.5f, 0.0f, 10.0f), 0.0).x, 2.0f);
}

TEST(WrittenBy1, recordOfWind) {
    const ForestDescription forest =
        writtenForest("forest.treewind", legacyGrowthNotes({"oak", "birch", "spruce"}));
    EXPECT_EQ(forest.law, MotionLaw::Modal);
    EXPECT_EQ(forest.trees.size(), 40u);
    EXPECT_EQ(forest.species.size(), 3u);
    EXPECT_EQ(windAt(forest, WindPlace(0.0f, 0.0f, 10.0f), 15.0), glm::vec3(9.0f, 3.5f, 0.0f));
}

TEST(WrittenBy1, treeOfTheThesis) {
    const ForestDescription forest = writtenForest("thesis.treewind");
    EXPECT_EQ(forest.law, MotionLaw::Thesis);
    ASSERT_EQ(forest.trees.size(), 1u);
    const ForestSimulation simulation(forest);
    EXPECT_EQ(simulation.skeleton(0).units.size(), 122u);
    EXPECT_EQ(windAt(forest, WindPlace(0.0f, 0.0f, 10.0f), 0.0).x, 4.0f);
}

TEST(WrittenBy1, examples) {
    EXPECT_EQ(writtenForest("examples/explosion.treewind").trees.size(), 144u);
    EXPECT_EQ(writtenForest("examples/forest.treewind").trees.size(), 40u);
    EXPECT_EQ(writtenForest("examples/helicopter.treewind").trees.size(), 60u);
    EXPECT_EQ(writtenForest("examples/lorry.treewind").trees.size(), 48u);
    EXPECT_EQ(writtenForest("examples/thesis.treewind").trees.size(), 1u);
}

TEST(WrittenBy1, tiledWorld) {
    ForestDescription world =
        writtenForest("world/world.treewind", legacyGrowthNotes({"grown", "Norway spruce"}));
    expectEverything(world);
    ASSERT_TRUE(world.tiles);
    EXPECT_EQ(world.tiles->columns, 3u);
    EXPECT_EQ(world.tiles->rows(), 2u);
    EXPECT_EQ(world.tiles->size, 30.0);
    EXPECT_EQ(world.tiles->range, 200.0);
    EXPECT_EQ(world.tiles->treeCount(), 12u);
    EXPECT_EQ(world.tiles->inOpen, std::vector<std::string>{"grown"});
    const Result<std::size_t> count = loadTiles(world);
    ASSERT_TRUE(count) << toString(count.problems());
    EXPECT_EQ(count.value(), 12u);
    expectTheTreesOfEverything(world);
}

TEST(WrittenBy1, idsOfATiledWorld) {
    std::ifstream input(folder + "world/tiles/0.ids");
    const Result<TileIds> ids = readTileIds(input, "0.ids");
    ASSERT_TRUE(ids) << toString(ids.problems());
    EXPECT_EQ(ids.value(), (TileIds{{"the \"first\" tree", "1_0/0"}, {"7", "1_0/1"}}));
}

TEST(WrittenBy1, crownsOfATiledWorld) {
    std::ifstream input(folder + "world/tiles/all.crowns");
    const Result<CrownSummary> crowns = readCrownSummary(input, "all.crowns");
    ASSERT_TRUE(crowns) << toString(crowns.problems());
    EXPECT_EQ(crowns.value().cells.size(), 4u);
}

// SPDX-License-Identifier: MIT
#include <tests/tool/canopy/SmallWood.h>

#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/places/FunctionGround.h>

#include <cmath>

namespace osgTreeWind {

namespace {

/// A post of 10 m without branches and leaves; its diameter is 40 cm at the foot and 20 cm at the top.
Species post() {
    Species species;
    species.name = "post";
    species.tree.wood.levels = 0;
    species.tree.wood.trunkUnits = 1;
    species.tree.wood.bareUnits = 0;
    species.tree.wood.length = 10.0f;
    species.tree.wood.radius = 0.2f;
    species.tree.wood.taper = 0.5f;
    species.tree.wood.crook = species.tree.wood.jitter = 0.0f;
    species.tree.leaves.clustersPerBranch = 0;
    return species;
}

ForestDescription onePost(const glm::dvec3& position) {
    ForestDescription forest;
    forest.species = {post()};
    forest.trees = {treeAt(position)};
    return forest;
}

} // namespace

TEST(CanopyRows, HaveTheLeafAreaOfTheTreesInEverySeason) {
    for (const float season : {midwinter, 0.9f, midsummer, 3.2f}) {
        ForestDescription wood = smallWood();
        wood.season = season;
        const PlacedForest forest(wood);
        double expected = 0.0;
        for (const PlacedTree& tree : forest.trees)
            expected += static_cast<double>(
                leafArea(forest.modelOf(tree), tree.scale, forest.speciesOf(tree), tree.leaves));
        const WholeCanopy canopy(forest, gridOver(forest, {2.0, 2.0, 1.0}));
        EXPECT_NEAR(canopy.sum(canopy.leaf), expected, 1e-5 * expected) << season;
        EXPECT_NEAR(canopy.tally.within.leaf, expected, 1e-5 * expected) << season;
        EXPECT_EQ(canopy.tally.trees, forest.trees.size());
        EXPECT_EQ(canopy.tally.beyond.leaf, 0.0);
        EXPECT_EQ(canopy.tally.beyond.drag, 0.0);
    }
}

/// The patches of the law `modal` hold the drag area times half the density of air.
TEST(CanopyRows, HaveTheDragAreaOfTheModalLaw) {
    for (const float season : {midwinter, midsummer}) {
        ForestDescription wood = smallWood();
        wood.season = season;
        const PlacedForest forest(wood);
        double expected = 0.0;
        for (const PlacedTree& tree : forest.trees) {
            const Archetype archetype(
                {&forest.modelOf(tree), &forest.speciesOf(tree), tree.scale, tree.leaves});
            for (const ModalModel::Patch& patch : archetype.model(0).patches)
                expected += static_cast<double>(patch.woodDrag + patch.leafDrag) /
                            (0.5 * static_cast<double>(airDensity));
        }
        const WholeCanopy canopy(forest, gridOver(forest, {1.0, 1.0, 1.0}));
        EXPECT_NEAR(canopy.sum(canopy.drag), expected, 1e-4 * expected) << season;
    }
}

/// Each cell holds the drag of the wood in it.
TEST(CanopyRows, APostHasTheDragOfItsOutlineAtEachHeight) {
    const PlacedForest forest(onePost({0.5, 0.5, 0.0}));
    const WholeCanopy canopy(forest, gridOver(forest, {1.0, 1.0, 0.5}));
    ASSERT_EQ(canopy.grid.cells, glm::ivec3(1, 1, 21)); // the last level for rounding
    const double coefficient = static_cast<double>(post().wood.woodDrag);
    for (int z = 0; z < 20; ++z) {
        const double diameter = 0.4 - 0.2 * (0.25 + 0.5 * z) / 10.0;
        EXPECT_NEAR(canopy.at(canopy.drag, 0, 0, z), coefficient * diameter, 0.02 * coefficient * diameter)
            << z;
        EXPECT_EQ(canopy.at(canopy.leaf, 0, 0, z), 0.0f);
    }
}

/// The leaves lie around the foot of the tree and turn with its heading.
TEST(CanopyRows, TurnWithTheTree) {
    ForestDescription wood = smallWood();
    wood.trees.resize(1);
    const PlacedForest here(wood);
    const WholeCanopy first(here, gridOver(here, {1.0, 1.0, 1.0}));
    const glm::dvec3 foot = wood.trees[0].position;
    EXPECT_LT(glm::length(glm::dvec2(first.middle(first.leaf) - foot)), 1.5);
    wood.trees[0].heading += 3.14159265f;
    const PlacedForest turned(wood);
    const WholeCanopy second(turned, gridOver(turned, {1.0, 1.0, 1.0}));
    const glm::dvec3 arm = first.middle(first.leaf) - foot, back = second.middle(second.leaf) - foot;
    EXPECT_NEAR(back.x, -arm.x, 0.05);
    EXPECT_NEAR(back.y, -arm.y, 0.05);
    EXPECT_NEAR(back.z, arm.z, 0.05);
}

/// A measured tree is as high and as wide as measured, within a leaf card and two cells.
TEST(CanopyRows, ReachTheGivenSizeOfATree) {
    for (std::size_t species = 0; species < 3; ++species) {
        ForestDescription wood = smallWood();
        wood.trees = {treeAt(wood.origin, species, 14.0f)};
        wood.trees[0].size.crownWidth = 7.0f;
        const PlacedForest forest(wood);
        const WholeCanopy canopy(forest, gridOver(forest, glm::dvec3(0.25)));
        glm::ivec3 first = canopy.grid.cells, last(0);
        for (int y = 0; y < canopy.grid.cells.y; ++y)
            for (int z = 0; z < canopy.grid.cells.z; ++z)
                for (int x = 0; x < canopy.grid.cells.x; ++x)
                    if (canopy.at(canopy.drag, x, y, z) > 0.0f) {
                        first = glm::min(first, glm::ivec3(x, y, z));
                        last = glm::max(last, glm::ivec3(x, y, z));
                    }
        const glm::dvec3 extent = canopy.grid.cell * glm::dvec3(last - first + 1);
        EXPECT_EQ(first.z, 0) << wood.species[species].name;
        EXPECT_NEAR(extent.z, 14.0, 0.6) << wood.species[species].name;
        EXPECT_NEAR(0.5 * (extent.x + extent.y), 7.0, 0.8) << wood.species[species].name;
    }
}

TEST(CanopyRows, CountFromTheGroundBelowEachColumn) {
    ForestDescription wood = smallWood();
    wood.trees.resize(1);
    const glm::dvec3 foot = wood.trees[0].position;
    const auto slope = [foot](double x, double) { return foot.z + 0.4 * (x - foot.x); };
    wood.ground = std::make_shared<FunctionGround>(slope);
    const PlacedForest forest(wood);
    const WholeCanopy absolute(forest, gridOver(forest, {0.5, 0.5, 0.25}));
    const WholeCanopy above(forest, gridOver(forest, {0.5, 0.5, 0.25}, true));
    EXPECT_EQ(above.grid.low.z, 0.0);
    EXPECT_NEAR(above.sum(above.leaf), absolute.sum(absolute.leaf), 1e-5 * above.sum(above.leaf));
    const glm::dvec3 middle = absolute.middle(absolute.leaf);
    EXPECT_NEAR(above.middle(above.leaf).z, middle.z - slope(middle.x, middle.y), 0.1);

    wood.ground = std::make_shared<FunctionGround>([](double, double) { return std::nan(""); });
    const PlacedForest onHoles(wood);
    const WholeCanopy fromFoot(onHoles, gridOver(onHoles, {0.5, 0.5, 0.25}, true));
    EXPECT_NEAR(fromFoot.middle(fromFoot.leaf).z, middle.z - foot.z, 0.1);
}

/// Two halves of a map, cut through the crowns, add up to the whole.
TEST(CanopyRows, BoundsCutTrees) {
    const PlacedForest forest(smallWood());
    const WholeCanopy whole(forest, gridOver(forest, {1.0, 1.0, 1.0}));
    const glm::dvec3 low = whole.grid.low, high = whole.grid.high();
    const double cut = forest.description().origin.x + 1.0;
    const auto half = [&](double from, double to) {
        return gridOver(forest, {1.0, 1.0, 1.0}, false, CanopyBounds{{from, low.y}, {to, high.y}});
    };
    const WholeCanopy west(forest, half(low.x, cut)), east(forest, half(cut, high.x));
    const double all = whole.sum(whole.leaf);
    EXPECT_NEAR(west.sum(west.leaf) + east.sum(east.leaf), all, 1e-5 * all);
    EXPECT_GT(west.sum(west.leaf), 0.005 * all);
    EXPECT_NEAR(west.tally.beyond.leaf, east.tally.within.leaf, 1e-5 * all);
    EXPECT_NEAR(west.tally.within.drag + west.tally.beyond.drag, whole.tally.within.drag,
                1e-5 * whole.tally.within.drag);
    EXPECT_LT(west.tally.trees, forest.trees.size());
}

TEST(CanopyRows, StopWhenTold) {
    const PlacedForest forest(smallWood());
    int rows = 0;
    const CanopyTally tally =
        spreadCanopy(forest, gridOver(forest, {1.0, 1.0, 1.0}), [&](const CanopyRow&) { return ++rows < 3; });
    EXPECT_EQ(rows, 3);
    EXPECT_FALSE(tally.finished);
}

/// More trees to the north do not need more rows.
TEST(CanopyRows, NeedTheMemoryOfTheWidestTree) {
    ForestDescription wood = smallWood();
    wood.trees.resize(1);
    const auto bytes = [&] {
        const PlacedForest forest(wood);
        return canopyBytes(forest, gridOver(forest, {1.0, 1.0, 1.0}));
    };
    const std::uint64_t one = bytes();
    TreePlacement more = wood.trees[0];
    for (int i = 0; i < 20; ++i) {
        more.position.y += 10.0;
        wood.trees.push_back(more);
    }
    EXPECT_EQ(bytes(), one);
}

TEST(CanopyRows, LeaveOutTreesThatWereRemoved) {
    ForestDescription wood = smallWood();
    PlacedForest forest(wood);
    forest.remove(0);
    wood.trees.erase(wood.trees.begin());
    const PlacedForest without(wood);
    const WholeCanopy canopy(forest, gridOver(forest, {1.0, 1.0, 1.0})),
        expected(without, gridOver(without, {1.0, 1.0, 1.0}));
    EXPECT_EQ(canopy.leaf, expected.leaf);
    EXPECT_EQ(canopy.drag, expected.drag);
}

} // namespace osgTreeWind

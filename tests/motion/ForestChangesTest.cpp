// SPDX-License-Identifier: MIT
// Trees added, removed and changed while a forest runs.
#include <tests/motion/OneTree.h>
#include <tests/motion/Sapling.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <map>

namespace osgTreeWind {
namespace {

TreePlacement treeAt(double x, float height = 5.0f, std::size_t species = 0, std::string name = {}) {
    TreePlacement tree;
    tree.species = species;
    tree.position = {x, 2.0 * x, 10.0};
    tree.size.height = height;
    tree.seed = static_cast<std::uint32_t>(x);
    tree.name = std::move(name);
    return tree;
}

ForestDescription windySaplings(std::size_t count) {
    ForestDescription forest;
    forest.species = {sapling(), sapling()};
    forest.species[1].name = "stiff";
    forest.species[1].wood.elasticModulus *= 10.0f;
    forest.origin = {448262.0, 4413000.0, 1600.0};
    forest.wind = std::make_shared<UniformWind>(glm::vec3(5, 1, 0));
    for (std::size_t i = 0; i < count; ++i) {
        forest.trees.push_back(treeAt(static_cast<double>(i)));
        forest.trees.back().position += forest.origin;
    }
    return forest;
}

TreePlacement inWorld(const ForestSimulation& simulation, TreePlacement tree) {
    tree.position += simulation.description().origin;
    return tree;
}

TEST(ForestChanges, TreesOfTheDescriptionHaveTheirIndexAsId) {
    const ForestSimulation simulation(windySaplings(4));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(movingForest(simulation).placed().idOf(i), TreeId(i));
        EXPECT_TRUE(simulation.holds(TreeId(i)));
    }
    EXPECT_FALSE(simulation.holds(TreeId(4)));
    EXPECT_FALSE(simulation.holds(TreeId(99)));
}

TEST(ForestChanges, AnAddedTreeSways) {
    ForestSimulation simulation(windySaplings(2));
    run(simulation, 30);
    const TreeId tree = simulation.addTree(inWorld(simulation, treeAt(77.0, 8.0f))).value();
    ASSERT_TRUE(simulation.holds(tree));
    const PlacedTree& placed = movingForest(simulation).trees()[slotOfTree(tree)];
    EXPECT_TRUE(placed.alive);
    EXPECT_EQ(placed.position, glm::vec3(77, 154, 10));
    run(simulation, 60, 1.0);
    EXPECT_GT(glm::length(movingForest(simulation).modal()->lean(slotOfTree(tree))), 0.001f);
    EXPECT_GT(movingForest(simulation).motion(slotOfTree(tree)).poses.size, 0u);
}

TEST(ForestChanges, IdsAreStableAndNeverReused) {
    ForestSimulation simulation(windySaplings(3));
    EXPECT_TRUE(simulation.removeTree(TreeId(1)).empty());
    EXPECT_FALSE(movingForest(simulation).trees()[1].alive);
    EXPECT_FALSE(simulation.removeTree(TreeId(1)).empty());
    EXPECT_EQ(movingForest(simulation).motion(1).poses.size, 0u) << "the slot is empty";
    const TreeId next = simulation.addTree(inWorld(simulation, treeAt(5.0))).value();
    EXPECT_EQ(slotOfTree(next), 1u) << "the slot is reused";
    EXPECT_FALSE(simulation.holds(TreeId(1)));
    EXPECT_FALSE(simulation.changeTree(TreeId(1), treeAt(3.0)).empty());
    EXPECT_TRUE(simulation.holds(next));
    EXPECT_TRUE(simulation.holds(TreeId(2)));
}

TEST(ForestChanges, APlacementIsReturnedAsGiven) {
    ForestSimulation simulation(windySaplings(1));
    TreePlacement given = inWorld(simulation, treeAt(12.25, 7.0f, 1, "T-9"));
    given.heading = 0.4f;
    given.leaves = 0.5f;
    given.size = {7.0f, 0.2f, 3.0f};
    const TreeId tree = simulation.addTree(given).value();
    const TreePlacement back = *simulation.placementOf(tree);
    EXPECT_EQ(back.species, 1u);
    EXPECT_EQ(back.position, given.position);
    EXPECT_EQ(back.heading, 0.4f);
    EXPECT_EQ(back.leaves, 0.5f);
    EXPECT_EQ(back.seed, given.seed);
    EXPECT_EQ(back.name, "T-9");
    EXPECT_NEAR(back.size.height, 7.0f, 0.03f);
    EXPECT_NEAR(back.size.trunkDiameter, 0.2f, 0.001f);
    EXPECT_NEAR(back.size.crownWidth, 3.0f, 0.02f);
}

TEST(ForestChanges, ATreeMovedByItsPlacementKeepsSizeAndSwayToTheBit) {
    ForestSimulation simulation(windySaplings(2));
    run(simulation, 40);
    const TreeScale scale = movingForest(simulation).trees()[1].scale;
    const std::vector<float> amplitudes = movingForest(simulation).modal()->amplitudes(1);
    TreePlacement moved = *simulation.placementOf(TreeId(1));
    moved.position.x += 30.0;
    ASSERT_TRUE(simulation.changeTree(TreeId(1), moved).empty());
    EXPECT_EQ(movingForest(simulation).trees()[1].scale.axes, scale.axes);
    EXPECT_EQ(movingForest(simulation).trees()[1].scale.radius, scale.radius);
    EXPECT_EQ(movingForest(simulation).trees()[1].position.x, 31.0f);
    EXPECT_EQ(movingForest(simulation).modal()->amplitudes(1), amplitudes);
    EXPECT_TRUE(simulation.holds(TreeId(1))) << "under the same id";
}

TEST(ForestChanges, ATreeBecomesAnotherSpeciesAndSize) {
    ForestDescription expected = windySaplings(2);
    expected.wind = std::make_shared<UniformWind>(glm::vec3(1.5f, 0.3f, 0));
    ForestSimulation simulation(expected);
    run(simulation, 20);
    ASSERT_TRUE(simulation.changeTree(TreeId(0), inWorld(simulation, treeAt(0.0, 9.0f, 1))).empty());
    EXPECT_EQ(movingForest(simulation).trees()[0].species, 1u);
    EXPECT_NEAR(simulation.placementOf(TreeId(0))->size.height, 9.0f, 0.05f);
    run(simulation, 6000, 1.0);
    expected.trees[0].species = 1;
    expected.trees[0].size.height = 9.0f;
    ForestSimulation fresh(expected);
    run(fresh, 6020);
    EXPECT_NEAR(movingForest(simulation).modal()->lean(0).x, movingForest(fresh).modal()->lean(0).x,
                0.02f * movingForest(fresh).modal()->lean(0).x);
}

TEST(ForestChanges, InvalidChangesAreRefused) {
    ForestDescription ofBranches = windySaplings(1);
    ofBranches.law = MotionLaw::ThesisSmooth;
    ForestSimulation branchwise(ofBranches), modal(windySaplings(1));
    const std::string fixed = "law: only the law modal lets trees and species be added, removed or changed";
    EXPECT_EQ(branchwise.addTree(treeAt(1.0)).problems().front().text(), fixed);
    EXPECT_EQ(branchwise.removeTree(TreeId(0)).front().text(), fixed);
    EXPECT_EQ(branchwise.changeTree(TreeId(0), treeAt(1.0)).front().text(), fixed);
    EXPECT_TRUE(branchwise.holds(TreeId(0)));
    const std::string unknown = "species: there is no species 7; the forest has 2, from 0 on";
    EXPECT_EQ(modal.addTree(treeAt(1.0, 5.0f, 7)).problems().front().text(), unknown);
    EXPECT_EQ(modal.changeTree(TreeId(0), treeAt(1.0, 5.0f, 7)).front().text(), unknown);
    EXPECT_EQ(modal.removeTree(TreeId(1)).front().text(),
              "tree: no tree has this id; it may have been removed");
    EXPECT_EQ(movingForest(modal).trees().size(), 1u);
}

TEST(ForestChanges, TreesAreFoundByName) {
    ForestDescription forest = windySaplings(4);
    forest.trees[1].name = "oak 7";
    forest.trees[2].name = "oak 8";
    forest.trees[3].name = "oak 7"; // a duplicate
    ForestSimulation simulation(forest);
    EXPECT_EQ(simulation.findTree("oak 7"), TreeId(1));
    EXPECT_EQ(simulation.nameOf(TreeId(2)), "oak 8");
    EXPECT_EQ(simulation.nameOf(TreeId(3)), "");
    EXPECT_EQ(simulation.nameOf(TreeId(0)), "");
    EXPECT_FALSE(simulation.findTree("oak 9"));
    EXPECT_FALSE(simulation.findTree(""));

    EXPECT_TRUE(simulation.removeTree(TreeId(1)).empty());
    EXPECT_FALSE(simulation.findTree("oak 7"));
    const TreeId other = simulation.addTree(inWorld(simulation, treeAt(1.0, 5.0f, 0, "oak 7"))).value();
    EXPECT_EQ(simulation.findTree("oak 7"), other);
    TreePlacement renamed = *simulation.placementOf(TreeId(2));
    renamed.name = "elm";
    EXPECT_TRUE(simulation.changeTree(TreeId(2), renamed).empty());
    EXPECT_EQ(simulation.findTree("elm"), TreeId(2));
    EXPECT_FALSE(simulation.findTree("oak 8"));
    const std::shared_ptr<ForestSimulation> copy = simulation.cloneAtRest();
    EXPECT_TRUE(simulation.removeTree(other).empty());
    EXPECT_EQ(copy->findTree("oak 7"), other);
    EXPECT_EQ(copy->nameOf(TreeId(2)), "elm");
}

TEST(ForestChanges, CloneAtRestHasThePresentTreesAndSharesTheShapes) {
    ForestSimulation simulation(windySaplings(3));
    EXPECT_TRUE(simulation.removeTree(TreeId(0)).empty());
    const TreeId added = simulation.addTree(inWorld(simulation, treeAt(9.0, 6.0f))).value();
    run(simulation, 50);
    std::shared_ptr<ForestSimulation> again = simulation.cloneAtRest();
    EXPECT_EQ(movingForest(*again).models(), movingForest(simulation).models());
    EXPECT_EQ(&movingForest(*again).modal()->archetype(1), &movingForest(simulation).modal()->archetype(1));
    EXPECT_TRUE(again->holds(added));
    EXPECT_FALSE(again->holds(TreeId(0)));
    EXPECT_EQ(movingForest(*again).modal()->lean(1), glm::vec2(0.0f));
    EXPECT_TRUE(simulation.removeTree(TreeId(1)).empty());
    EXPECT_TRUE(again->holds(TreeId(1))) << "the simulations are independent";
    EXPECT_TRUE(again->addTree(inWorld(*again, treeAt(2.0))));
    EXPECT_EQ(movingForest(*again).modal()->archetypeCount(),
              movingForest(simulation).modal()->archetypeCount());
    run(*again, 50);
    EXPECT_EQ(movingForest(*again).modal()->lean(2), movingForest(simulation).modal()->lean(2))
        << "in the same wind";
}

TEST(ForestChanges, CloneAtRestWorksUnderBranchwiseLaws) {
    ForestDescription forest = windySaplings(2);
    forest.law = MotionLaw::ThesisSmooth;
    ForestSimulation simulation(forest);
    run(simulation, 20);
    const std::shared_ptr<ForestSimulation> again = simulation.cloneAtRest();
    EXPECT_EQ(movingForest(*again).motion(1).states[3], glm::vec4(0.0f));
    run(*again, 20);
    EXPECT_EQ(movingForest(*again).motion(1).states[3], movingForest(simulation).motion(1).states[3]);
    EXPECT_EQ(movingForest(*again).motion(1).leaves[0], movingForest(simulation).motion(1).leaves[0]);
}

TEST(ForestChanges, CloneAtRestSharesShapesAndArchetypes) {
    ForestDescription forest = windySaplings(20);
    forest.law = MotionLaw::Modal;
    const ForestSimulation simulation(std::move(forest));
    const std::shared_ptr<const ForestSimulation> again = simulation.cloneAtRest();
    for (std::size_t tree = 0; tree < 20; ++tree)
        EXPECT_EQ(&movingForest(*again).modal()->archetype(tree),
                  &movingForest(simulation).modal()->archetype(tree));
    EXPECT_EQ(movingForest(*again).models(), movingForest(simulation).models());
}

TEST(ForestChanges, DescribeReturnsThePresentForest) {
    ForestDescription given = windySaplings(4);
    given.law = MotionLaw::Modal;
    given.gain = 2.0f;
    given.noiseExponent = 1.5f;
    given.drawing.full = 250.0f;
    given.drawing.reduced = 100.0f;
    given.trees[2].name = "oak 2";
    given.trees[3].name = "oak 3";
    ForestSimulation simulation(given);
    EXPECT_TRUE(simulation.removeTree(TreeId(0)).empty());
    EXPECT_TRUE(simulation.removeTree(TreeId(1)).empty());
    ASSERT_TRUE(simulation.addTree(inWorld(simulation, treeAt(77.5, 8.0f, 1, "late")))); // reuses a slot
    TreePlacement moved = *simulation.placementOf(TreeId(3));
    moved.position.x += 5.0;
    EXPECT_TRUE(simulation.changeTree(TreeId(3), moved).empty());
    EXPECT_TRUE(simulation.setSeason(midwinter).empty());
    const auto storm = std::make_shared<UniformWind>(glm::vec3(20, 0, 0));
    EXPECT_TRUE(simulation.setWind(storm).empty());

    const ForestDescription now = simulation.currentDescription();
    EXPECT_EQ(now.wind.field, storm);
    EXPECT_EQ(now.season, midwinter);
    EXPECT_EQ(now.origin, given.origin);
    EXPECT_EQ(now.gain, 2.0f);
    EXPECT_EQ(now.noiseExponent, 1.5f);
    EXPECT_EQ(now.drawing.full, 250.0f);
    ASSERT_EQ(now.species.size(), 2u);
    EXPECT_EQ(now.species[1].name, "stiff");
    ASSERT_EQ(now.trees.size(), 3u);
    EXPECT_EQ(now.trees[0].name, "late");
    EXPECT_EQ(now.trees[0].species, 1u);
    EXPECT_EQ(now.trees[1].name, "oak 2");
    EXPECT_EQ(now.trees[2].name, "oak 3");
    EXPECT_EQ(now.trees[2].position.x, given.origin.x + 8.0);

    const ForestDescription again = ForestSimulation(now).currentDescription();
    ASSERT_EQ(again.trees.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(again.trees[i].name, now.trees[i].name);
        EXPECT_EQ(again.trees[i].position, now.trees[i].position);
        EXPECT_EQ(again.trees[i].heading, now.trees[i].heading);
        EXPECT_EQ(again.trees[i].leaves, now.trees[i].leaves);
        EXPECT_EQ(again.trees[i].seed, now.trees[i].seed);
        EXPECT_EQ(again.trees[i].size.height, now.trees[i].size.height);
        EXPECT_EQ(again.trees[i].size.trunkDiameter, now.trees[i].size.trunkDiameter);
        EXPECT_EQ(again.trees[i].size.crownWidth, now.trees[i].size.crownWidth);
    }
}

TEST(ForestChanges, ManyChangesKeepEveryTreesState) {
    ForestSimulation simulation(windySaplings(10));
    Random random(2);
    std::map<TreeId, glm::vec3> there;
    for (std::size_t i = 0; i < 10; ++i)
        there[movingForest(simulation).placed().idOf(i)] = movingForest(simulation).trees()[i].position;
    for (int i = 0; i < 2000; ++i) {
        const double x = 100.0 * static_cast<double>(random.uniform());
        const TreePlacement tree =
            inWorld(simulation, treeAt(x, 3.0f + 5.0f * random.uniform(), random.next() % 2));
        const auto any = std::next(there.begin(), static_cast<std::ptrdiff_t>(random.next() % there.size()));
        if (random.next() % 2 && there.size() > 2) {
            ASSERT_TRUE(simulation.removeTree(any->first).empty());
            ASSERT_FALSE(simulation.holds(any->first));
            there.erase(any);
        } else {
            const TreeId id = simulation.addTree(tree).value();
            ASSERT_EQ(there.count(id), 0u) << "ids are unique";
            there[id] = movingForest(simulation).trees()[slotOfTree(id)].position;
        }
        simulation.advance(i / 60.0);
    }
    std::size_t alive = 0;
    for (const PlacedTree& tree : movingForest(simulation).trees())
        alive += tree.alive;
    EXPECT_EQ(alive, there.size());
    for (const auto& [id, position] : there) {
        ASSERT_TRUE(simulation.holds(id));
        EXPECT_EQ(movingForest(simulation).trees()[slotOfTree(id)].position, position);
    }
}

} // namespace

TEST(ForestChanges, ASpeciesCanBeAddedToARunningForest) {
    ForestSimulation simulation(windySaplings(2));
    run(simulation, 10);
    const auto before = simulation.cloneAtRest();
    Species larch = sapling();
    larch.name = "larch";
    larch.wood.elasticModulus *= 4.0f;
    const Result<std::size_t> index = simulation.addSpecies(larch);
    ASSERT_TRUE(index) << toString(index.problems());
    EXPECT_EQ(index.value(), simulation.description().species.size() - 1);
    EXPECT_EQ(simulation.description().species.back().name, "larch");
    EXPECT_EQ(before->description().species.size(), index.value()) << "copies do not change";
    TreePlacement place = *simulation.placementOf(TreeId(0));
    place.species = index.value();
    EXPECT_TRUE(simulation.changeTree(TreeId(0), place).empty());
    place.position.x += 5.0;
    const Result<TreeId> added = simulation.addTree(place);
    ASSERT_TRUE(added) << toString(added.problems());
    run(simulation, 50, 1.0);
    EXPECT_NE(tip(simulation, 1),
              movingForest(simulation).models()[*simulation.modelOf(TreeId(0))]->skeleton.units[1].tip);

    const ForestDescription now = simulation.currentDescription();
    EXPECT_EQ(now.species[now.trees.back().species].name, "larch");
    ForestSimulation first(now); // as if the species had been there from the start
    run(first, 20);
    const auto again = simulation.cloneAtRest();
    run(*again, 20);
    const Span<UnitPose> one = movingForest(first).motion(0).poses,
                         other = movingForest(*again).motion(0).poses;
    ASSERT_EQ(one.size, other.size);
    for (std::size_t i = 0; i < one.size; ++i)
        EXPECT_EQ(one[i].translation, other[i].translation) << i;
}

TEST(ForestChanges, ASpeciesIsRefusedWithTheReason) {
    ForestSimulation simulation(windySaplings(1));
    const std::string name = simulation.description().species[0].name;
    Species other = sapling();
    other.name = name;
    EXPECT_EQ(toString(simulation.addSpecies(other).problems()),
              "name: the name \"" + name + "\" is taken already");
    other.name = "larch";
    other.tree.wood.levels = -1;
    EXPECT_EQ(toString(simulation.addSpecies(other).problems()),
              "tree.levels: expected a whole number in [0, 8], found -1");
    EXPECT_EQ(simulation.description().species.size(),
              ForestSimulation(windySaplings(1)).description().species.size());
    ForestSimulation branchwise(oneTree(MotionLaw::ThesisSmooth));
    EXPECT_EQ(toString(branchwise.addSpecies(sapling()).problems()),
              "law: only the law modal lets trees and species be added, removed or changed");
}

} // namespace osgTreeWind

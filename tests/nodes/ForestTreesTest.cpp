// SPDX-License-Identifier: MIT
// Adding, removing and changing trees, and transforms of branches, while a forest runs.
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/TreeUnit.h>

#include <osg/ComputeBoundsVisitor>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <set>
#include <sstream>

using namespace osgTreeWind;

namespace {

TreePlacement treeAt(double x, double y = 0.0, float height = 6.0f) {
    TreePlacement tree;
    tree.position = {x, y, 0.0};
    tree.size.height = height;
    return tree;
}

} // namespace

TEST(ForestTreesTest, IdsAreNeverUsedAgain) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4));
    std::set<TreeId> ids;
    for (int i = 0; i < 100; ++i) {
        const TreeId tree = forest->addTree(treeAt(10.0 + i)).value();
        EXPECT_TRUE(ids.insert(tree).second) << "an id came back";
        EXPECT_EQ(forest->getNumTrees(), 5u);
        EXPECT_TRUE(forest->removeTree(tree).empty());
        EXPECT_FALSE(forest->removeTree(tree).empty());
        EXPECT_FALSE(forest->changeTree(tree, treeAt(0.0)).empty());
        EXPECT_EQ(forest->getNumTrees(), 4u);
    }
    for (std::size_t tree = 0; tree < 4; ++tree)
        EXPECT_TRUE(forest->getSimulation().holds(TreeId(tree)));
    EXPECT_LE(movingForest(forest->getSimulation()).trees().size(), 5u) << "slots are used again";
}

TEST(ForestTreesTest, ATreeOfAnUnknownSpeciesIsRejected) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(1));
    TreePlacement stranger = treeAt(1.0);
    stranger.species = 9;
    const Result<TreeId> added = forest->addTree(stranger);
    ASSERT_FALSE(added);
    EXPECT_EQ(added.problems().front().text(), "species: there is no species 9; the forest has 1, from 0 on");
    EXPECT_FALSE(forest->changeTree(TreeId(0), stranger).empty());
    EXPECT_FALSE(forest->removeTree(TreeId(99)).empty());
    EXPECT_EQ(forest->getNumTrees(), 1u);
}

TEST(ForestTreesTest, FindsATreeByName) {
    ForestDescription description = smallForest(3);
    description.trees[1].name = "old oak";
    osg::ref_ptr<Forest> forest = new Forest(description);
    EXPECT_EQ(forest->findTree("old oak"), TreeId(1));
    EXPECT_FALSE(forest->findTree("nobody"));
    TreePlacement named = treeAt(30.0);
    named.name = "sapling";
    const TreeId added = forest->addTree(named).value();
    EXPECT_EQ(forest->findTree("sapling"), added);
    EXPECT_TRUE(forest->removeTree(added).empty());
    EXPECT_FALSE(forest->findTree("sapling"));
}

TEST(ForestTreesTest, BoundsFollowTheTrees) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    const osg::BoundingSphere before = forest->getBound();
    const TreeId distant = forest->addTree(treeAt(3000.0)).value();
    EXPECT_GT(forest->getBound().radius(), 1400.0f);
    EXPECT_TRUE(forest->changeTree(distant, treeAt(6000.0)).empty());
    EXPECT_GT(forest->getBound().radius(), 2900.0f);
    EXPECT_TRUE(forest->removeTree(distant).empty());
    EXPECT_NEAR(forest->getBound().radius(), before.radius(), 1e-3f);
    EXPECT_TRUE(forest->removeTree(TreeId(0)).empty());
    EXPECT_TRUE(forest->removeTree(TreeId(1)).empty());
    EXPECT_FALSE(forest->getBound().valid());
}

TEST(ForestTreesTest, ATreeThatChangesInEveryFrameHasOneTransform) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4));
    for (unsigned frame = 1; frame <= 200; ++frame) {
        ASSERT_TRUE(forest->changeTree(TreeId(1), treeAt(0.1 * frame)).empty());
        const TreeId other = forest->addTree(treeAt(5.0)).value();
        update(*forest, frame, frame / 25.0);
        EXPECT_TRUE(forest->removeTree(other).empty());
    }
    EXPECT_LE(instancedTrees(*forest->getInstanced()).nearTreeCount(), 5u);
}

TEST(ForestTreesTest, AMovedTreeKeepsSwaying) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    updateFrames(*forest, 1, 40);
    const glm::vec2 lean = movingForest(forest->getSimulation()).modal()->lean(1);
    ASSERT_GT(glm::length(lean), 0.01f);
    TreePlacement there = *forest->getSimulation().placementOf(TreeId(1));
    there.position.x += 100.0;
    EXPECT_TRUE(forest->changeTree(TreeId(1), there).empty());
    EXPECT_LT(glm::distance(movingForest(forest->getSimulation()).modal()->lean(1), lean), 1e-5f);
}

TEST(ForestTreesTest, ChangesDoNotAffectOtherTrees) {
    osg::ref_ptr<Forest> one = new Forest(smallForest(4)), other = new Forest(smallForest(4));
    updateFrames(*one, 1, 20);
    updateFrames(*other, 1, 20);
    const TreeId added = other->addTree(treeAt(90.0)).value();
    updateFrames(*one, 21, 40);
    updateFrames(*other, 21, 40);
    EXPECT_TRUE(other->removeTree(added).empty());
    updateFrames(*one, 41, 60);
    updateFrames(*other, 41, 60);
    for (std::size_t tree = 0; tree < 4; ++tree)
        EXPECT_EQ(movingForest(one->getSimulation()).modal()->lean(tree),
                  movingForest(other->getSimulation()).modal()->lean(tree))
            << tree;
}

TEST(ForestTreesTest, BranchTransformsUseTheFrameOfTheTree) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3, 20.0f));
    const osg::ref_ptr<BranchTransform> branch = forest->branch(TreeId(2), 11).value();
    ASSERT_TRUE(branch);
    EXPECT_EQ(forest->branch(TreeId(2), 11).value(), branch);
    EXPECT_EQ(toString(forest->branch(TreeId(2), 1000).problems()),
              "unit: there is no unit 1000; the tree has 14, from 0 on");
    EXPECT_EQ(toString(forest->branch(TreeId(77), 0).problems()),
              "tree: no tree has this id; it may have been removed");
    const PlacedTree& placed = movingForest(forest->getSimulation()).trees()[2];
    const BranchUnit& rest =
        movingForest(forest->getSimulation()).placed().modelOf(placed).skeleton.units[11];
    const osg::Matrix before = branch->getMatrix();
    for (unsigned frame = 1; frame <= 30; ++frame) {
        update(*forest, frame, frame / 25.0);
        const glm::vec3 tip = placed.scale.axes * rest.tip;
        const UnitPose pose = movingForest(forest->getSimulation()).motion(2).poses[11];
        const glm::vec3 expected =
            rotateAboutZ(pose.apply(tip), std::sin(placed.heading), std::cos(placed.heading)) +
            placed.position;
        EXPECT_LT((osg::Vec3(toOsg(tip) * branch->getMatrix()) - toOsg(expected)).length(), 1e-4f);
    }
    EXPECT_NE(branch->getMatrix(), before);
}

TEST(ForestTreesTest, ABranchTransformAgreesWithThePosedTree) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3, 20.0f));
    std::vector<osg::ref_ptr<BranchTransform>> branches;
    for (unsigned unit = 0; unit < forest->getUnits(TreeId(2)).size(); ++unit)
        branches.emplace_back(forest->branch(TreeId(2), unit).value());
    ASSERT_GT(branches.size(), 10u);
    updateFrames(*forest, 1, 30);
    const PlacedTree& placed = movingForest(forest->getSimulation()).trees()[2];
    const osg::Matrix toForest = osg::Matrix::rotate(static_cast<double>(placed.heading), osg::Z_AXIS) *
                                 osg::Matrix::translate(toOsg(placed.position));
    UnitValues values;
    const TreeMotion whole = movingForest(forest->getSimulation()).motion(2, values);
    for (std::size_t unit = 0; unit < branches.size(); ++unit) {
        EXPECT_EQ(branches[unit]->getMatrix(),
                  osg::Matrix::rotate(toOsg(whole.poses[unit].rotation)) *
                      osg::Matrix::translate(toOsg(whole.poses[unit].translation)) * toForest)
            << unit;
        EXPECT_EQ(branches[unit]->getRotation(), toOsg(whole.rotations[unit])) << "the unit's own rotation";
    }
    EXPECT_GT(std::abs(branches.back()->getRotation().w() - 1.0), 1e-7);
}

TEST(ForestTreesTest, ReleasingABranchRemovesItsChildren) {
    ForestDescription description = smallForest(1, 20.0f);
    description.trees.resize(600, description.trees[0]); // too many to follow closely from the start
    osg::ref_ptr<Forest> forest = new Forest(description);
    const osg::ref_ptr<BranchTransform> first = forest->branch(TreeId(5), 3).value(),
                                        last = forest->branch(TreeId(5), 9).value();
    EXPECT_TRUE(forest->releaseBranch(TreeId(5), 3));
    EXPECT_EQ(first->getNumParents(), 0u);
    EXPECT_EQ(last->getNumParents(), 1u);
    EXPECT_FALSE(forest->releaseBranch(TreeId(5), 3)) << "already released";
    EXPECT_FALSE(forest->releaseBranch(TreeId(5), 4)) << "never requested";
    EXPECT_NE(forest->branch(TreeId(5), 3).value(), first);
    ASSERT_TRUE(forest->removeTree(TreeId(5)).empty());
    EXPECT_TRUE(forest->releaseBranch(TreeId(5), 3)) << "also after the tree is removed";
    EXPECT_TRUE(forest->releaseBranch(TreeId(5), 9));
    EXPECT_EQ(last->getNumParents(), 0u);
}

TEST(ForestTreesTest, UnitsAreWhereTheTreeIs) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3, 20.0f));
    const std::vector<TreeUnit> rest = forest->getUnits(TreeId(1));
    updateFrames(*forest, 1, 30);
    const std::vector<TreeUnit> units = forest->getUnits(TreeId(1));
    const PlacedTree& placed = movingForest(forest->getSimulation()).trees()[1];
    ASSERT_EQ(units.size(), movingForest(forest->getSimulation()).placed().unitCount(placed));
    EXPECT_LT((units[0].base - toOsg(placed.position)).length(), 1e-5f) << "the foot of the trunk";
    EXPECT_EQ(units[0].parent, -1);
    float moved = 0.0f, highest = 0.0f;
    for (std::size_t i = 0; i < units.size(); ++i) {
        const TreeUnit& unit = units[i];
        EXPECT_NEAR((unit.tip - unit.base).length(), (unit.restTip - unit.restBase).length(), 1e-4f)
            << "rigid";
        if (unit.parent >= 0) {
            EXPECT_GE(unit.level, units[static_cast<std::size_t>(unit.parent)].level);
        }
        EXPECT_GE(unit.baseRadius, unit.tipRadius);
        EXPECT_EQ(nearestUnit(units, (unit.base + unit.tip) * 0.5f), i);
        const osg::ref_ptr<BranchTransform> branch =
            forest->branch(TreeId(1), static_cast<unsigned>(i)).value();
        EXPECT_LT((osg::Vec3(unit.restTip * branch->getMatrix()) - unit.tip).length(), 1e-4f);
        EXPECT_EQ(branch->getBase(), unit.restBase);
        moved = std::max(moved, (unit.tip - rest[i].tip).length());
        highest = std::max(highest, rest[i].tip.z());
    }
    EXPECT_GT(moved, 0.01f) << "the test needs a tree that moves";
    EXPECT_NEAR(highest, 5.5f, 1.0f) << "as high as the tree";
    EXPECT_TRUE(forest->getUnits(TreeId(7)).empty());
    EXPECT_FALSE(nearestUnit({}, osg::Vec3()).has_value());
}

TEST(ForestTreesTest, ListsTreesAndTheirPlacements) {
    ForestDescription description = smallForest(3);
    description.origin = {4.3e5, 4.5e6, 10.0};
    for (TreePlacement& tree : description.trees)
        tree.position += description.origin;
    description.trees[2].name = "old oak";
    osg::ref_ptr<Forest> forest = new Forest(description);
    ASSERT_TRUE(forest->removeTree(TreeId(1)).empty());
    const std::vector<TreeId> trees = forest->getTrees();
    EXPECT_EQ(trees, (std::vector<TreeId>{TreeId(0), TreeId(2)}));
    const std::optional<TreePlacement> oak = forest->getPlacement(trees[1]);
    ASSERT_TRUE(oak);
    EXPECT_EQ(oak->name, "old oak");
    EXPECT_EQ(oak->position, description.trees[2].position) << "world coordinates";
    EXPECT_NEAR(oak->size.height, 6.0f, 0.06f);
    EXPECT_FALSE(forest->getPlacement(TreeId(1)));
}

TEST(ForestTreesTest, BoxesEncloseTreesAtRestAndTheSphereTheirSway) {
    ForestDescription description = oneTree(smallSpecies());
    description.trees[0].position = {10.0, 20.0, 3.0};
    description.trees[0].size = {12.0f, 0.3f, 7.0f};
    osg::ref_ptr<Forest> forest = new Forest(description);
    osg::ComputeBoundsVisitor bounds;
    forest->accept(bounds);
    const osg::BoundingBox box = bounds.getBoundingBox();
    EXPECT_FLOAT_EQ(box.zMin(), 3.0f);
    EXPECT_NEAR(box.zMax(), 15.0f, 0.12f);
    EXPECT_NEAR(0.5f * (box.xMax() - box.xMin() + box.yMax() - box.yMin()), 7.0f, 0.1f);
    EXPECT_TRUE(box.contains(osg::Vec3(10.0f, 20.0f, 3.0f)));
    const osg::BoundingSphere sphere = forest->getBound();
    EXPECT_GT(sphere.radius(), box.radius() + 2.0f);
    EXPECT_TRUE(sphere.contains(osg::Vec3(10.0f + 3.5f + 0.35f * 12.0f, 20.0f, 14.0f))) << "as it sways";
}

TEST(ForestTreesTest, ANewBranchTransformHasTheCurrentPose) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2, 20.0f));
    updateFrames(*forest, 1, 30);
    const osg::ref_ptr<BranchTransform> late = forest->branch(TreeId(1), 9).value();
    const osg::Matrix now = late->getMatrix();
    update(*forest, 31, 30 / 25.0); // a pause
    EXPECT_EQ(late->getMatrix(), now);
}

TEST(ForestTreesTest, ABranchTransformKeepsItsPositionWhenItsTreeIsRemoved) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2, 20.0f));
    const osg::ref_ptr<BranchTransform> branch = forest->branch(TreeId(1), 9).value();
    updateFrames(*forest, 1, 30);
    const osg::Matrix last = branch->getMatrix();
    EXPECT_TRUE(forest->removeTree(TreeId(1)).empty());
    const TreeId next = forest->addTree(treeAt(40.0)).value();
    EXPECT_EQ(slotOfTree(next), 1u);
    updateFrames(*forest, 31, 60);
    EXPECT_EQ(branch->getMatrix(), last);
    EXPECT_NE(forest->branch(next, 9).value(), branch);
}

TEST(ForestTreesTest, ABranchTransformFollowsAChangedTree) {
    ForestDescription description = smallForest(2, 20.0f);
    description.species.push_back(smallSpecies());
    description.species[1].tree.wood.levels = 1; // fewer branches
    osg::ref_ptr<Forest> forest = new Forest(description);
    const osg::ref_ptr<BranchTransform> first = forest->branch(TreeId(0), 1).value(),
                                        last = forest->branch(TreeId(0), 13).value();
    updateFrames(*forest, 1, 10);
    TreePlacement other = treeAt(5.0);
    other.species = 1;
    const osg::Matrix held = last->getMatrix(), before = first->getMatrix();
    ASSERT_TRUE(forest->changeTree(TreeId(0), other).empty());
    const std::vector<TreeUnit> units = forest->getUnits(TreeId(0));
    EXPECT_EQ(first->getBase(), units[1].restBase);
    EXPECT_LT((osg::Vec3(units[1].restTip * first->getMatrix()) - units[1].tip).length(), 1e-4f) << "at once";
    updateFrames(*forest, 11, 20);
    EXPECT_EQ(last->getMatrix(), held);
    EXPECT_NE(first->getMatrix(), before);
}

TEST(ForestTreesTest, AnAddedSpeciesIsInTreesFilesAndCopies) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    Species larch = smallSpecies();
    larch.name = "larch";
    larch.tree.wood.levels = 1;
    const Result<std::size_t> index = forest->addSpecies(larch);
    ASSERT_TRUE(index) << toString(index.problems());
    EXPECT_EQ(index.value(), 1u);
    EXPECT_FALSE(forest->addSpecies(larch)) << "its name is taken";
    EXPECT_EQ(forest->getDescription().species.back().name, "larch");
    TreePlacement place = treeAt(20.0);
    place.species = index.value();
    const Result<TreeId> tree = forest->addTree(place);
    ASSERT_TRUE(tree) << toString(tree.problems());
    EXPECT_TRUE(forest->branch(tree.value(), 4)) << "trunk of 2, 3 branches";
    EXPECT_TRUE(forest->getInstanced()->setLeafState(index.value(), new osg::StateSet));
    updateFrames(*forest, 1, 10);
    osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    EXPECT_EQ(copy->getDescription().species.size(), 2u);
    forest = nullptr; // the copy keeps what it needs
    updateFrames(*copy, 1, 10);
    EXPECT_EQ(copy->getUnits(copy->getTrees().back()).size(), 5u);
    std::ostringstream file;
    EXPECT_TRUE(writeForest(copy->getSimulation().currentDescription(), file).empty());
    EXPECT_NE(file.str().find("name = \"larch\""), std::string::npos);
}

TEST(ForestTreesTest, AHiddenTreeWithABranchTransformStepsInEveryFrame) {
    ForestDescription description = smallForest(1, 20.0f);
    description.trees.resize(600, description.trees[0]); // too many to follow closely from the start
    osg::ref_ptr<Forest> forest = new Forest(description);
    ASSERT_EQ(instancedTrees(*forest->getInstanced()).nearTreeCount(), 0u);
    EXPECT_TRUE(forest->branch(TreeId(5), 0));
    EXPECT_EQ(instancedTrees(*forest->getInstanced()).nearTreeCount(), 1u);
    updateFrames(*forest, 1, 200);
    EXPECT_EQ(movingForest(forest->getSimulation()).modal()->level(5), ModalMotion::Level::Near);
    EXPECT_EQ(movingForest(forest->getSimulation()).modal()->level(6), ModalMotion::Level::Far);
}

TEST(ForestTreesTest, ThousandsOfChangesUseNoMoreMemory) {
    ForestDescription description = smallForest(1);
    description.trees.resize(3000, description.trees[0]);
    for (std::size_t i = 0; i < description.trees.size(); ++i)
        description.trees[i].position = {20.0 * static_cast<double>(i % 60),
                                         20.0 * static_cast<double>(i / 60), 0.0};
    osg::ref_ptr<Forest> forest = new Forest(description);
    std::size_t archetypes = 0;
    for (int i = 0; i < 2000; ++i) {
        const TreeId tree = forest->addTree(treeAt(i % 300, 5.0, description.trees[0].size.height)).value();
        EXPECT_TRUE(forest->changeTree(tree, treeAt(i % 200, 5.0, description.trees[0].size.height)).empty());
        EXPECT_TRUE(forest->removeTree(tree).empty());
        if (i == 0)
            archetypes = movingForest(forest->getSimulation()).modal()->archetypeCount();
    }
    EXPECT_LE(movingForest(forest->getSimulation()).trees().size(), 3001u);
    EXPECT_EQ(movingForest(forest->getSimulation()).modal()->archetypeCount(), archetypes) << "flat memory";
}

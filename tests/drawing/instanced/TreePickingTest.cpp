// SPDX-License-Identifier: MIT
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/drawing/instanced/TreeHit.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/laws/PosedPoints.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>

#include <osg/MatrixTransform>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/PolytopeIntersector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace osgTreeWind;
using osgUtil::LineSegmentIntersector;

namespace {

/// Trees in a strong wind after 60 frames.
osg::ref_ptr<Forest> blownForest(int trees) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(trees, 20.0f));
    updateFrames(*forest, 1, 60);
    return forest;
}

LineSegmentIntersector::Intersections hits(osg::Node& scene, const osg::Vec3d& from, const osg::Vec3d& to) {
    osg::ref_ptr<LineSegmentIntersector> line = new LineSegmentIntersector(from, to);
    osgUtil::IntersectionVisitor visitor(line);
    scene.accept(visitor);
    return line->getIntersections();
}

/// A point of a tree in the forest's frame.
osg::Vec3d standing(const PlacedTree& tree, const glm::vec3& point) {
    return osg::Vec3d(
        toOsg(rotateAboutZ(point, std::sin(tree.heading), std::cos(tree.heading)) + tree.position));
}

/// Counts the trees that are posed, each of which becomes a TreeHit.
class PosedTreeCounter : public osgUtil::IntersectionVisitor {
public:
    using osgUtil::IntersectionVisitor::apply, osgUtil::IntersectionVisitor::IntersectionVisitor;
    void apply(osg::Drawable& drawable) override {
        posed += dynamic_cast<TreeHit*>(&drawable) != nullptr;
        osgUtil::IntersectionVisitor::apply(drawable);
    }
    int posed = 0;
};

/// The middle of a unit in its current pose or at rest.
osg::Vec3d middleOf(const Forest& forest, std::size_t tree, std::size_t unit, bool moved = true) {
    const PlacedTree& placed = movingForest(forest.getSimulation()).trees()[tree];
    const BranchUnit& rest =
        movingForest(forest.getSimulation()).placed().modelOf(placed).skeleton.units[unit];
    const UnitPose pose = moved ? movingForest(forest.getSimulation()).motion(tree).poses[unit] : UnitPose();
    return standing(placed, pose.apply(placed.scale.axes * (0.5f * (rest.base + rest.tip))));
}

const TreeHit* pickedTree(const LineSegmentIntersector::Intersection& hit) {
    return dynamic_cast<const TreeHit*>(hit.drawable.get());
}

/// Whether a short line through a place hits the bark of a unit.
bool hitsBark(osg::Node& scene, const osg::Vec3d& place, TreeId tree, unsigned unit) {
    for (const auto& hit :
         hits(scene, place - osg::Vec3d(0.0, 0.4, 0.0), place + osg::Vec3d(0.0, 0.4, 0.0))) {
        const TreeHit* picked = pickedTree(hit);
        if (picked && !picked->isLeaf(hit.primitiveIndex) && picked->getTree() == tree &&
            picked->getUnit(hit.primitiveIndex) == unit)
            return true;
    }
    return false;
}

} // namespace

TEST(TreePickingTest, HitsEveryBranchAtItsCurrentPlace) {
    osg::ref_ptr<Forest> forest = blownForest(3);
    for (std::size_t tree = 0; tree < 3; ++tree)
        for (unsigned unit = 0; unit < 14; ++unit)
            EXPECT_TRUE(hitsBark(*forest, middleOf(*forest, tree, unit), TreeId(tree), unit))
                << tree << ", " << unit;
}

TEST(TreePickingTest, DoesNotHitABranchAtItsFormerPlace) {
    osg::ref_ptr<Forest> forest = blownForest(1);
    unsigned moved = 0;
    for (unsigned unit = 0; unit < 14; ++unit)
        if ((middleOf(*forest, 0, unit) - middleOf(*forest, 0, unit, false)).length() > 0.3) {
            ++moved;
            EXPECT_FALSE(hitsBark(*forest, middleOf(*forest, 0, unit, false), TreeId(0), unit)) << unit;
        }
    EXPECT_GT(moved, 3u) << "the wind is too weak to show anything";
}

TEST(TreePickingTest, HitsLeavesAsTheyFlutterAndTurnDownwind) {
    osg::ref_ptr<Forest> forest = blownForest(1);
    const PlacedTree& placed = movingForest(forest->getSimulation()).trees()[0];
    const TreeModel& model = movingForest(forest->getSimulation()).placed().modelOf(placed);
    const TreeMotion motion = movingForest(forest->getSimulation()).motion(0);
    for (std::size_t i = 0; i < model.leaves.size(); i += 7) {
        const LeafCluster& leaf = model.leaves[i];
        const glm::vec4& pull = motion.pulls[static_cast<std::size_t>(leaf.unit)];
        const glm::quat turn = downwindLeafTurn(leaf.orientation, motion.leaves[i], pull);
        glm::vec3 corners[4];
        for (int c = 0; c < 4; ++c)
            corners[c] =
                posedLeafPoint(leaf, closedCorner(model.leafMesh[static_cast<std::size_t>(c)].corner, pull),
                               turn, placed.scale, motion.poses[static_cast<std::size_t>(leaf.unit)]);
        const osg::Vec3d middle = standing(placed, (corners[0] + corners[1] + corners[2]) / 3.0f);
        osg::Vec3d across = standing(placed, corners[1]) - standing(placed, corners[0]);
        across = across ^ (standing(placed, corners[2]) - standing(placed, corners[0]));
        across *= 0.02 / across.length();
        bool hit = false;
        for (const auto& each : hits(*forest, middle - across, middle + across)) {
            const TreeHit* picked = pickedTree(each);
            hit = hit || (picked && picked->isLeaf(each.primitiveIndex) &&
                          picked->getUnit(each.primitiveIndex) == static_cast<unsigned>(leaf.unit));
        }
        EXPECT_TRUE(hit) << "leaf " << i;
    }
}

TEST(TreePickingTest, WorksBelowATransform) {
    osg::ref_ptr<Forest> forest = blownForest(2);
    const osg::Matrix place =
        osg::Matrix::rotate(0.8, osg::Vec3d(0.3, 0.2, 1.0)) * osg::Matrix::translate(70, -20, 9);
    osg::ref_ptr<osg::MatrixTransform> hill = new osg::MatrixTransform(place);
    hill->addChild(forest);
    const osg::Vec3d trunk = middleOf(*forest, 1, 0);
    const auto found =
        hits(*hill, (trunk - osg::Vec3d(0, 9, 0)) * place, (trunk + osg::Vec3d(0, 9, 0)) * place);
    bool onTrunk = false;
    for (const auto& hit : found) {
        ASSERT_NE(pickedTree(hit), nullptr);
        onTrunk = onTrunk || (hit.getWorldIntersectPoint() - trunk * place).length() < 0.3;
        EXPECT_EQ(hit.nodePath.back(), hit.drawable);
        EXPECT_NE(std::find(hit.nodePath.begin(), hit.nodePath.end(), forest), hit.nodePath.end());
    }
    EXPECT_TRUE(onTrunk);
}

TEST(TreePickingTest, HitsMovedAndAddedTreesButNotRemovedOnes) {
    osg::ref_ptr<Forest> forest = blownForest(3);
    const osg::Vec3d trunk = middleOf(*forest, 1, 0);
    ASSERT_TRUE(hitsBark(*forest, trunk, TreeId(1), 0));
    EXPECT_TRUE(forest->removeTree(TreeId(1)).empty());
    EXPECT_FALSE(hitsBark(*forest, trunk, TreeId(1), 0));
    TreePlacement moved = *forest->getSimulation().placementOf(TreeId(2));
    moved.position.x += 500.0;
    const osg::Vec3d before = middleOf(*forest, 2, 0);
    EXPECT_TRUE(forest->changeTree(TreeId(2), moved).empty());
    EXPECT_FALSE(hitsBark(*forest, before, TreeId(2), 0));
    EXPECT_TRUE(hitsBark(*forest, middleOf(*forest, 2, 0), TreeId(2), 0));
    const TreeId added = forest->addTree(smallForest(1).trees[0]).value();
    EXPECT_TRUE(hitsBark(*forest, middleOf(*forest, slotOfTree(added), 0), added, 0));
}

TEST(TreePickingTest, PolytopeHitsTreesInside) {
    osg::ref_ptr<Forest> forest = blownForest(8);
    const osg::Vec3d trunk = middleOf(*forest, 5, 0);
    osg::Polytope box;
    box.setToBoundingBox(osg::BoundingBox(osg::Vec3(trunk) - osg::Vec3(0.3f, 0.3f, 0.2f),
                                          osg::Vec3(trunk) + osg::Vec3(0.3f, 0.3f, 0.2f)));
    osg::ref_ptr<osgUtil::PolytopeIntersector> polytope = new osgUtil::PolytopeIntersector(box);
    osgUtil::IntersectionVisitor visitor(polytope);
    forest->accept(visitor);
    bool trunkMet = false;
    for (const auto& hit : polytope->getIntersections()) {
        const auto* picked = dynamic_cast<const TreeHit*>(hit.drawable.get());
        ASSERT_NE(picked, nullptr);
        trunkMet = trunkMet || (picked->getTree() == TreeId(5) && picked->getUnit(hit.primitiveIndex) == 0);
    }
    EXPECT_TRUE(trunkMet);
}

TEST(TreePickingTest, EveryIntersectorOfAGroupHitsItsTree) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4, 0.0f));
    updateFrames(*forest, 1, 2);
    osg::ref_ptr<osgUtil::IntersectorGroup> group = new osgUtil::IntersectorGroup;
    for (const std::size_t tree : {3, 0}) {
        const osg::Vec3d trunk = middleOf(*forest, tree, 0);
        group->addIntersector(
            new LineSegmentIntersector(trunk - osg::Vec3d(0, 0.5, 0), trunk + osg::Vec3d(0, 0.5, 0)));
    }
    osgUtil::IntersectionVisitor visitor(group);
    forest->accept(visitor);
    for (const osg::ref_ptr<osgUtil::Intersector>& each : group->getIntersectors())
        EXPECT_TRUE(each->containsIntersections());
}

TEST(TreePickingTest, NodeMaskHidesTrees) {
    osg::ref_ptr<Forest> forest = blownForest(1);
    instancedTrees(*forest->getInstanced()).setNodeMask(0x2);
    const osg::Vec3d trunk = middleOf(*forest, 0, 0);
    osg::ref_ptr<LineSegmentIntersector> line =
        new LineSegmentIntersector(trunk - osg::Vec3d(0, 1, 0), trunk + osg::Vec3d(0, 1, 0));
    osgUtil::IntersectionVisitor visitor(line);
    visitor.setTraversalMask(0x1);
    forest->accept(visitor);
    EXPECT_FALSE(line->containsIntersections());
}

TEST(TreePickingTest, PosesOnlyTreesNearTheLine) {
    ForestDescription description = smallForest(1);
    const TreePlacement first = description.trees[0];
    description.trees.clear();
    for (int i = 0; i < 10000; ++i) {
        description.trees.push_back(first);
        description.trees.back().position = {6.0 * (i % 100), 6.0 * (i / 100), 0.0};
    }
    osg::ref_ptr<Forest> forest = new Forest(description);
    const osg::Vec3d trunk = middleOf(*forest, 5050, 0);
    osg::ref_ptr<LineSegmentIntersector> line =
        new LineSegmentIntersector(trunk - osg::Vec3d(0.0, 0.4, 0.0), trunk + osg::Vec3d(0.0, 0.4, 0.0));
    PosedTreeCounter visitor(line);
    forest->accept(visitor);
    EXPECT_TRUE(line->containsIntersections());
    EXPECT_GE(visitor.posed, 1);
    EXPECT_LE(visitor.posed, 9) << "the tree and its neighbours";
}

TEST(TreePickingTest, HitKeepsItsPose) {
    osg::ref_ptr<Forest> forest = blownForest(1);
    const osg::Vec3d trunk = middleOf(*forest, 0, 0);
    const auto found = hits(*forest, trunk - osg::Vec3d(0, 1, 0), trunk + osg::Vec3d(0, 1, 0));
    ASSERT_FALSE(found.empty());
    const osg::ref_ptr<osg::Drawable> picked = found.begin()->drawable;
    const osg::BoundingBox box = picked->getBoundingBox();
    updateFrames(*forest, 61, 100);
    forest = nullptr;
    picked->dirtyBound();
    EXPECT_EQ(picked->getBoundingBox()._max, box._max);
    const osg::ref_ptr<osg::Drawable> copy = osg::clone(picked.get());
    EXPECT_EQ(copy->getBoundingBox()._max, box._max);
}

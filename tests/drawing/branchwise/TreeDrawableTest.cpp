// SPDX-License-Identifier: MIT
#include <tests/drawing/branchwise/BranchwiseFixtures.h>
#include <tests/drawing/branchwise/FakeCullVisitor.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Statistics>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// Hits of a segment, nearest first.
osgUtil::LineSegmentIntersector::Intersections pick(osg::Node& scene, const osg::Vec3d& from,
                                                    const osg::Vec3d& to) {
    osg::ref_ptr<osgUtil::LineSegmentIntersector> segment = new osgUtil::LineSegmentIntersector(from, to);
    osgUtil::IntersectionVisitor visitor(segment);
    scene.accept(visitor);
    return segment->getIntersections();
}

/// A bare tree that a storm bends, and the middle of its last unit before and after.
struct BentTree {
    osg::ref_ptr<Forest> forest;
    osg::Vec3d before, now;

    BentTree() {
        Species species = smallSpecies();
        species.tree.leaves.clustersPerBranch = 0;
        species.tree.wood.radius = 0.05f;
        forest = new Forest(branchwise(oneTree(species, 40.0f)));
        before = middle();
        updateFrames(*forest, 1, 60);
        now = middle();
    }
    osg::Vec3d middle() const {
        const PosedTree& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getPosedTree();
        const std::size_t last = tree.model().skeleton.units.size() - 1;
        return toOsg(tree.pose(last).apply(tree.scale().axes * tree.model().skeleton.point(last, 7)));
    }
    /// Picks along a short segment through a point, across the last unit.
    osgUtil::LineSegmentIntersector::Intersections pickAt(const osg::Vec3d& point) const {
        return pick(*forest, point + osg::Vec3d(0, 0.1, 0), point - osg::Vec3d(0, 0.1, 0));
    }
};

} // namespace

TEST(PickingTest, HitsABranchAtItsCurrentPlace) {
    const BentTree tree;
    ASSERT_GT((tree.now - tree.before).length(), 0.5) << "the storm did not bend the branch";
    const auto hits = tree.pickAt(tree.now);
    ASSERT_FALSE(hits.empty());
    EXPECT_LT((hits.begin()->getWorldIntersectPoint() - tree.now).length(), 0.1);
}

TEST(PickingTest, DoesNotHitABranchAtItsFormerPlace) {
    const BentTree tree;
    EXPECT_TRUE(tree.pickAt(tree.before).empty());
}

TEST(PickingTest, HitsALeafAtItsCurrentPlace) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(oneTree(smallSpecies())));
    updateFrames(*forest, 1, 20);
    glm::vec3 corners[verticesPerLeafCluster];
    branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getPosedTree()->leafPoints(20, corners);
    const glm::vec3 inside = 0.3f * corners[0] + 0.4f * corners[1] + 0.3f * corners[2];
    const glm::vec3 across = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const auto hits = pick(*forest, toOsg(inside + 0.05f * across), toOsg(inside - 0.05f * across));
    ASSERT_FALSE(hits.empty());
    EXPECT_STREQ(hits.begin()->drawable->className(), "LeafClusterDrawable");
}

TEST(BoundsTest, ContainEveryPosedPointInAStorm) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(smallForest(3, 45.0f)));
    for (unsigned frame = 1; frame <= 200; ++frame) {
        update(*forest, frame, frame / 25.0);
        if (frame % 20)
            continue;
        for (unsigned i = 0; i < forest->getNumTrees(); ++i) {
            const PosedTree& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[i]->getPosedTree();
            for (const SkinVertex& v : tree.model().skin().vertices)
                ASSERT_TRUE(tree.bounds().contains(
                    toOsg(tree.skinPoint(v, tree.pose(static_cast<std::size_t>(v.unit))))))
                    << "bark, frame " << frame;
            glm::vec3 corners[verticesPerLeafCluster];
            for (std::size_t leaf = 0; leaf < tree.model().leaves.size(); ++leaf) {
                tree.leafPoints(leaf, corners);
                for (const glm::vec3& corner : corners)
                    ASSERT_TRUE(tree.bounds().contains(toOsg(corner)))
                        << "leaf " << leaf << ", frame " << frame;
            }
        }
    }
}

TEST(BoundsTest, SceneBoundsGrowWithTheTrees) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(oneTree(smallSpecies(), 45.0f)));
    const osg::BoundingSphere rest = forest->getBound();
    updateFrames(*forest, 1, 100);
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    const osg::Group& drawn = *tree.getLod()->level(TreeLod::STAND_IN);
    for (unsigned i = 0; i < drawn.getNumChildren(); ++i)
        EXPECT_TRUE(
            drawn.getChild(i)->asDrawable()->getBoundingBox().contains(tree.getPosedTree()->bounds()._max));
    EXPECT_GT(forest->getBound().center().x() + forest->getBound().radius(),
              rest.center().x() + rest.radius());
}

TEST(BoundsTest, SettleInASteadyWind) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(smallForest(1)));
    updateFrames(*forest, 1, 250);
    const osg::BoundingBox settled =
        branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getPosedTree()->bounds();
    updateFrames(*forest, 251, 400);
    EXPECT_EQ(branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getPosedTree()->bounds()._max,
              settled._max);
    EXPECT_EQ(branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getPosedTree()->bounds()._min,
              settled._min);
}

TEST(StatisticsTest, ReferenceTreeHasTheCountsOfTheThesis) {
    osg::ref_ptr<Forest> forest = new Forest(branchwise(oneTree(Species())));
    FakeCullVisitor cull(1.0f);
    forest->accept(cull);
    updateFrames(*forest, 1, 1);
    osgUtil::StatsVisitor statistics;
    statistics.setTraversalMode(osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN);
    forest->accept(statistics);
    statistics.totalUpStats();
    EXPECT_EQ(statistics._instancedStats._vertexCount, 38656u);
    EXPECT_EQ(statistics._instancedStats._primitiveCount[GL_TRIANGLES].second, 3 * 40800u);
}

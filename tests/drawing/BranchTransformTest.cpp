// SPDX-License-Identifier: MIT
#include <tests/drawing/branchwise/BranchwiseFixtures.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// A tree that is scaled unevenly: five times as high as its model, and slim.
osg::ref_ptr<Forest> stretchedTree() {
    ForestDescription description = oneTree(Species());
    description.trees[0].position = {12.0, -7.0, 3.0};
    description.law = MotionLaw::ThesisSmooth;
    description.trees[0].heading = 1.1f;
    description.trees[0].size = {25.0f, 0.4f, 6.0f};
    return new Forest(branchwise(description));
}

const Skeleton& skeletonOf(TreeNode& tree) {
    return tree.getPosedTree()->model().skeleton;
}

osg::Vec3 scaledPoint(TreeNode& tree, const glm::vec3& rest) {
    return toOsg(tree.getPosedTree()->scale().axes * rest);
}

void turnAllBranches(TreeNode& tree) {
    std::mt19937 random(5);
    for (unsigned unit = 0; unit < tree.getNumBranches(); ++unit)
        tree.getBranch(unit)->setRotation(randomTurn(random));
}

} // namespace

TEST(BranchTransformTest, RotatesAboutItsBase) {
    const osg::Vec3 base(1.0f, 2.0f, 3.0f);
    osg::ref_ptr<BranchTransform> branch = new BranchTransform(7, base);
    branch->setRotation(osg::Quat(osg::PI_2, osg::Z_AXIS));
    EXPECT_LT((base * branch->getMatrix() - base).length(), 1e-6);
    const osg::Vec3 turned = (base + osg::X_AXIS) * branch->getMatrix();
    EXPECT_LT((turned - (base + osg::Y_AXIS)).length(), 1e-6) << "a quarter turn takes x to y";
}

TEST(BranchTransformTest, JointsStayConnectedUnderAnyAngles) {
    osg::ref_ptr<Forest> forest = stretchedTree();
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    turnAllBranches(tree);
    for (unsigned unit = 1; unit < tree.getNumBranches(); ++unit) {
        const BranchUnit& rest = skeletonOf(tree).units[unit];
        const auto parent = static_cast<unsigned>(rest.parent);
        const osg::Vec3d end = scaledPoint(tree, skeletonOf(tree).units[parent].tip);
        const osg::Vec3d start = scaledPoint(tree, rest.base);
        const double gap =
            (end * worldMatrix(*tree.getBranch(parent)) - start * worldMatrix(*tree.getBranch(unit)))
                .length();
        EXPECT_LT(gap, 1e-4) << "unit " << unit << " is detached from unit " << parent;
    }
}

TEST(BranchTransformTest, RotatingABranchDoesNotMoveItsSiblings) { // Fig 3.10
    osg::ref_ptr<Forest> forest = stretchedTree();
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    turnAllBranches(tree);
    const std::vector<BranchUnit>& units = skeletonOf(tree).units;
    const unsigned turned = 2; // the first branch on the trunk
    ASSERT_EQ(units[turned].level, 1);
    std::vector<osg::Matrix> before;
    for (unsigned unit = 0; unit < units.size(); ++unit)
        before.push_back(worldMatrix(*tree.getBranch(unit)));
    tree.getBranch(turned)->setRotation(osg::Quat(0.4, osg::X_AXIS) * tree.getBranch(turned)->getRotation());

    std::vector<bool> below(units.size(), false);
    below[turned] = true;
    for (unsigned unit = 0; unit < units.size(); ++unit) {
        if (units[unit].parent >= 0 && below[static_cast<unsigned>(units[unit].parent)])
            below[unit] = true;
        const bool moved = worldMatrix(*tree.getBranch(unit)) != before[unit];
        EXPECT_EQ(moved, below[unit]) << "unit " << unit;
    }
}

TEST(BranchTransformTest, HierarchyPosesTheBarkAsTheSimulationDoes) {
    osg::ref_ptr<Forest> forest = stretchedTree();
    updateFrames(*forest, 1, 60);
    TreeNode& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0];
    const PosedTree& posed = *tree.getPosedTree();
    const osg::Matrix toTree = osg::Matrix::inverse(worldMatrix(tree));
    double furthest = 0.0, moved = 0.0;
    for (const SkinVertex& vertex : posed.model().skin().vertices) {
        const auto unit = static_cast<unsigned>(vertex.unit);
        const osg::Vec3d rest = toOsg(posed.skinPoint(vertex, UnitPose()));
        const osg::Vec3d cpu = toOsg(posed.skinPoint(vertex, posed.pose(unit)));
        const osg::Vec3d throughNodes = rest * worldMatrix(*tree.getBranch(unit)) * toTree;
        furthest = std::max(furthest, (cpu - throughNodes).length());
        moved = std::max(moved, (cpu - rest).length());
    }
    EXPECT_LT(furthest, 1e-4);
    EXPECT_GT(moved, 0.01) << "the test is void: the wind did not move the tree";
}

TEST(BranchTransformTest, CloneRotatesIndependently) {
    osg::ref_ptr<BranchTransform> branch = new BranchTransform(7, osg::Vec3(1, 2, 3));
    branch->setRotation(osg::Quat(0.3, osg::X_AXIS));
    osg::ref_ptr<BranchTransform> copy = osg::clone(branch.get());
    EXPECT_EQ(copy->getUnit(), 7u);
    EXPECT_EQ(copy->getBase(), osg::Vec3(1, 2, 3));
    EXPECT_EQ(copy->getMatrix(), branch->getMatrix());
    EXPECT_EQ(copy->getDataVariance(), osg::Object::DYNAMIC);
    copy->setRotation(osg::Quat());
    EXPECT_NE(copy->getMatrix(), branch->getMatrix());
}

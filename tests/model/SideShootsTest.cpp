// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/SideShoots.h>

#include <osgTreeWind/growth/GrowTree.h>
#include <osgTreeWind/model/FormSkeleton.h>
#include <osgTreeWind/model/TreeModel.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

using namespace osgTreeWind;

namespace {

TreeParameters grownTree(float sideShoots) {
    TreeParameters tree;
    tree.growth = GrowthParameters{};
    tree.growth->size = {8.0f, 0.2f, 5.0f};
    tree.leaves.clusters = 1500;
    tree.leaves.inclination = 0.5f;
    tree.leaves.area = 5000.0f;
    tree.leaves.sideShoots = sideShoots;
    return tree;
}

/// Number of cubes of 0.4 m with leaves.
std::size_t leafyCubes(const TreeModel& model) {
    std::set<std::tuple<int, int, int>> cubes;
    for (const LeafCluster& leaf : model.leaves)
        cubes.emplace(static_cast<int>(std::floor(leaf.anchor.x / 0.4f)),
                      static_cast<int>(std::floor(leaf.anchor.y / 0.4f)),
                      static_cast<int>(std::floor(leaf.anchor.z / 0.4f)));
    return cubes.size();
}

} // namespace

TEST(SideShoots, SpreadTheSameLeavesOverMoreOfTheCrown) {
    const TreeModel without = makeTreeModel(grownTree(0.0f)), with = makeTreeModel(grownTree(0.5f));
    EXPECT_EQ(with.leaves.size(), without.leaves.size());
    EXPECT_GT(static_cast<double>(leafyCubes(with)), 1.15 * static_cast<double>(leafyCubes(without)));
}

TEST(SideShoots, ChangeNeitherMassNorSize) {
    const TreeModel without = makeTreeModel(grownTree(0.0f)), with = makeTreeModel(grownTree(0.5f));
    ASSERT_EQ(with.shootWood.size(), without.shootWood.size());
    for (std::size_t i = 0; i < with.shootWood.size(); ++i)
        EXPECT_EQ(with.shootWood[i].volume, without.shootWood[i].volume) << i;
    for (std::size_t side = 0; side < with.extents.sides.size(); ++side)
        EXPECT_EQ(with.extents.sides[side].leaves, without.extents.sides[side].leaves) << side;
}

TEST(SideShoots, AreThinShootsInTheOrderOfTheirUnits) {
    const Skeleton bare = makeSkeleton(growTree(*grownTree(0.0f).growth));
    Skeleton skeleton = bare;
    addSideShoots(skeleton, 0.5f, 3);
    ASSERT_GT(skeleton.shoots.size(), bare.shoots.size() + 50);
    float farthest = 0.0f, highest = 0.0f;
    for (const glm::vec3& point : bare.shootPoints) {
        farthest = std::max(farthest, std::hypot(point.x, point.y));
        highest = std::max(highest, point.z);
    }
    for (std::size_t i = 0; i < skeleton.shoots.size(); ++i) {
        const Shoot& shoot = skeleton.shoots[i];
        if (i > 0) {
            EXPECT_GE(shoot.unit, skeleton.shoots[i - 1].unit);
        }
        const bool isAdded = shoot.first >= bare.shootPoints.size();
        const float length =
            glm::distance(skeleton.shootPoint(shoot, 0), skeleton.shootPoint(shoot, shoot.count - 1));
        if (!isAdded)
            continue;
        EXPECT_GT(length, 0.3f);
        EXPECT_LT(length, 0.7f);
        EXPECT_LT(shoot.baseRadius, 0.02f);
        EXPECT_GT(shoot.tipRadius, 0.0f);
        EXPECT_GT(shoot.leafy.to, shoot.leafy.from);
        const glm::vec3& tip = skeleton.shootPoint(shoot, shoot.count - 1);
        EXPECT_LT(std::hypot(tip.x, tip.y), farthest + 0.7f);
        EXPECT_LT(tip.z, highest + 0.7f);
    }
}

TEST(SideShoots, FollowTheSeed) {
    const Skeleton bare = makeSkeleton(growTree(*grownTree(0.0f).growth));
    Skeleton one = bare, same = bare, other = bare, none = bare;
    addSideShoots(one, 0.5f, 3);
    addSideShoots(same, 0.5f, 3);
    addSideShoots(other, 0.5f, 4);
    addSideShoots(none, 0.0f, 3);
    EXPECT_EQ(one.shootPoints, same.shootPoints);
    EXPECT_NE(one.shootPoints, other.shootPoints);
    EXPECT_EQ(none.shootPoints, bare.shootPoints);
    Skeleton tiny = bare, shortest = bare;
    addSideShoots(tiny, 1e-6f, 3);
    addSideShoots(shortest, 0.1f, 3);
    EXPECT_EQ(tiny.shootPoints, shortest.shootPoints);
}

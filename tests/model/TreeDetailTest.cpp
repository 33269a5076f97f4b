// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeDetail.h>

#include <osgTreeWind/model/TreeModel.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace osgTreeWind {
namespace {

const TreeModel& reference() {
    static const TreeModel tree = makeTreeModel({});
    return tree;
}

ThinnedLeaves thinned(const TreeDetail& detail) {
    return thinnedLeaves(reference().leaves, reference().leafMesh, detail);
}

std::size_t verticesOf(const TreeDetail& detail) {
    const ThinnedLeaves leaves = thinned(detail);
    return thinnedSkin(reference().skeleton, detail).vertices.size() +
           leaves.clusters.size() * static_cast<std::size_t>(leaves.quads()) * 4;
}

/// Centre of quads of a cluster, in the tree's frame.
glm::vec3 middleOf(const LeafCluster& leaf, int firstQuad, int quads) {
    return leaf.anchor +
           leaf.size * (leaf.orientation * osgTreeWind::middleOf(reference().leafMesh, firstQuad, quads));
}

double areaOf(const std::vector<LeafCluster>& leaves, int quads) {
    double area = 0.0;
    for (const LeafCluster& leaf : leaves)
        area += quads * static_cast<double>(leaf.size) * static_cast<double>(leaf.size);
    return area;
}

TEST(TreeDetail, EveryReductionHasFewerVerticesThanTheOneBefore) {
    EXPECT_EQ(verticesOf(TreeDetail::full()), 38656u);
    std::size_t before = 38656u;
    for (int times = 1; times <= TreeDetail::reductions; ++times) {
        const std::size_t now = verticesOf(TreeDetail::reduced(times));
        EXPECT_LT(static_cast<double>(now), 0.8 * static_cast<double>(before)) << times;
        before = now;
    }
    EXPECT_LT(before, 38656u / 13);
}

TEST(TreeDetail, FullDetailIsTheTreeToTheBit) {
    const ThinnedLeaves leaves = thinned(TreeDetail::full());
    ASSERT_EQ(leaves.clusters.size(), reference().leaves.size());
    for (std::size_t i = 0; i < leaves.clusters.size(); ++i) {
        const LeafCluster &kept = leaves.clusters[i], &leaf = reference().leaves[i];
        ASSERT_TRUE(kept.anchor == leaf.anchor && kept.orientation == leaf.orientation &&
                    kept.size == leaf.size && kept.unit == leaf.unit && leaves.indices[i] == i);
    }
}

TEST(TreeDetail, FewerRingsKeepBothEndsOfEveryUnit) {
    const Skeleton& skeleton = reference().skeleton;
    for (const float tolerance : {0.0f, 0.001f, 0.01f, 0.1f}) {
        const BranchSkin skin = makeBranchSkin(skeleton, tolerance);
        for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
            const SkinVertex& first = skin.vertices[skin.firstVertices[unit]];
            ASSERT_EQ(first.centre, skeleton.point(unit, 0));
            ASSERT_EQ(skin.vertices[skin.firstVertices[unit + 1] - 1].centre, skeleton.point(unit, 15));
            ASSERT_EQ(first.unit, static_cast<float>(unit));
        }
    }
}

TEST(TreeDetail, ATinyToleranceKeepsAllAndAHugeOneMakesPrisms) {
    EXPECT_EQ(makeBranchSkin(reference().skeleton, 1e-9f).vertices.size(), 15616u);
    EXPECT_EQ(makeBranchSkin(reference().skeleton, 1e9f).vertices.size(), 122u * 2 * 3);
}

TEST(TreeDetail, RingsFollowABranchWithinTwiceTheTolerance) {
    Skeleton skeleton = reference().skeleton;
    skeleton.units.resize(1); // a quarter circle of 2 m radius
    skeleton.points.resize(16);
    for (int i = 0; i < 16; ++i) {
        const float angle = glm::half_pi<float>() * static_cast<float>(i) / 15.0f;
        skeleton.points[static_cast<std::size_t>(i)] =
            2.0f * glm::vec3(std::sin(angle), 0.0f, std::cos(angle));
    }
    for (const auto& [tolerance, most] : {std::pair(0.1f, 3), {0.01f, 9}, {0.002f, 16}}) {
        const BranchSkin skin = makeBranchSkin(skeleton, tolerance);
        std::vector<glm::vec3> centres;
        for (const SkinVertex& vertex : skin.vertices)
            if (centres.empty() || vertex.centre != centres.back())
                centres.push_back(vertex.centre);
        EXPECT_LE(centres.size(), static_cast<std::size_t>(most));
        for (std::size_t i = 0; i + 1 < centres.size(); ++i) {
            const glm::vec3 middle = 0.5f * (centres[i] + centres[i + 1]);
            EXPECT_LT(2.0f - glm::length(middle), 2.0f * tolerance + 1e-4f) << tolerance;
        }
    }
}

TEST(TreeDetail, ABranchWithFewerSidesHasTheSameMeanWidth) {
    const auto meanWidth = [](float tolerance) { // mean width and number of sides of the trunk's first ring
        const BranchSkin skin = makeBranchSkin(reference().skeleton, tolerance);
        const auto sides = static_cast<std::size_t>(
            std::count_if(skin.vertices.begin(), skin.vertices.end(),
                          [&](const SkinVertex& v) { return v.centre == skin.vertices.front().centre; }));
        double sum = 0.0;
        for (int step = 0; step < 360; ++step) {
            const float angle = glm::radians(static_cast<float>(step));
            const glm::vec3 across{std::cos(angle), std::sin(angle), 0.0f};
            float low = 1e9f, high = -1e9f;
            for (std::size_t i = 0; i < sides; ++i) {
                const float at = glm::dot(skin.vertices[i].radius * skin.vertices[i].outward, across);
                low = std::min(low, at);
                high = std::max(high, at);
            }
            sum += static_cast<double>(high - low) / 360.0;
        }
        return std::pair(sum, sides);
    };
    const auto [full, all] = meanWidth(0.0f);
    EXPECT_EQ(all, 8u);
    const float radius = reference().skeleton.units.front().baseRadius;
    for (const auto& [share, sides] : {std::pair(1.0f, 3u), {0.3f, 4u}, {0.15f, 6u}, {0.05f, 8u}}) {
        const auto [width, found] = meanWidth(share * radius);
        EXPECT_EQ(found, sides);
        EXPECT_NEAR(width / full, 1.0, 0.01) << sides;
    }
}

TEST(TreeDetail, FewerSidesStillFaceOutward) {
    const BranchSkin skin = makeBranchSkin(reference().skeleton, 1e9f);
    for (std::size_t i = 0; i < skin.indices.size(); i += 3) {
        const SkinVertex &a = skin.vertices[skin.indices[i]], &b = skin.vertices[skin.indices[i + 1]],
                         &c = skin.vertices[skin.indices[i + 2]];
        const glm::vec3 normal = glm::cross(b.position() - a.position(), c.position() - a.position());
        ASSERT_GT(glm::dot(normal, a.outward + b.outward + c.outward), 0.0f) << i;
    }
}

TEST(TreeDetail, KeptClustersAreEvenlyDistributedOverUnits) {
    for (const float share : {0.5f, 0.23f, 0.1f}) {
        TreeDetail detail;
        detail.leafShare = share;
        std::vector<int> perUnit(reference().skeleton.units.size(), 0);
        for (const LeafCluster& leaf : thinned(detail).clusters)
            ++perUnit[static_cast<std::size_t>(leaf.unit)];
        for (std::size_t unit = 2; unit < perUnit.size(); ++unit) // the trunk has no clusters
            EXPECT_NEAR(static_cast<float>(perUnit[unit]), 16.0f * share, 1.5f) << unit << ", " << share;
    }
}

TEST(TreeDetail, ThinnedLeavesKeepAreaPlacesAndIndices) {
    for (const int bough : {1, 2, 4}) {
        TreeDetail detail;
        detail.leafShare = 0.2f;
        detail.bough = bough;
        detail.leafArea = 0.9f;
        const ThinnedLeaves leaves = thinned(detail);
        const int quads = leaves.quads();
        EXPECT_EQ(quads, bough > 1 ? 1 : 3);
        EXPECT_NEAR(areaOf(leaves.clusters, quads) / areaOf(reference().leaves, 3), 0.9, 1e-4);
        for (std::size_t i = 0; i < leaves.clusters.size(); ++i) {
            const LeafCluster& original = reference().leaves[leaves.indices[i]];
            ASSERT_EQ(leaves.clusters[i].unit, original.unit);
            ASSERT_EQ(leaves.clusters[i].orientation, original.orientation);
            const glm::vec3 moved =
                glm::conjugate(original.orientation) *
                (middleOf(leaves.clusters[i], leaves.firstQuad(i), quads) - middleOf(original, 0, 3));
            ASSERT_LT(glm::length(glm::vec2(moved)), 1e-4f);
            ASSERT_LT(moved.z, 0.0f) << "inward, so that larger clusters hardly enlarge the crown";
            ASSERT_GT(moved.z, -0.5f * leaves.clusters[i].size * 0.5f);
        }
    }
}

TEST(TreeDetail, QuadsOfReducedTreesHaveTheSameDirections) {
    for (int times = 2; times <= TreeDetail::reductions; ++times) {
        const ThinnedLeaves leaves = thinned(TreeDetail::reduced(times));
        std::array<int, quadsPerLeafCluster> taken{};
        for (std::size_t i = 0; i < leaves.clusters.size(); ++i)
            ++taken[static_cast<std::size_t>(leaves.firstQuad(i))];
        for (const int count : taken)
            EXPECT_NEAR(3.0 * count / static_cast<double>(leaves.clusters.size()), 1.0, 0.05) << times;
    }
}

TEST(TreeDetail, LeavesOfReducedTreesKeepTheirSize) {
    for (int times = 1; times <= TreeDetail::reductions; ++times) {
        const ThinnedLeaves leaves = thinned(TreeDetail::reduced(times));
        const float growth = leaves.clusters.front().size / reference().leaves[leaves.indices.front()].size;
        EXPECT_GT(growth / static_cast<float>(leaves.bough), 0.8f) << times;
        EXPECT_LT(growth / static_cast<float>(leaves.bough), 1.3f) << times;
    }
}

TEST(TreeDetail, FewerClustersAreASubset) {
    std::vector<std::uint32_t> before;
    for (int times = TreeDetail::reductions; times > 0; --times) {
        const std::vector<std::uint32_t> now = thinned(TreeDetail::reduced(times)).indices;
        EXPECT_TRUE(std::includes(now.begin(), now.end(), before.begin(), before.end())) << times;
        before = now;
    }
}

TEST(TreeDetail, ThinUnitsHaveNoSkin) {
    TreeDetail detail;
    const float thick = reference().skeleton.units.front().baseRadius;
    detail.thinnest = 2.0f * 0.2f * thick / reference().skeleton.height();
    const BranchSkin skin = thinnedSkin(reference().skeleton, detail);
    EXPECT_LT(skin.vertices.size(), reference().skin().vertices.size());
    EXPECT_GT(skin.vertices.size(), 0u);
    for (const std::uint32_t index : skin.indices) {
        const auto unit = static_cast<std::size_t>(skin.vertices[index].unit);
        ASSERT_GE(reference().skeleton.units[unit].baseRadius, 0.2f * thick * 0.9999f);
    }
}

TEST(TreeDetail, ABareOrAbsentCrownHasNoClusters) {
    TreeDetail detail;
    detail.leafShare = 0.0f;
    EXPECT_TRUE(thinned(detail).clusters.empty());
    EXPECT_TRUE(thinnedLeaves({}, reference().leafMesh, TreeDetail::reduced(1)).clusters.empty());
}

} // namespace
} // namespace osgTreeWind

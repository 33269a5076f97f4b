// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/MeshParts.h>

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/modal/ModalLean.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

using namespace osgTreeWind;

namespace {

constexpr float coverage = 0.4f, modelHeight = 10.0f;

const TreeModel& reference() {
    static const TreeModel tree = makeTreeModel({});
    return tree;
}

std::vector<glm::vec3> randomPlaces(std::size_t count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> anywhere(0.0f, 1.0f);
    std::vector<glm::vec3> places(count);
    for (glm::vec3& place : places)
        place = {8.0f * anywhere(random), anywhere(random), 2.0f * anywhere(random)};
    return places;
}

/// Expects that parts cover a range of indices without gaps or overlaps.
void expectCover(const std::vector<MeshPart>& parts, std::size_t indices) {
    std::uint32_t next = 0;
    for (const MeshPart& part : parts) {
        EXPECT_EQ(part.firstIndex, next);
        EXPECT_GT(part.indices, 0u);
        EXPECT_EQ(part.firstVertex, 0);
        next += part.indices;
    }
    EXPECT_EQ(next, indices);
}

/// Expects that the box of a part is that of some points, and its rise that of its centre.
void expectTightBox(const MeshPart& part, const std::vector<glm::vec3>& points) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const glm::vec3& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    EXPECT_LT(glm::distance(part.centre - part.halfExtent, low), 1e-4f);
    EXPECT_LT(glm::distance(part.centre + part.halfExtent, high), 1e-4f);
    EXPECT_NEAR(part.rise, std::pow(part.centre.z / modelHeight, leanPower), 1e-4f);
}

float triangleArea(const std::array<glm::vec3, 3>& corners) {
    return 0.5f * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
}

using Triangle = std::array<std::uint32_t, 3>;
std::vector<Triangle> sortedTriangles(const BranchSkin& skin) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < skin.indices.size(); i += 3)
        triangles.push_back({skin.indices[i], skin.indices[i + 1], skin.indices[i + 2]});
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// Expects that parts of a skin draw each triangle once, within their boxes.
void expectPartsOf(const BranchSkin& before) {
    BranchSkin skin = before;
    const std::vector<MeshPart> parts = sortIntoParts(skin, modelHeight);
    expectCover(parts, before.indices.size());
    EXPECT_EQ(sortedTriangles(skin), sortedTriangles(before));
    for (const MeshPart& part : parts) {
        EXPECT_LE(part.indices, 3u * 192u);
        std::vector<glm::vec3> points;
        float reach = 0.0f, area = 0.0f;
        for (std::size_t i = part.firstIndex; i < part.firstIndex + part.indices; ++i) {
            const SkinVertex& vertex = skin.vertices[skin.indices[i]];
            points.push_back(vertex.position());
            reach = std::max(reach, vertex.radius);
            if (points.size() % 3 == 0)
                area += triangleArea({*(points.end() - 3), *(points.end() - 2), *(points.end() - 1)});
        }
        expectTightBox(part, points);
        EXPECT_EQ(part.reach, reach);
        EXPECT_NEAR(part.area, 0.25f * area, 1e-3f * area) << "a closed surface shows a quarter of its area";
    }
}

} // namespace

TEST(MeshPartsTest, GroupsContainEachItemOnce) {
    for (const std::size_t count : {1u, 7u, 64u, 65u, 1000u})
        for (const std::size_t most : {1u, 8u, 64u}) {
            const NearGroups groups = groupNear(randomPlaces(count), most);
            std::vector<std::uint32_t> all = groups.order, expected(count);
            std::sort(all.begin(), all.end());
            std::iota(expected.begin(), expected.end(), 0u);
            EXPECT_EQ(all, expected);
            ASSERT_EQ(groups.ends.back(), count);
            std::uint32_t first = 0;
            for (const std::uint32_t end : groups.ends) {
                EXPECT_GT(end, first);
                EXPECT_LE(end - first, most);
                EXPECT_TRUE(end - first >= most / 2 || groups.ends.size() == 1)
                    << "more groups than are necessary";
                EXPECT_TRUE(std::is_sorted(groups.order.begin() + first, groups.order.begin() + end));
                first = end;
            }
        }
    EXPECT_TRUE(groupNear({}, 8).ends.empty());
}

TEST(MeshPartsTest, GroupsAreCompact) {
    const std::vector<glm::vec3> places = randomPlaces(1024); // in a box of 8 x 1 x 2
    const NearGroups groups = groupNear(places, 64);
    ASSERT_EQ(groups.ends.size(), 16u);
    std::uint32_t first = 0;
    for (const std::uint32_t end : groups.ends) {
        glm::vec3 low = places[groups.order[first]], high = low;
        for (; first < end; ++first) {
            low = glm::min(low, places[groups.order[first]]);
            high = glm::max(high, places[groups.order[first]]);
        }
        const glm::vec3 sides = high - low; // a cube of 1 m, if it were perfect
        EXPECT_LT(std::max({sides.x, sides.y, sides.z}), 1.35f);
    }
}

TEST(MeshPartsTest, EqualPlacesAreGroupedByNumber) {
    const NearGroups groups = groupNear(std::vector<glm::vec3>(20, glm::vec3(1.0f)), 5);
    EXPECT_EQ(groups.ends, (std::vector<std::uint32_t>{5, 10, 15, 20}));
    EXPECT_TRUE(std::is_sorted(groups.order.begin(), groups.order.end()));
}

TEST(MeshPartsTest, PartsOfLeavesContainAllCards) {
    const auto& mesh = reference().leafMesh;
    for (const int reductions : {0, 2, 5}) {
        const ThinnedLeaves before = thinnedLeaves(reference().leaves, mesh, TreeDetail::reduced(reductions));
        ThinnedLeaves leaves = before;
        const std::vector<MeshPart> parts = sortIntoParts(leaves, mesh, coverage, modelHeight);
        const auto quads = static_cast<std::size_t>(before.quads());
        expectCover(parts, 6 * quads * before.clusters.size());
        EXPECT_EQ(leaves.bough, before.bough);
        std::vector<std::uint32_t> sorted = leaves.indices, expected = before.indices;
        std::sort(sorted.begin(), sorted.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(sorted, expected);
        for (std::size_t i = 0; i < leaves.clusters.size(); ++i) {
            const auto at = std::find(before.indices.begin(), before.indices.end(), leaves.indices[i]);
            EXPECT_EQ(leaves.clusters[i].anchor,
                      before.clusters[static_cast<std::size_t>(at - before.indices.begin())].anchor);
        }
        for (const MeshPart& part : parts) {
            EXPECT_LE(part.indices, 6u * 64u);
            std::vector<glm::vec3> corners;
            float reach = 0.0f, area = 0.0f;
            for (std::size_t i = part.firstIndex / (6 * quads);
                 i < (part.firstIndex + part.indices) / (6 * quads); ++i) {
                const LeafCluster& leaf = leaves.clusters[i];
                const auto first = static_cast<std::size_t>(4 * leaves.firstQuad(i));
                for (std::size_t corner = first; corner < first + 4 * quads; ++corner) {
                    const glm::vec3 way = leaf.size * (leaf.orientation * mesh[corner].corner);
                    corners.push_back(leaf.anchor + way);
                    reach = std::max(reach, glm::length(way));
                    const std::size_t count = corners.size();
                    if (count % 4 == 0)
                        area += triangleArea({corners[count - 4], corners[count - 3], corners[count - 2]}) +
                                triangleArea({corners[count - 4], corners[count - 2], corners[count - 1]});
                }
            }
            expectTightBox(part, corners);
            EXPECT_NEAR(part.reach, reach, 1e-4f);
            EXPECT_NEAR(part.area, 0.5f * coverage * area, 1e-3f * area)
                << "a flat surface shows half of its area";
        }
    }
}

TEST(MeshPartsTest, PartsOfASkinDrawEachTriangleOnce) {
    expectPartsOf(reference().skin());
    for (const int reductions : {2, 5})
        expectPartsOf(thinnedSkin(reference().skeleton, TreeDetail::reduced(reductions)));
}

TEST(MeshPartsTest, ScansHaveParts) {
    TreeParameters parameters;
    parameters.scans = std::make_shared<std::vector<ScannedTree>>(
        1, makeScannedTree({{{0, 0, 0}, {0, 0, 4}, 0.1, -1, 0}, {{0, 0, 4}, {1, 0, 6}, 0.05, 0, 0}}).value());
    expectPartsOf(makeTreeModel(parameters).skin());
}

TEST(MeshPartsTest, NothingHasNoParts) {
    ThinnedLeaves none = thinnedLeaves({}, reference().leafMesh, TreeDetail::full());
    EXPECT_TRUE(sortIntoParts(none, reference().leafMesh, coverage, modelHeight).empty());
    BranchSkin bare;
    EXPECT_TRUE(sortIntoParts(bare, modelHeight).empty());
}

TEST(MeshPartsTest, TheSameTreeHasTheSameParts) {
    BranchSkin skins[2] = {reference().skin(), reference().skin()};
    const std::vector<MeshPart> a = sortIntoParts(skins[0], modelHeight),
                                b = sortIntoParts(skins[1], modelHeight);
    EXPECT_EQ(skins[0].indices, skins[1].indices);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(a[i].indices, b[i].indices);
}

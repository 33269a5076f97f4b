// SPDX-License-Identifier: MIT
#include <tests/model/ModelTestCases.h>
#include <tests/model/SampleTree.h>

#include <osgTreeWind/model/LeafClusters.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

namespace osgTreeWind {
namespace {

const glm::vec3 petiole{0, 0, 1}; // in the leaf frame

TEST(LeafClusters, SixteenSitOnEveryBranchAndNoneOnTheTrunk) {
    const Skeleton skeleton = makeRecursiveTree({});
    std::vector<int> perUnit(skeleton.units.size());
    for (const LeafCluster& cluster : makeLeafClusters(skeleton, {}))
        ++perUnit[static_cast<std::size_t>(cluster.unit)];
    for (std::size_t unit = 0; unit < perUnit.size(); ++unit)
        EXPECT_EQ(perUnit[unit], skeleton.units[unit].level == 0 ? 0 : 16) << "unit " << unit;
}

TEST(LeafClusters, AreInAccessOrder) {
    const std::vector<LeafCluster> clusters = makeLeafClusters(makeRecursiveTree({}), {});
    for (std::size_t i = 0; i < clusters.size(); ++i)
        ASSERT_EQ(clusters[i].unit, static_cast<int>(2 + i / 16));
}

TEST(LeafClusters, FirstLevelLeavesInnerBranchesBare) {
    const Skeleton skeleton = makeRecursiveTree({});
    LeafParameters leaves;
    leaves.firstLevel = 3;
    EXPECT_EQ(makeLeafClusters(skeleton, leaves).size(), (27u + 81u) * 16);
    leaves.firstLevel = 0;
    EXPECT_EQ(makeLeafClusters(skeleton, leaves).size(), 122u * 16);
    leaves.firstLevel = 5;
    EXPECT_TRUE(makeLeafClusters(skeleton, leaves).empty());
}

TEST(LeafClusters, AreAnchoredOnTheCentreLineOfTheirBranch) {
    RecursiveTreeParameters p;
    p.crook = 0.3f;
    const Skeleton skeleton = makeRecursiveTree(p);
    for (const LeafCluster& cluster : makeLeafClusters(skeleton, {})) {
        float nearest = 1e9f;
        const auto unit = static_cast<std::size_t>(cluster.unit);
        for (int ring = 0; ring + 1 < skeleton.ringsPerBranch; ++ring) {
            const glm::vec3 a = skeleton.point(unit, ring), ab = skeleton.point(unit, ring + 1) - a;
            const float t =
                std::min(std::max(glm::dot(cluster.anchor - a, ab) / glm::dot(ab, ab), 0.0f), 1.0f);
            nearest = std::min(nearest, glm::distance(cluster.anchor, a + t * ab));
        }
        ASSERT_LT(nearest, 1e-5f) << "unit " << cluster.unit;
    }
}

TEST(LeafClusters, SpreadAlongTheWholeBranch) {
    const Skeleton skeleton = makeRecursiveTree(regularTree());
    const std::vector<LeafCluster> clusters = makeLeafClusters(skeleton, {});
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const BranchUnit& unit = skeleton.units[static_cast<std::size_t>(clusters[i].unit)];
        const float t = glm::distance(clusters[i].anchor, unit.base) / glm::distance(unit.tip, unit.base);
        ASSERT_NEAR(t, (static_cast<float>(i % 16) + 0.5f) / 16.0f, 1e-4f);
    }
}

TEST(LeafClusters, AnyParametersGiveUnitQuaternionsAndFiniteAnchors) {
    const float nan = std::nanf(""), huge = 1e30f;
    for (const float value : {nan, huge, -huge, 0.0f}) {
        LeafParameters leaves;
        leaves.length = leaves.width = leaves.innerSize = leaves.droop = value;
        for (const NamedParameters& c : extremeTrees()) {
            leaves.clustersPerBranch = c.name == "reference" ? 999 : 2;
            for (const LeafCluster& cluster : makeLeafClusters(makeRecursiveTree(c.parameters), leaves)) {
                ASSERT_NEAR(glm::length(cluster.orientation), 1.0f, 1e-5f) << c.name << ", " << value;
                ASSERT_TRUE(isFinite(cluster.anchor)) << c.name << ", " << value;
                ASSERT_GT(cluster.size, 0.0f) << c.name << ", " << value;
                ASSERT_LE(cluster.size, 1.25f) << c.name << ", " << value;
            }
        }
        for (const LeafVertex& vertex : makeLeafMesh(leaves)) {
            ASSERT_TRUE(isFinite(vertex.corner)) << value;
            ASSERT_TRUE(isFinite(vertex.normal)) << value;
        }
    }
}

TEST(LeafClusters, OutOfRangeLevelsAndCountsAreClamped) {
    LeafParameters leaves;
    leaves.clustersPerBranch = std::numeric_limits<int>::min();
    leaves.firstLevel = std::numeric_limits<int>::min();
    EXPECT_EQ(clamped(leaves).clustersPerBranch, 0);
    EXPECT_EQ(clamped(leaves).firstLevel, 0);
    EXPECT_TRUE(makeLeafClusters(makeRecursiveTree({}), leaves).empty());
    leaves.clustersPerBranch = std::numeric_limits<int>::max();
    EXPECT_EQ(makeLeafClusters(makeRecursiveTree({}), leaves).size(), 122u * 64);
}

TEST(LeafClusters, DroopTurnsPetiolesDown) {
    const auto meanRise = [](float droop) {
        LeafParameters leaves;
        leaves.droop = droop;
        float sum = 0.0f;
        for (const LeafCluster& cluster : makeLeafClusters(makeRecursiveTree({}), leaves))
            sum += (cluster.orientation * petiole).z;
        return sum / 1920.0f;
    };
    EXPECT_LT(meanRise(1.0f), -0.4f);
    EXPECT_GT(meanRise(-1.0f), 0.4f);
    EXPECT_LT(meanRise(0.3f), meanRise(0.0f));
}

TEST(LeafClusters, InnerClustersAreSmaller) {
    const Skeleton skeleton = makeRecursiveTree({});
    LeafParameters leaves;
    leaves.innerSize = 0.5f;
    for (const LeafCluster& cluster : makeLeafClusters(skeleton, leaves)) {
        const int level = skeleton.units[static_cast<std::size_t>(cluster.unit)].level;
        const float expected = 0.5f + 0.5f * static_cast<float>(level - 1) / 3.0f;
        ASSERT_NEAR(cluster.size, expected, 0.2501f * expected) << "level " << level;
    }
}

// A stored value, which compares compilers, optimization levels and machines.
TEST(LeafClusters, ReferenceLeavesAreTheSameOnEveryMachine) {
    std::vector<glm::vec3> bits;
    for (const LeafCluster& cluster : makeLeafClusters(makeRecursiveTree({}), {})) {
        bits.push_back(cluster.anchor);
        bits.emplace_back(cluster.orientation.x, cluster.orientation.y, cluster.orientation.z);
        bits.emplace_back(cluster.orientation.w, cluster.size, 0.0f);
    }
    EXPECT_EQ(fingerprint(bits), 0xa7d2788288d6d826ull);
}

TEST(LeafClusters, AnotherSeedMovesTheLeaves) {
    LeafParameters other;
    other.seed = 2;
    const Skeleton skeleton = makeRecursiveTree({});
    EXPECT_NE(makeLeafClusters(skeleton, {})[0].orientation,
              makeLeafClusters(skeleton, other)[0].orientation);
}

TEST(LeafMesh, IsThreeRectanglesOfTheGivenSizeAtThePetiole) {
    LeafParameters leaves;
    leaves.length = 0.8f;
    leaves.width = 0.3f;
    const auto mesh = makeLeafMesh(leaves);
    for (std::size_t quad = 0; quad < 12; quad += 4) {
        const glm::vec3 bottom = mesh[quad + 1].corner - mesh[quad].corner;
        const glm::vec3 side = mesh[quad + 3].corner - mesh[quad].corner;
        EXPECT_NEAR(glm::length(bottom), 0.3f, 1e-6f);
        EXPECT_NEAR(glm::length(side), 0.8f, 1e-6f);
        EXPECT_NEAR(glm::dot(bottom, side), 0.0f, 1e-6f);
        EXPECT_LT(glm::distance(mesh[quad + 2].corner, mesh[quad].corner + bottom + side), 1e-6f);
        EXPECT_LT(glm::length(mesh[quad].corner + mesh[quad + 1].corner), 1e-6f) << "centred on the petiole";
    }
}

TEST(LeafMesh, NormalsAreUnitVectorsOnTheCounterClockwiseSide) {
    const auto mesh = makeLeafMesh({});
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        const std::size_t quad = i / 4 * 4;
        const glm::vec3 face = glm::normalize(
            glm::cross(mesh[quad + 1].corner - mesh[quad].corner, mesh[quad + 3].corner - mesh[quad].corner));
        EXPECT_LT(glm::distance(mesh[i].normal, face), 1e-5f);
    }
}

TEST(LeafMesh, TextureCoversEveryQuadOnce) {
    const auto mesh = makeLeafMesh({});
    for (std::size_t quad = 0; quad < 12; quad += 4) {
        EXPECT_EQ(mesh[quad].uv, glm::vec2(0, 0));
        EXPECT_EQ(mesh[quad + 1].uv, glm::vec2(1, 0));
        EXPECT_EQ(mesh[quad + 2].uv, glm::vec2(1, 1));
        EXPECT_EQ(mesh[quad + 3].uv, glm::vec2(0, 1));
    }
}

/// Flat sprays, as on grown trees.
LeafParameters sprays(float inclination) {
    LeafParameters leaves;
    leaves.clusters = 1900;
    leaves.inclination = inclination;
    return leaves;
}

TEST(LeafSprays, HaveTheGivenNumberAndAreEvenlySpaced) {
    const Skeleton skeleton = sampleTree();
    const std::vector<LeafCluster> clusters = makeLeafClusters(skeleton, sprays(0.5f));
    EXPECT_EQ(clusters.size(), 1900u);
    std::vector<float> length(skeleton.units.size()), count(skeleton.units.size());
    float whole = 0.0f;
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        for (int ring = 1; ring < skeleton.ringsPerBranch; ++ring)
            length[i] += glm::distance(skeleton.point(i, ring - 1), skeleton.point(i, ring));
        if (skeleton.units[i].level > 0)
            whole += length[i];
    }
    for (const LeafCluster& cluster : clusters)
        ++count[static_cast<std::size_t>(cluster.unit)];
    for (std::size_t i = 0; i < skeleton.units.size(); ++i)
        ASSERT_NEAR(count[i], skeleton.units[i].level > 0 ? 1900.0f * length[i] / whole : 0.0f, 1.01f) << i;
}

TEST(LeafSprays, AreMissingFromTheInnerPartOfABough) {
    const Skeleton skeleton = sampleTree();
    LeafParameters leaves = sprays(0.5f);
    leaves.bare = 0.6f;
    std::vector<float> bough(skeleton.units.size()); // length of the branch that begins with the unit
    std::vector<std::size_t> first(skeleton.units.size());
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        const auto parent = static_cast<std::size_t>(std::max(unit.parent, 0));
        first[i] = unit.parent >= 0 && skeleton.units[parent].level == unit.level ? first[parent] : i;
        bough[first[i]] += glm::distance(unit.base, unit.tip);
    }
    for (const LeafCluster& cluster : makeLeafClusters(skeleton, leaves)) {
        const auto unit = static_cast<std::size_t>(cluster.unit);
        if (skeleton.units[unit].level == 1) {
            ASSERT_GT(glm::distance(cluster.anchor, skeleton.units[first[unit]].base),
                      0.55f * bough[first[unit]]);
        }
    }
}

TEST(LeafSprays, FacesHaveTheMeasuredInclinationOfTheSpecies) {
    // Chianucci et al. 2018: hornbeam 13, beech 18, Norway maple and red oak 27, oak 35, aspen 37, birch 56.
    const Skeleton skeleton = sampleTree();
    for (const float degrees : {13.0f, 18.0f, 27.0f, 35.0f, 37.0f, 56.0f}) {
        const LeafParameters leaves = sprays(glm::radians(degrees));
        float sum = 0.0f, area = 0.0f;
        std::array<float, 4> around{};
        for (const LeafCluster& cluster : makeLeafClusters(skeleton, leaves)) {
            const glm::vec3 normal = cluster.orientation * glm::vec3(0, -1, 0);
            const float share = cluster.size * cluster.size;
            sum += share * std::acos(std::min(std::abs(normal.z), 1.0f));
            area += share;
            around[(normal.x > 0.0f ? 1 : 0) + (normal.y > 0.0f ? 2 : 0)] += share;
        }
        // Of clusters; the leaves on the cards add to it (TreeLooksTest).
        EXPECT_GT(glm::degrees(sum / area), 0.8f * degrees);
        EXPECT_LT(glm::degrees(sum / area), degrees);
        for (const float quarter : around)
            EXPECT_NEAR(quarter / area, 0.25f, 0.055f) << "to all sides";
    }
}

TEST(LeafSprays, HalvesOfLeavesFoldUpward) {
    const auto mesh = makeLeafMesh(sprays(0.5f));
    float fold = 0.0f;
    for (const std::size_t quad : {1u, 2u})
        fold += 0.5f * std::acos(std::abs(mesh[4 * quad].normal.y));
    EXPECT_NEAR(glm::degrees(fold), 34.0f, 3.0f); // 5 in the shade to 45 in the sun, Fleck et al. 2003
    EXPECT_LT(mesh[4].normal.x * mesh[8].normal.x, 0.0f) << "to opposite sides";
}

TEST(LeafSprays, PointOutwardAndLieInTheirPlane) {
    const LeafParameters leaves = sprays(0.6f);
    for (const LeafCluster& cluster : makeLeafClusters(sampleTree(), leaves)) {
        ASSERT_NEAR(glm::length(cluster.orientation), 1.0f, 1e-5f);
        const glm::vec3 face = cluster.orientation * glm::vec3(0, -1, 0);
        ASSERT_GE(face.z, -1e-5f) << "the upper side is up";
    }
    const auto mesh = makeLeafMesh(leaves);
    for (const LeafVertex& vertex : mesh) {
        EXPECT_LT(std::abs(vertex.corner.y), 0.11f * leaves.length + 0.5f * leaves.width * std::sin(0.6f));
        EXPECT_LT(vertex.normal.y, -std::cos(0.65f));
    }
}

TEST(Fronds, HaveTwoRowsOfLeafletsInAVAndOneThatHangs) {
    LeafParameters fronds = sprays(0.0f);
    fronds.frond = true;
    fronds.length = 0.4f;
    fronds.width = 0.5f;
    const auto mesh = makeLeafMesh(fronds);
    const auto tipOf = [&](std::size_t row) { return mesh[4 * row + 3].corner - mesh[4 * row].corner; };
    const float v = glm::degrees(std::acos(glm::dot(tipOf(0), tipOf(1)) / (0.5f * 0.5f)));
    EXPECT_NEAR(v, 140.0f, 1.0f);
    EXPECT_LT(tipOf(0).y, 0.0f) << "up is -y";
    EXPECT_GT(tipOf(2).y, 0.4f);
    for (std::size_t i = 0; i < mesh.size(); ++i) {
        EXPECT_NEAR(glm::length(mesh[i].normal), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(mesh[i].normal, tipOf(i / 4)), 0.0f, 1e-5f);
        EXPECT_LT(mesh[i].normal.y, 0.0f);
        EXPECT_NEAR(mesh[i].corner.z, 0.4f * mesh[i].uv.x, 1e-6f) << "along the frond";
    }
    const Skeleton skeleton = sampleTree();
    for (const LeafCluster& cluster : makeLeafClusters(skeleton, fronds)) {
        const glm::vec3 up = cluster.orientation * glm::vec3(0, -1, 0),
                        along = cluster.orientation * glm::vec3(0, 0, 1);
        ASSERT_GE(up.z, -1e-5f);
        ASSERT_NEAR(glm::dot(up, along), 0.0f, 1e-5f);
    }
}

TEST(HangingShoots, HangOnBothSidesOfATwigWithARowOnTop) {
    for (const float inclination : {25.0f, 45.0f}) {
        LeafParameters leaves = sprays(glm::radians(inclination));
        const auto spray = makeLeafMesh(leaves);
        leaves.hanging = true;
        const auto mesh = makeLeafMesh(leaves);
        float sum = 0.0f;
        for (std::size_t quad = 0; quad < 3; ++quad) {
            const LeafVertex* v = &mesh[4 * quad];
            const glm::vec3 across = v[1].corner - v[0].corner, along = v[3].corner - v[0].corner;
            EXPECT_NEAR(glm::dot(across, along), 0.0f, 1e-6f);
            EXPECT_GT(glm::length(along), 1.4f * glm::length(across));
            EXPECT_NEAR(glm::length(along) * glm::length(across),
                        glm::distance(spray[0].corner, spray[1].corner) *
                            glm::distance(spray[0].corner, spray[3].corner),
                        1e-5f)
                << "as large as a spray";
            EXPECT_NEAR(glm::length(v->normal - glm::normalize(glm::cross(across, along))), 0.0f, 1e-5f);
            EXPECT_LT(v->normal.y, 0.0f) << "up is -y";
            sum += glm::degrees(std::acos(-v->normal.y)) / 3.0f;
            if (quad < 2) {
                EXPECT_GT(along.y, 0.25f * glm::length(along)) << "it hangs";
                EXPECT_GT((quad == 0 ? 1.0f : -1.0f) * along.x, 0.0f);
                EXPECT_GT(along.z, 0.0f);
            }
        }
        EXPECT_NEAR(sum, inclination, 0.15f * inclination);
    }
}

} // namespace
} // namespace osgTreeWind

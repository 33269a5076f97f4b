// SPDX-License-Identifier: MIT
#include <tests/model/ModelTestCases.h>

#include <osgTreeWind/model/BranchSkin.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace osgTreeWind {
namespace {

struct Triangle {
    SkinVertex corner[3];
    glm::dvec3 areaVector; ///< Normal, with twice the area as its length.
};

Triangle triangle(const BranchSkin& skin, std::size_t index) {
    Triangle t{};
    glm::dvec3 p[3];
    for (std::size_t i = 0; i < 3; ++i) {
        t.corner[i] = skin.vertices[skin.indices[3 * index + i]];
        p[i] = glm::dvec3(t.corner[i].position());
    }
    t.areaVector = glm::cross(p[1] - p[0], p[2] - p[0]);
    return t;
}

TEST(BranchSkin, ReferenceTreeHas15616VerticesAnd29280Triangles) {
    const BranchSkin skin = makeBranchSkin(makeRecursiveTree({}));
    EXPECT_EQ(skin.vertices.size(), 15616u);
    EXPECT_EQ(skin.indices.size(), 29280u * 3);
    for (std::uint32_t unit = 0; unit <= 122; ++unit) {
        EXPECT_EQ(skin.firstVertices[unit], 128 * unit);
        EXPECT_EQ(skin.firstIndices[unit], 15 * 16 * 3 * unit);
    }
}

TEST(BranchSkin, RingsLieAcrossTheBranchAtItsRadius) {
    for (const NamedParameters& c : extremeTrees()) {
        const Skeleton skeleton = makeRecursiveTree(c.parameters);
        const BranchSkin skin = makeBranchSkin(skeleton);
        std::size_t index = 0;
        for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
            for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring)
                for (int side = 0; side < 8; ++side) {
                    const SkinVertex& vertex = skin.vertices[index++];
                    ASSERT_EQ(vertex.unit, static_cast<float>(unit)) << c.name;
                    ASSERT_EQ(vertex.centre, skeleton.point(unit, ring)) << c.name;
                    ASSERT_EQ(vertex.radius, skeleton.radius(unit, ring)) << c.name;
                    ASSERT_NEAR(glm::length(vertex.outward), 1.0f, 1e-5f) << c.name;
                    ASSERT_NEAR(glm::dot(vertex.outward, skeleton.tangent(unit, ring)), 0.0f, 1e-5f)
                        << c.name;
                }
        ASSERT_EQ(index, skin.vertices.size()) << c.name;
    }
}

TEST(BranchSkin, BarkCoordinateContinuesFromTheParent) {
    Skeleton skeleton = makeRecursiveTree(regularTree());
    BranchUnit& branch = skeleton.units[2];
    branch.attach = 0.25f;
    const std::size_t parent = static_cast<std::size_t>(branch.parent);
    const BranchSkin skin = makeBranchSkin(skeleton);
    const std::size_t perUnit = static_cast<std::size_t>(skeleton.ringsPerBranch) * 8;
    const float start = skin.vertices[parent * perUnit].uv.y,
                end = skin.vertices[(parent + 1) * perUnit - 1].uv.y;
    EXPECT_FLOAT_EQ(skin.vertices[2 * perUnit].uv.y, start + 0.25f * (end - start));
}

TEST(BranchSkin, RingsOfAStraightBranchAreRegularOctagons) {
    const BranchSkin skin = makeBranchSkin(makeRecursiveTree(regularTree()));
    for (std::size_t ring = 0; ring < skin.vertices.size(); ring += 8)
        for (std::size_t side = 0; side < 8; ++side) {
            const SkinVertex& a = skin.vertices[ring + side];
            const SkinVertex& b = skin.vertices[ring + (side + 1) % 8];
            ASSERT_NEAR(glm::dot(a.outward, b.outward), std::sqrt(0.5), 1e-5);
        }
}

TEST(BranchSkin, RingsAreNotTwistedAlongTheBranch) {
    const BranchSkin skin = makeBranchSkin(makeRecursiveTree({}));
    for (std::size_t i = 0; i + 8 < skin.vertices.size(); ++i)
        if (skin.vertices[i].unit == skin.vertices[i + 8].unit) {
            ASSERT_GT(glm::dot(skin.vertices[i].outward, skin.vertices[i + 8].outward), 0.9f);
        }
}

TEST(BranchSkin, NoTriangleIsDegenerateEvenInExtremeTrees) {
    for (const NamedParameters& c : extremeTrees()) {
        const BranchSkin skin = makeBranchSkin(makeRecursiveTree(c.parameters));
        for (std::size_t i = 0; i < skin.indices.size() / 3; ++i)
            ASSERT_GT(glm::length(triangle(skin, i).areaVector), 0.0) << c.name << ", triangle " << i;
    }
}

TEST(BranchSkin, TrianglesAreCounterClockwiseSeenFromOutside) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        RecursiveTreeParameters p;
        p.seed = seed;
        const BranchSkin skin = makeBranchSkin(makeRecursiveTree(p));
        for (std::size_t i = 0; i < skin.indices.size() / 3; ++i) {
            const Triangle t = triangle(skin, i);
            for (const SkinVertex& corner : t.corner)
                ASSERT_GT(glm::dot(t.areaVector, glm::dvec3(corner.outward)), 0.0)
                    << "seed " << seed << ", triangle " << i;
        }
    }
}

// Every inner edge of an open tube has two triangles; each end ring has eight edges with one.
TEST(BranchSkin, EveryUnitIsAnOpenTubeWithoutCracks) {
    const BranchSkin skin = makeBranchSkin(makeRecursiveTree({}));
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < skin.firstIndices[1]; i += 3)
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t a = skin.indices[i + side], b = skin.indices[i + (side + 1) % 3];
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    int open = 0;
    for (const auto& [edge, triangles] : edges) {
        ASSERT_LE(triangles, 2);
        open += triangles == 1;
    }
    EXPECT_EQ(open, 16);
    EXPECT_EQ(edges.size(), 15u * 8 * 3 + 8u); // per interval 8 along, 8 diagonal, 8 around; plus one ring
}

TEST(BranchSkin, IndicesAreSortedByUnit) {
    const BranchSkin skin = makeBranchSkin(makeRecursiveTree({}));
    for (std::size_t i = 0; i < skin.indices.size(); ++i)
        ASSERT_EQ(skin.vertices[skin.indices[i]].unit, static_cast<float>(i / skin.firstIndices[1]));
}

TEST(BranchSkin, DrawOrderIsTheIndexedVertices) {
    const BranchSkin skin = makeBranchSkin(makeRecursiveTree({}));
    const std::vector<SkinVertex> ordered = skin.drawOrder();
    ASSERT_EQ(ordered.size(), 87840u); // thesis §2.3.5: three per triangle
    for (std::size_t i = 0; i < ordered.size(); ++i)
        ASSERT_EQ(ordered[i].position(), skin.vertices[skin.indices[i]].position());
}

TEST(BranchSkin, BarkCoordinatesRunAroundAndAlongTheBranch) {
    const BranchSkin skin = makeBranchSkin(makeRecursiveTree(regularTree()));
    EXPECT_EQ(skin.vertices[0].uv, glm::vec2(0.0f));
    for (std::size_t side = 0; side < 8; ++side)
        EXPECT_FLOAT_EQ(skin.vertices[side].uv.x, 0.25f * static_cast<float>(side)); // of 2
    EXPECT_NEAR(skin.vertices[15 * 8].uv.y, 2.4 / (2 * 3.14159265 * 0.17), 1e-4);
}

TEST(BranchSkin, BarkHasOneSizeAlongThickStems) {
    RecursiveTreeParameters thick = regularTree();
    const auto rise = [&](float radius) {
        Skeleton skeleton = makeRecursiveTree(thick);
        skeleton.units[0].baseRadius = radius;
        return makeBranchSkin(skeleton).vertices[15 * 8].uv.y;
    };
    EXPECT_EQ(rise(0.8f), rise(0.3f));
    EXPECT_GT(rise(0.1f), 1.5f * rise(0.3f));
}

} // namespace
} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <tests/model/SampleTree.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace osgTreeWind {
namespace {

Skeleton grown(float flare = 0.6f, std::uint32_t seed = 1) {
    return sampleTree(seed, flare);
}

/// The vertices of a unit's first ring, which ends where `uv.x` repeats.
std::vector<SkinVertex> firstRing(const BranchSkin& skin, std::size_t unit) {
    const auto first = skin.vertices.begin() + skin.firstVertices[unit];
    const auto next = std::find_if(first + 1, skin.vertices.end(),
                                   [](const SkinVertex& vertex) { return vertex.uv.x == 0.0f; });
    return {first, next};
}

bool springsFromEnd(const BranchUnit& unit) {
    return unit.parent >= 0 && unit.attach == 1.0f;
}

/// Number of edges of a unit that belong to one triangle only.
int openEdges(const BranchSkin& skin, std::size_t unit) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = skin.firstIndices[unit]; i < skin.firstIndices[unit + 1]; i += 3)
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t a = skin.indices[i + side], b = skin.indices[i + (side + 1) % 3];
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    return static_cast<int>(
        std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 1; }));
}

TEST(JoinedSkin, HasTheSizeOfSizeOfBranchSkin) {
    for (std::uint32_t seed = 1; seed < 6; ++seed) {
        const Skeleton skeleton = grown(0.2f * static_cast<float>(seed - 1), seed);
        const BranchSkin skin = makeBranchSkin(skeleton);
        EXPECT_EQ(skin.vertices.size(), sizeOfBranchSkin(skeleton).vertices);
        EXPECT_EQ(skin.indices.size(), 3 * sizeOfBranchSkin(skeleton).triangles);
        EXPECT_EQ(skin.firstVertices.back(), skin.vertices.size());
        EXPECT_EQ(skin.firstIndices.back(), skin.indices.size());
    }
}

TEST(JoinedSkin, AUnitAtAnEndBeginsWithTheParentsLastRing) {
    const Skeleton skeleton = grown();
    for (const float tolerance : {0.0f, 0.005f, 0.05f}) {
        const BranchSkin skin = makeBranchSkin(skeleton, tolerance);
        int found = 0;
        for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
            if (!springsFromEnd(skeleton.units[unit]))
                continue;
            ++found;
            const auto parent = static_cast<std::size_t>(skeleton.units[unit].parent);
            const auto first = skin.vertices.begin() + skin.firstVertices[parent],
                       end = skin.vertices.begin() + skin.firstVertices[parent + 1];
            for (const SkinVertex& vertex : firstRing(skin, unit)) {
                const bool isThere = std::any_of(first, end, [&](const SkinVertex& other) {
                    return other.position() == vertex.position() && other.unit == vertex.unit;
                });
                ASSERT_TRUE(isThere) << "unit " << unit << ", " << tolerance;
                ASSERT_EQ(vertex.unit, static_cast<float>(parent)) << "the joint would open in wind";
            }
        }
        EXPECT_GT(found, 5);
    }
}

TEST(JoinedSkin, FreeEndsAreClosed) {
    const Skeleton skeleton = grown();
    const BranchSkin skin = makeBranchSkin(skeleton);
    std::vector<bool> goesOn(skeleton.units.size(), false);
    for (const BranchUnit& unit : skeleton.units)
        if (springsFromEnd(unit))
            goesOn[static_cast<std::size_t>(unit.parent)] = true;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        const int sides = static_cast<int>(firstRing(skin, unit).size());
        ASSERT_EQ(openEdges(skin, unit), goesOn[unit] ? 2 * sides : sides) << "unit " << unit;
    }
}

TEST(JoinedSkin, SideBranchesBeginWithACollarInTheBarkOfTheirParent) {
    const Skeleton skeleton = grown();
    const BranchSkin skin = makeBranchSkin(skeleton);
    int wide = 0, branches = 0;
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        const BranchUnit& unit = skeleton.units[i];
        if (unit.parent < 0 || springsFromEnd(unit))
            continue;
        ++branches;
        const BranchUnit& parent = skeleton.units[static_cast<std::size_t>(unit.parent)];
        float widest = 0.0f;
        const std::vector<SkinVertex> ring = firstRing(skin, i);
        for (const SkinVertex& vertex : ring) {
            ASSERT_EQ(vertex.unit, static_cast<float>(unit.parent));
            ASSERT_LE(vertex.radius, std::max(parent.baseRadius, 1.1f * unit.baseRadius));
            for (const SkinVertex& other : ring)
                widest = std::max(widest, glm::distance(vertex.position(), other.position()));
        }
        wide += widest > 2.2f * unit.baseRadius;
    }
    EXPECT_GT(wide, 9 * branches / 10) << "of " << branches;
}

TEST(JoinedSkin, FacesOutward) {
    const BranchSkin skin = makeBranchSkin(grown());
    std::size_t inward = 0;
    for (std::size_t i = 0; i < skin.indices.size(); i += 3) {
        const SkinVertex &a = skin.vertices[skin.indices[i]], &b = skin.vertices[skin.indices[i + 1]],
                         &c = skin.vertices[skin.indices[i + 2]];
        const glm::vec3 normal = glm::cross(b.position() - a.position(), c.position() - a.position());
        inward += glm::dot(normal, a.outward + b.outward + c.outward) < 0.0f;
    }
    EXPECT_LT(inward, skin.indices.size() / 3 / 100) << "of " << skin.indices.size() / 3 << " triangles";
}

TEST(JoinedSkin, StemsHaveMoreSidesThanTwigs) {
    const Skeleton skeleton = grown();
    const BranchSkin skin = makeBranchSkin(skeleton);
    std::size_t fewest = 99;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        fewest = std::min(fewest, firstRing(skin, unit).size());
    EXPECT_GE(firstRing(skin, 0).size(), 16u);
    EXPECT_EQ(fewest, 6u);
    EXPECT_LE(skin.vertices.size(), 8 * skeleton.points.size());
}

TEST(JoinedSkin, AtALargeToleranceEveryUnitIsAPrism) {
    const Skeleton skeleton = grown();
    EXPECT_EQ(makeBranchSkin(skeleton, 1e9f).vertices.size(), skeleton.units.size() * 2 * 3);
    std::size_t before = makeBranchSkin(skeleton).vertices.size();
    for (const float tolerance : {0.005f, 0.01f, 0.02f, 0.1f}) {
        const std::size_t now = makeBranchSkin(skeleton, tolerance).vertices.size();
        EXPECT_LT(now, before) << tolerance;
        before = now;
    }
}

TEST(JoinedSkin, IsFiniteInExtremeTrees) {
    std::vector<PalmParameters> extremes(7);
    extremes[0].fronds = 200;
    extremes[1].height = 0.5f;
    extremes[1].trunkDiameter = 0.25f;
    extremes[2].height = extremes[2].crownWidth = 60.0f;
    extremes[2].trunkDiameter = 5.0f;
    extremes[3].inclination = extremes[3].inclinationEnd = 0.0f;        // along the stem
    extremes[4].inclination = extremes[4].inclinationEnd = 3.14159265f; // back into the stem
    extremes[5].trunkDiameter = 0.01f;
    extremes[5].trunkTaper = 0.05f;
    extremes[6].trunkCrook = 1.0f;
    for (std::size_t i = 0; i < extremes.size(); ++i) {
        extremes[i].flare = 3.0f;
        const Skeleton skeleton = makePalmTree(extremes[i]);
        for (const float tolerance : {0.0f, 0.003f, 0.02f, 1.0f}) {
            const BranchSkin skin = makeBranchSkin(skeleton, tolerance);
            for (const SkinVertex& vertex : skin.vertices) {
                ASSERT_NEAR(glm::length(vertex.outward), 1.0f, 1e-3f) << "tree " << i;
                ASSERT_LT(glm::length(vertex.position()), 1000.0f) << "tree " << i;
                ASSERT_TRUE(vertex.uv.y >= 0.0f && vertex.uv.y < 1e7f) << "tree " << i;
            }
        }
    }
}

TEST(JoinedSkin, AFootBetweenTwoRingsIsOmitted) {
    const auto pole = [](float flare) {
        PalmParameters parameters = barePole(8.0f);
        parameters.flare = flare;
        return makePalmTree(parameters);
    };
    const BranchSkin flared = makeBranchSkin(pole(2.0f), 1e9f), plain = makeBranchSkin(pole(0.0f), 1e9f);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(flared.vertices[i].radius, plain.vertices[i].radius);
    EXPECT_GT(makeBranchSkin(pole(2.0f), 0.01f).vertices[0].radius, 2.0f * plain.vertices[0].radius);
}

TEST(JoinedSkin, AFootGoesOnBelowTheGround) {
    const BranchSkin skin = makeBranchSkin(grown());
    for (const SkinVertex& vertex : firstRing(skin, 0))
        EXPECT_LT(vertex.position().z, -0.01f);
}

TEST(JoinedSkin, AFlareWidensTheFootAndNotTheTree) {
    TreeParameters plain, flared;
    plain.palm.emplace().flare = 0.0f;
    flared.palm.emplace().flare = 3.0f;
    const TreeModel a = makeTreeModel(plain), b = makeTreeModel(flared);
    EXPECT_GT(b.skin().vertices[0].radius, 2.0f * a.skin().vertices[0].radius);
    const TreeSize before = measureTree(a), after = measureTree(b);
    EXPECT_EQ(after.crownWidth, before.crownWidth);
    EXPECT_EQ(after.trunkDiameter, before.trunkDiameter);
}

} // namespace
} // namespace osgTreeWind

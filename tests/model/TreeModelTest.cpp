// SPDX-License-Identifier: MIT
#include <tests/model/ModelTestCases.h>

#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

namespace osgTreeWind {
namespace {

std::vector<std::uint64_t> values(const TreeCounts& c) {
    return {c.units,         c.branches,     c.skeletonPoints, c.skinVertices,
            c.skinTriangles, c.leafVertices, c.leafTriangles};
}

// Design section 4.
TEST(TreeModel, ReferenceTreeCountsAreExact) {
    const TreeCounts counts = countTree(makeTreeModel({}));
    EXPECT_EQ(values(counts), (std::vector<std::uint64_t>{122, 120, 1952, 15616, 29280, 23040, 11520}));
    EXPECT_EQ(counts.totalVertices(), 38656u);
    EXPECT_EQ(counts.totalTriangles(), 40800u);
}

TEST(TreeModel, CountsMatchWithoutGrowing) {
    for (int levels = 0; levels <= 5; ++levels)
        for (int children = 1; children <= 4; ++children)
            for (int firstLevel = 0; firstLevel <= 3; ++firstLevel) {
                TreeParameters p;
                p.wood.levels = levels;
                p.wood.childrenPerBranch = children;
                p.wood.trunkUnits = 1 + firstLevel;
                p.wood.ringsPerBranch = 2 + levels;
                p.leaves.firstLevel = firstLevel;
                p.leaves.clustersPerBranch = children;
                EXPECT_EQ(values(countTree(p)), values(countTree(makeTreeModel(p))))
                    << levels << " levels of " << children << ", leaves from " << firstLevel;
            }
}

TEST(TreeModel, CountsOfExtremeTreesMatchWithoutGrowing) {
    for (const NamedParameters& c : extremeTrees()) {
        TreeParameters p;
        p.wood = c.parameters;
        p.leaves.clustersPerBranch = -3;
        p.leaves.firstLevel = -1000;
        EXPECT_EQ(values(countTree(p)), values(countTree(makeTreeModel(p)))) << c.name;
    }
}

TEST(TreeModel, CountsAddUp) {
    TreeCounts sum = countTree(TreeParameters{});
    sum += countTree(TreeParameters{});
    EXPECT_EQ(values(sum), (std::vector<std::uint64_t>{244, 240, 3904, 31232, 58560, 46080, 23040}));
}

TEST(TreeModel, VariantsDifferInShapeButNotInCounts) {
    const TreeModel a = makeTreeModel({}, 0), b = makeTreeModel({}, 1);
    EXPECT_NE(fingerprint(a.skeleton.points), fingerprint(b.skeleton.points));
    EXPECT_NE(a.leaves[0].orientation, b.leaves[0].orientation);
    EXPECT_EQ(values(countTree(a)), values(countTree(b)));
}

TEST(TreeModel, AVariantIsAnOffsetOfBothSeeds) {
    TreeParameters p;
    p.wood.seed = p.leaves.seed = 8;
    const TreeModel a = makeTreeModel({}, 7), b = makeTreeModel(p, 0);
    EXPECT_EQ(fingerprint(a.skeleton.points), fingerprint(b.skeleton.points));
    EXPECT_EQ(a.leaves.back().orientation, b.leaves.back().orientation);
}

TEST(TreeModel, CountsOfGrownTreesMatchWithoutLeaves) {
    TreeParameters p;
    p.growth.emplace().size = {6.0f, 0.2f, 4.0f};
    for (const int clusters : {0, 1000})
        for (const int firstLevel : {1, 3, 9}) {
            p.leaves.clusters = clusters;
            p.leaves.firstLevel = firstLevel;
            EXPECT_EQ(values(countTree(p)), values(countTree(makeTreeModel(p))))
                << clusters << ' ' << firstLevel;
        }
}

TEST(TreeModel, LeafCardsHaveTheGivenArea) {
    TreeParameters p;
    p.growth.emplace().size = {6.0f, 0.2f, 4.0f};
    p.leaves.clusters = 700;
    p.leaves.area = 3000.0f;
    for (const std::uint32_t variant : {0u, 1u, 5u}) {
        const TreeModel model = makeTreeModel(p, variant);
        const glm::vec3 across = model.leafMesh[1].corner - model.leafMesh[0].corner;
        const glm::vec3 along = model.leafMesh[2].corner - model.leafMesh[1].corner;
        float area = 0.0f;
        for (const LeafCluster& leaf : model.leaves)
            area += 3.0f * leaf.size * leaf.size * glm::length(glm::cross(across, along));
        const float diameter = measureTree(model).trunkDiameter;
        EXPECT_NEAR(area / (3000.0f * 0.785398f * diameter * diameter), 1.0f, 0.02f);
    }
}

TEST(TreeModel, HangingShootsKeepSizeAndArea) {
    TreeParameters p;
    p.palm.emplace();
    p.leaves.clusters = 300;
    p.leaves.inclination = 0.8f;
    for (const float area : {0.0f, 2000.0f}) {
        p.leaves.area = area;
        p.leaves.hanging = false;
        const TreeModel flat = makeTreeModel(p);
        p.leaves.hanging = true;
        const TreeModel hanging = makeTreeModel(p);
        const auto card = [](const TreeModel& model) {
            return glm::distance(model.leafMesh[0].corner, model.leafMesh[1].corner) *
                   glm::distance(model.leafMesh[0].corner, model.leafMesh[3].corner);
        };
        EXPECT_NEAR(card(hanging) / card(flat), 1.0f, 1e-4f);
        EXPECT_NE(hanging.leafMesh[2].corner, flat.leafMesh[2].corner);
        for (std::size_t side = 0; side < 5; ++side)
            EXPECT_EQ(hanging.extents.sides[side].leaves, flat.extents.sides[side].leaves) << side;
    }
}

/// Expects another shared model when any word of the parameters changes.
/// @param part of parameters().
template <typename Part, typename Parameters>
void expectEachWordCounts(const Parameters& parameters, Part part) {
    const TreeParameters usual = parameters();
    const auto model = sharedTreeModel(usual);
    EXPECT_EQ(sharedTreeModel(usual), model);
    using Struct = std::remove_reference_t<decltype(part(std::declval<TreeParameters&>()))>;
    for (std::size_t word = 0; word < sizeof(Struct) / 4; ++word) {
        TreeParameters other = parameters();
        reinterpret_cast<unsigned char*>(&part(other))[4 * word] ^= 1u;
        EXPECT_NE(sharedTreeModel(other), model) << "word " << word;
    }
}

TEST(TreeModel, IsSharedForEqualParameters) {
    const auto model = sharedTreeModel({}), again = sharedTreeModel({}), variant = sharedTreeModel({}, 1);
    EXPECT_EQ(model, again);
    EXPECT_NE(model, variant);
    EXPECT_NE(model->identity, 0u);
    EXPECT_NE(model->identity, variant->identity);
    EXPECT_EQ(makeTreeModel({}).identity, 0u);
    EXPECT_EQ(model->skeleton.points, makeTreeModel({}).skeleton.points);
    EXPECT_EQ(values(countTree(TreeParameters())), values(countTree(*model)));
}

TEST(TreeModel, IsGrownAgainAfterTheLastUse) {
    const std::uint64_t before = sharedTreeModel({})->identity;
    EXPECT_NE(sharedTreeModel({})->identity, before);
}

TEST(TreeModel, EveryParameterMakesADifferentSharedModel) {
    const auto small = [] {
        TreeParameters parameters;
        parameters.wood.levels = 1;
        return parameters;
    };
    expectEachWordCounts<>(
        small, [](TreeParameters & p) -> auto& { return p.wood; });
    expectEachWordCounts<>(
        small, [](TreeParameters & p) -> auto& { return p.leaves; });
    TreeParameters hanging = small();
    hanging.leaves.hanging = !hanging.leaves.hanging; // shares its word with `frond`
    EXPECT_NE(sharedTreeModel(hanging), sharedTreeModel(small()));
    const auto palm = [&] {
        TreeParameters parameters = small();
        parameters.palm.emplace().fronds = 2;
        return parameters;
    };
    expectEachWordCounts<>(
        palm, [](TreeParameters & p) -> auto& { return *p.palm; });
}

TEST(TreeModel, ScansAreDistinguishedByTheirContents) {
    const auto scanned = [](double height) {
        TreeParameters parameters;
        const ScanCylinders pole = {{glm::dvec3(0.0), glm::dvec3(0.0, 0.0, height), 0.1, -1, 0}};
        parameters.scans = std::make_shared<const std::vector<ScannedTree>>(
            std::vector<ScannedTree>{makeScannedTree(pole).value()});
        return parameters;
    };
    const auto model = sharedTreeModel(scanned(5.0));
    EXPECT_EQ(sharedTreeModel(scanned(5.0)), model);
    EXPECT_NE(sharedTreeModel(scanned(6.0)), model);
}

} // namespace
} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/model/ModelTestCases.h>

#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>

#include <fstream>
#include <sstream>

namespace osgTreeWind {
namespace {

/// Fits, measures, and expects every given size within 2 %.
void expectFits(const TreeModel& model, const TreeSize& wanted, const std::string& what) {
    const TreeSize size = measureTree(model, fitTree(model, wanted));
    if (wanted.height > 0.0f) {
        EXPECT_NEAR(size.height / wanted.height, 1.0f, 0.02f) << what << ": height " << wanted.height;
    }
    if (wanted.trunkDiameter > 0.0f) {
        EXPECT_NEAR(size.trunkDiameter / wanted.trunkDiameter, 1.0f, 0.02f)
            << what << ": trunk " << wanted.trunkDiameter;
    }
    if (wanted.crownWidth > 0.0f) {
        EXPECT_NEAR(size.crownWidth / wanted.crownWidth, 1.0f, 0.02f)
            << what << ": crown " << wanted.crownWidth;
    }
}

TreeParameters pole(float length, float radius, float taper) {
    TreeParameters p;
    p.wood = regularTree();
    p.wood.levels = 0;
    p.wood.length = length;
    p.wood.radius = radius;
    p.wood.taper = taper;
    return p;
}

TEST(TreeSize, OfAPoleIsThatOfItsCylinder) {
    const TreeParameters p = pole(3.0f, 0.25f, 1.0f);
    const TreeSize size = measureTree(makeTreeModel(p));
    EXPECT_NEAR(size.height, 6.0f, 1e-5f);
    EXPECT_NEAR(size.trunkDiameter, 0.5f, 1e-5f);
    EXPECT_NEAR(size.crownWidth, 0.5f, 1e-5f);
}

TEST(TreeSize, TrunkIsMeasuredAtBreastHeight) {
    TreeParameters p = pole(26.0f, 0.4f, 0.5f); // breast height is a twentieth of the height
    p.wood.trunkUnits = 1;
    EXPECT_NEAR(measureTree(makeTreeModel(p)).trunkDiameter, 0.8f * (1.0f - 0.5f / 20.0f), 1e-5f);
    p.wood.length = 5.0f; // a tenth of the height
    EXPECT_NEAR(measureTree(makeTreeModel(p)).trunkDiameter, 0.8f * (1.0f - 0.5f / 10.0f), 1e-5f);
}

/// The size of a model, measured from all of its vertices.
TreeSize measureEveryVertex(const TreeModel& model, const TreeScale& scale) {
    glm::vec3 low{0.0f}, high{0.0f};
    const auto add = [&](const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    };
    for (const SkinVertex& v : model.skin().vertices)
        add(scale.axes * v.centre + scale.radius * v.radius * v.outward);
    for (const LeafCluster& leaf : model.leaves)
        for (const LeafVertex& v : model.leafMesh)
            add(scale.axes * leaf.anchor + leaf.orientation * (scale.leaf * leaf.size * v.corner));
    return {high.z, 0.0f, 0.5f * (high.x - low.x + high.y - low.y)};
}

TEST(TreeSize, IncludesEveryLeafAndEveryBranch) {
    TreeParameters bare, poplar, shrub, conifer, pole;
    bare.leaves.clustersPerBranch = 0;
    poplar.wood.inclination = 0.15f;
    poplar.leaves.length = 2.0f;
    shrub.wood.levels = 2;
    shrub.wood.childrenPerBranch = 6;
    shrub.wood.trunkUnits = 1;
    shrub.wood.inclination = 1.4f;
    conifer.wood.trunkUnits = 12;
    conifer.wood.levels = 2;
    conifer.wood.leader = 0.5f;
    pole.wood.levels = 0;
    std::vector<TreeModel> models;
    for (const TreeParameters& p : {TreeParameters(), bare, poplar, shrub, conifer, pole})
        for (const std::uint32_t variant : {0u, 7u})
            models.push_back(makeTreeModel(p, variant));
    for (const TreeModel& model : models)
        for (const float across : {0.02f, 0.3f, 1.0f, 4.0f})
            for (const float up : {0.05f, 1.0f, 30.0f})
                for (const float radius : {0.01f, 1.0f, 5.0f, 300.0f})
                    for (const float leaf : {0.01f, 0.9f, 60.0f}) {
                        const TreeScale scale{{across, 1.1f * across, up}, radius, leaf};
                        const TreeSize size = measureTree(model, scale);
                        const TreeSize expected = measureEveryVertex(model, scale);
                        EXPECT_NEAR(size.height, expected.height, 1e-6f * expected.height);
                        EXPECT_NEAR(size.crownWidth, expected.crownWidth, 1e-6f * expected.crownWidth);
                    }
}

TEST(TreeSize, IsMeasuredFromFewVertices) {
    for (const TreeExtents::Side& side : makeTreeModel({}).extents.sides) {
        EXPECT_GT(side.wood.size(), 1u);
        EXPECT_LT(side.wood.size(), 64u);
        EXPECT_GT(side.leaves.size(), 1u);
        EXPECT_LT(side.leaves.size(), 64u);
    }
}

TEST(TreeSize, WithoutAnySizeTheScaleIsOne) {
    const TreeModel model = makeTreeModel({});
    const float nan = std::nanf("");
    for (const TreeSize& nothing : {TreeSize{}, TreeSize{-1.0f, -2.0f, -3.0f}, TreeSize{nan, nan, nan}}) {
        const TreeScale scale = fitTree(model, nothing);
        EXPECT_EQ(scale.axes, glm::vec3(1.0f));
        EXPECT_EQ(scale.radius, 1.0f);
        EXPECT_EQ(scale.leaf, 1.0f);
    }
}

TEST(TreeSize, HeightAloneKeepsTheProportions) {
    const TreeModel model = makeTreeModel({});
    const TreeSize rest = measureTree(model);
    const TreeScale scale = fitTree(model, {2.0f * rest.height, 0.0f, 0.0f});
    EXPECT_NEAR(scale.axes.x, 2.0f, 0.01f);
    EXPECT_EQ(scale.axes.x, scale.axes.y);
    EXPECT_EQ(scale.axes.x, scale.axes.z);
    EXPECT_EQ(scale.radius, scale.axes.z);
}

TEST(TreeSize, FitsMeasuredTreesWithinTwoPercent) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const TreeModel model = makeTreeModel({}, seed);
        for (const float height : {1.0f, 2.0f, 5.0f, 13.0f, 30.0f, 60.0f})
            for (const float slenderness : {0.005f, 0.02f, 0.09f})
                for (const float spread : {0.25f, 0.7f, 2.0f}) {
                    const float trunk = slenderness * height, crown = spread * height;
                    expectFits(model, {height, trunk, crown}, "all given");
                    expectFits(model, {height, trunk, 0.0f}, "no crown");
                    expectFits(model, {height, 0.0f, crown}, "no trunk");
                    expectFits(model, {0.0f, trunk, crown}, "no height");
                }
    }
}

TEST(TreeSize, FitsOtherShapes) {
    TreeParameters bare, poplar, shrub;
    bare.leaves.clustersPerBranch = 0;
    poplar.wood.inclination = 0.15f;
    shrub.wood.levels = 2;
    shrub.wood.childrenPerBranch = 6;
    shrub.wood.trunkUnits = 1;
    shrub.wood.inclination = 1.4f;
    for (const TreeParameters& p : {bare, poplar, shrub})
        expectFits(makeTreeModel(p), {12.0f, 0.3f, 8.0f}, "other shape");
}

TEST(TreeSize, ImpossibleSizesStayFinite) {
    TreeParameters pole;
    pole.wood.levels = 0;
    const float inf = std::numeric_limits<float>::infinity();
    for (const TreeModel& model : {makeTreeModel({}), makeTreeModel(pole)})
        for (const float value : {1e-30f, 1e-3f, 1e30f, inf, -inf})
            for (const TreeSize& size : {TreeSize{value, value, value}, TreeSize{10.0f, 0.3f, value},
                                         TreeSize{value, 0.3f, 8.0f}, TreeSize{10.0f, value, 8.0f}}) {
                const TreeScale scale = fitTree(model, size);
                for (const float part :
                     {scale.axes.x, scale.axes.y, scale.axes.z, scale.radius, scale.leaf}) {
                    EXPECT_TRUE(std::isfinite(part)) << value;
                    EXPECT_GT(part, 0.0f) << value;
                }
            }
}

TEST(TreeSize, FitsEveryTreeOfTheUtahCampus) {
    REQUIRE_REAL_DATA(path, "utah_campus/utah_campus_trees.csv");
    const TreeModel model = makeTreeModel({});
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    ASSERT_EQ(line.rfind("x,y,dbh,crown_d,H,", 0), 0u);
    int trees = 0;
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        double x = 0, y = 0;
        TreeSize size;
        char comma = 0;
        cells >> x >> comma >> y >> comma >> size.trunkDiameter >> comma >> size.crownWidth >> comma >>
            size.height;
        ASSERT_TRUE(cells) << line;
        ++trees;
        expectFits(model, size, "tree " + std::to_string(trees));
    }
    EXPECT_EQ(trees, 1233);
}

} // namespace
} // namespace osgTreeWind

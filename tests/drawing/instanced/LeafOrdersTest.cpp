// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/LeafOrders.h>

#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/model/TreeModel.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace osgTreeWind;

namespace {

/// Middles and first vertices of the quads in draw order.
struct Drawn {
    std::vector<glm::vec3> middles;
    std::vector<unsigned> vertices;

    Drawn(const osg::Geometry& geometry, const ThinnedLeaves& leaves, const TreeModel& model) {
        const osg::PrimitiveSet& triangles = *geometry.getPrimitiveSet(0);
        const auto quads = static_cast<unsigned>(leaves.quads());
        for (unsigned i = 0; i < triangles.getNumIndices(); i += 6) {
            vertices.push_back(triangles.index(i));
            const std::size_t cluster = vertices.back() / (4 * quads);
            const int quad = leaves.firstQuad(cluster) + static_cast<int>(vertices.back() / 4 % quads);
            const LeafCluster& leaf = leaves.clusters[cluster];
            middles.push_back(leaf.anchor +
                              leaf.size * (leaf.orientation * middleOf(model.leafMesh, quad, 1)));
        }
    }
};

} // namespace

TEST(LeafOrdersTest, NearCardsComeFirstAndAllAreDrawn) {
    const TreeModel model = makeTreeModel({});
    for (const int reductions : {0, 2}) {
        const ThinnedLeaves leaves =
            thinnedLeaves(model.leaves, model.leafMesh, TreeDetail::reduced(reductions));
        const osg::ref_ptr<osg::Geometry> geometry =
            makeLeafGeometry(leaves, model.skeleton, model.leafMesh, CrownShade());
        const LeafOrders::Geometries orders = LeafOrders::make(*geometry, leaves, model.leafMesh);
        std::vector<unsigned> all = Drawn(*geometry, leaves, model).vertices;
        std::sort(all.begin(), all.end());
        for (std::size_t order = 0; order < LeafOrders::count; ++order) {
            ASSERT_EQ(orders[order]->getVertexArray(), geometry->getVertexArray())
                << "orders share their vertices";
            Drawn drawn(*orders[order], leaves, model);
            std::vector<float> along;
            for (const glm::vec3& middle : drawn.middles)
                along.push_back(glm::dot(middle, LeafOrders::directions()[order]));
            const auto [low, high] = std::minmax_element(along.begin(), along.end());
            const float slab = 0.126f * (*high - *low);
            for (std::size_t i = 1; i < along.size(); ++i)
                ASSERT_LT(along[i], along[i - 1] + slab) << order;
            std::sort(drawn.vertices.begin(), drawn.vertices.end());
            ASSERT_EQ(drawn.vertices, all) << order;
        }
    }
}

TEST(LeafOrdersTest, FindsTheNearestDirection) {
    for (std::size_t order = 0; order < LeafOrders::count; ++order) {
        const glm::vec3& direction = LeafOrders::directions()[order];
        EXPECT_NEAR(glm::length(direction), 1.0f, 1e-6f);
        EXPECT_EQ(LeafOrders::nearest(30.0f * direction + glm::vec3(1.0f, -2.0f, 3.0f)), order);
    }
}

TEST(LeafOrdersTest, BareTreeHasNoIndices) {
    const TreeModel model = makeTreeModel({});
    const ThinnedLeaves none = thinnedLeaves({}, model.leafMesh, TreeDetail::full());
    const osg::ref_ptr<osg::Geometry> geometry =
        makeLeafGeometry(none, model.skeleton, model.leafMesh, CrownShade());
    for (const osg::ref_ptr<osg::Geometry>& order : LeafOrders::make(*geometry, none, model.leafMesh))
        EXPECT_EQ(order->getPrimitiveSet(0)->getNumIndices(), 0u);
}

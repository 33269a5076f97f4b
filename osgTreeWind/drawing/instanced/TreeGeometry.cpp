// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>

#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <numeric>

namespace osgTreeWind {
namespace {

osg::ref_ptr<osg::Geometry> emptyGeometry(const char* name) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName(name);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    return geometry;
}

/// As shaders/law/shade.glsl unpacks them.
glm::vec2 packed(const CrownShade::Light& light) {
    return {Laws().packedShares({light.above, light.sky}), Laws().packedShares({light.below, 1.0f})};
}

} // namespace

osg::ref_ptr<osg::Geometry> makeSkinGeometry(const BranchSkin& skin, const CrownShade& crown) {
    osg::ref_ptr<osg::Vec4Array> centres = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> outwards = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> coordinates = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> shades = new osg::Vec2Array;
    glm::vec3 centre(0.0f);
    glm::vec2 shade(0.0f);
    for (const SkinVertex& v : skin.vertices) {
        if (v.centre != centre || shades->empty()) { // that of a ring
            centre = v.centre;
            shade = packed(crown.at(centre));
        }
        shades->push_back({shade.x, shade.y});
        centres->push_back({v.centre.x, v.centre.y, v.centre.z, v.radius});
        outwards->push_back({v.outward.x, v.outward.y, v.outward.z});
        coordinates->push_back({v.uv.x, v.uv.y, v.unit});
    }
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry("bark");
    geometry->setVertexArray(centres);
    geometry->setNormalArray(outwards, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, coordinates);
    geometry->setTexCoordArray(1, shades);
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(
        GL_TRIANGLES, static_cast<unsigned>(skin.indices.size()), skin.indices.data()));
    makeArraysDistinct(*geometry);
    return geometry;
}

osg::ref_ptr<osg::Geometry> makeLeafGeometry(const std::vector<LeafCluster>& leaves,
                                             const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                             const CrownShade& crown) {
    return makeLeafGeometry(thinnedLeaves(leaves, mesh, TreeDetail::full()), mesh, crown);
}

osg::ref_ptr<osg::Geometry> makeLeafGeometry(const ThinnedLeaves& leaves,
                                             const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                             const CrownShade& crown) {
    const auto cornerCount = static_cast<std::size_t>(4 * leaves.quads());
    osg::ref_ptr<osg::Vec4Array> anchors = new osg::Vec4Array, ids = new osg::Vec4Array,
                                 orientations = new osg::Vec4Array, normals = new osg::Vec4Array,
                                 crowns = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (std::size_t i = 0; i < leaves.clusters.size(); ++i) {
        const LeafCluster& leaf = leaves.clusters[i];
        const std::uint32_t index = leaves.indices[i];
        const int quad = leaves.firstQuad(i);
        const glm::vec3 outward = crown.outward(leaf.anchor), middle = middleOf(mesh, quad, leaves.quads());
        const glm::vec2 shade = packed(crown.at(leaf.anchor + leaf.size * (leaf.orientation * middle)));
        for (std::size_t corner = 0; corner < cornerCount; ++corner) {
            const LeafVertex& v = mesh[static_cast<std::size_t>(4 * quad) + corner];
            anchors->push_back({leaf.anchor.x, leaf.anchor.y, leaf.anchor.z, leaf.size});
            corners->push_back(toOsg(v.corner));
            const glm::vec2 uv = leaves.bough > 1 ? LeafAtlas::onBough(leaves.bough, index, v.uv)
                                                  : LeafAtlas::coordinate(index, corner / 4, v.uv);
            ids->push_back({uv.x, uv.y, static_cast<float>(leaf.unit), static_cast<float>(index)});
            orientations->push_back(toOsg(leaf.orientation).asVec4());
            normals->push_back({v.normal.x, v.normal.y, v.normal.z, shade.x});
            crowns->push_back({outward.x, outward.y, outward.z, shade.y});
        }
    }
    const std::vector<unsigned> indices = leafIndices(leaves.clusters.size(), leaves.quads());
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry("leaves");
    geometry->setVertexArray(anchors);
    geometry->setNormalArray(corners, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, ids);
    geometry->setTexCoordArray(1, orientations);
    geometry->setTexCoordArray(2, normals);
    geometry->setTexCoordArray(3, crowns);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(indices.size()), indices.data()));
    makeArraysDistinct(*geometry);
    return geometry;
}

std::vector<unsigned> leafIndices(std::size_t clusters, int quads) {
    std::vector<unsigned> all(clusters * static_cast<std::size_t>(quads));
    std::iota(all.begin(), all.end(), 0u);
    return leafIndices(all);
}

std::vector<unsigned> leafIndices(const std::vector<unsigned>& quads) {
    std::vector<unsigned> indices;
    indices.reserve(quads.size() * 6);
    for (const unsigned quad : quads)
        for (const unsigned corner : {0u, 1u, 2u, 0u, 2u, 3u})
            indices.push_back(4 * quad + corner);
    return indices;
}

} // namespace osgTreeWind

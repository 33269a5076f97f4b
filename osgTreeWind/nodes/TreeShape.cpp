// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeShape.h>

#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/model/CrownEllipsoid.h>

namespace osgTreeWind {
namespace {

osg::ref_ptr<osg::Geometry> emptyGeometry(const char* name) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName(name);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    return geometry;
}

osg::ref_ptr<osg::Geometry> skinGeometry(const BranchSkin& skin) {
    osg::ref_ptr<osg::Vec4Array> centres = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> outwards = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> coordinates = new osg::Vec3Array;
    for (const SkinVertex& v : skin.vertices) {
        centres->push_back({v.centre.x, v.centre.y, v.centre.z, v.radius});
        outwards->push_back({v.outward.x, v.outward.y, v.outward.z});
        coordinates->push_back({v.uv.x, v.uv.y, v.unit});
    }
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry("bark");
    geometry->setVertexArray(centres);
    geometry->setNormalArray(outwards, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, coordinates);
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(
        GL_TRIANGLES, static_cast<unsigned>(skin.indices.size()), skin.indices.data()));
    makeArraysDistinct(*geometry);
    return geometry;
}

/// Vertex arrays of shaders/leaf.vert under construction.
class LeafArrays {
public:
    void add(const LeafCluster& leaf, float index, const glm::vec4& crown,
             const std::array<LeafVertex, verticesPerLeafCluster>& mesh) {
        for (const LeafVertex& v : mesh) {
            _anchors->push_back({leaf.anchor.x, leaf.anchor.y, leaf.anchor.z, leaf.size});
            _corners->push_back(toOsg(v.corner));
            _ids->push_back({v.uv.x, v.uv.y, static_cast<float>(leaf.unit), index});
            _orientations->push_back(toOsg(leaf.orientation).asVec4());
            _normals->push_back(toOsg(v.normal));
            _crowns->push_back({crown.x, crown.y, crown.z, crown.w});
        }
    }

    osg::ref_ptr<osg::Geometry> geometry(const char* name) const {
        const std::vector<unsigned> indices = leafIndices(_anchors->size() / verticesPerLeafCluster);
        osg::ref_ptr<osg::Geometry> geometry = emptyGeometry(name);
        geometry->setVertexArray(_anchors);
        geometry->setNormalArray(_corners, osg::Array::BIND_PER_VERTEX);
        geometry->setTexCoordArray(0, _ids);
        geometry->setTexCoordArray(1, _orientations);
        geometry->setTexCoordArray(2, _normals);
        geometry->setTexCoordArray(3, _crowns);
        geometry->addPrimitiveSet(
            new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(indices.size()), indices.data()));
        makeArraysDistinct(*geometry);
        return geometry;
    }

private:
    osg::ref_ptr<osg::Vec4Array> _anchors = new osg::Vec4Array, _ids = new osg::Vec4Array,
                                 _orientations = new osg::Vec4Array, _crowns = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> _corners = new osg::Vec3Array, _normals = new osg::Vec3Array;
};

osg::ref_ptr<osg::Geometry> leafGeometry(const TreeModel& model) {
    const CrownEllipsoid crown(model.leaves);
    LeafArrays arrays;
    float index = 0.0f;
    for (const LeafCluster& leaf : model.leaves)
        arrays.add(leaf, index++, crown.at(leaf.anchor), model.leafMesh);
    return arrays.geometry("leaves");
}

osg::ref_ptr<osg::Geometry> clusterGeometry(const TreeModel& model) {
    LeafArrays arrays;
    arrays.add(LeafCluster(), 0.0f, {0.0f, 0.0f, 1.0f, 1.0f}, model.leafMesh);
    // Its vertex array holds anchors, which are all the origin: bounds come from the corners.
    osg::BoundingBox box;
    for (const LeafVertex& vertex : model.leafMesh)
        box.expandBy(toOsg(vertex.corner));
    osg::ref_ptr<osg::Geometry> cluster = arrays.geometry("leaf cluster");
    struct Box : osg::Drawable::ComputeBoundingBoxCallback {
        explicit Box(const osg::BoundingBox& corners) : box(corners) {}
        osg::BoundingBox computeBound(const osg::Drawable&) const override { return box; }
        osg::BoundingBox box;
    };
    cluster->setComputeBoundingBoxCallback(new Box(box));
    return cluster;
}

} // namespace

TreeShape::TreeShape(std::shared_ptr<const TreeModel> model)
    : _model(std::move(model)), _skin(skinGeometry(_model->skin)), _leaves(leafGeometry(*_model)),
      _leafCluster(clusterGeometry(*_model)), _unitSkins(_model->skeleton.units.size()) {}

osg::Geometry* TreeShape::unitSkin(unsigned unit) {
    if (!_unitSkins[unit]) {
        const std::size_t count = _model->skin.indicesPerUnit;
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(*_skin);
        geometry->setPrimitiveSet(0, new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(count),
                                                               &_model->skin.indices[unit * count]));
        _unitSkins[unit] = geometry;
    }
    return _unitSkins[unit].get();
}

std::vector<unsigned> leafIndices(std::size_t clusters) {
    std::vector<unsigned> indices;
    indices.reserve(clusters * quadsPerLeafCluster * 6);
    for (unsigned quad = 0; quad < clusters * quadsPerLeafCluster; ++quad)
        for (const unsigned corner : {0u, 1u, 2u, 0u, 2u, 3u})
            indices.push_back(4 * quad + corner);
    return indices;
}

} // namespace osgTreeWind

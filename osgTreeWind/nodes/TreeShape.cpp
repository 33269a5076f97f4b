// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeShape.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

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
    return geometry;
}

/// The ellipsoid the leaves fill: outward directions and depths in it shade the crown.
struct Crown {
    explicit Crown(const std::vector<LeafCluster>& leaves) {
        glm::vec3 low(1e9f), high(-1e9f);
        for (const LeafCluster& leaf : leaves) {
            low = glm::min(low, leaf.anchor);
            high = glm::max(high, leaf.anchor);
        }
        centre = 0.5f * (low + high);
        halfAxes = glm::max(0.5f * (high - low), glm::vec3(1e-3f));
    }
    osg::Vec4 at(const glm::vec3& point) const {
        const glm::vec3 inside = (point - centre) / halfAxes;
        const glm::vec3 gradient = inside / halfAxes + glm::vec3(0, 0, 1e-3f);
        const glm::vec3 outward = glm::normalize(gradient);
        return {outward.x, outward.y, outward.z, glm::min(glm::length(inside), 1.0f)};
    }
    glm::vec3 centre, halfAxes;
};

osg::ref_ptr<osg::Geometry> leafGeometry(const TreeModel& model) {
    osg::ref_ptr<osg::Vec4Array> anchors = new osg::Vec4Array, ids = new osg::Vec4Array,
                                 orientations = new osg::Vec4Array, crowns = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array, normals = new osg::Vec3Array;
    const Crown crown(model.leaves);
    float index = 0.0f;
    for (const LeafCluster& leaf : model.leaves) {
        const osg::Vec4 place = crown.at(leaf.anchor);
        for (const LeafVertex& v : model.leafMesh) {
            anchors->push_back({leaf.anchor.x, leaf.anchor.y, leaf.anchor.z, leaf.size});
            corners->push_back({v.corner.x, v.corner.y, v.corner.z});
            ids->push_back({v.uv.x, v.uv.y, static_cast<float>(leaf.unit), index});
            orientations->push_back(
                {leaf.orientation.x, leaf.orientation.y, leaf.orientation.z, leaf.orientation.w});
            normals->push_back({v.normal.x, v.normal.y, v.normal.z});
            crowns->push_back(place);
        }
        index += 1.0f;
    }
    const std::vector<unsigned> indices = leafIndices(model.leaves.size());
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry("leaves");
    geometry->setVertexArray(anchors);
    geometry->setNormalArray(corners, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, ids);
    geometry->setTexCoordArray(1, orientations);
    geometry->setTexCoordArray(2, normals);
    geometry->setTexCoordArray(3, crowns);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(indices.size()), indices.data()));
    return geometry;
}

} // namespace

TreeShape::TreeShape(std::shared_ptr<const TreeModel> model)
    : _model(std::move(model)), _skin(skinGeometry(_model->skin)), _leaves(leafGeometry(*_model)),
      _unitSkins(_model->skeleton.units.size()) {}

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

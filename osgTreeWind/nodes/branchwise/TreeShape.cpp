// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/branchwise/TreeShape.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/nodes/TreeGeometry.h>

namespace osgTreeWind {
namespace {

osg::ref_ptr<osg::Geometry> clusterGeometry(const TreeModel& model) {
    const std::vector<LeafCluster> one(1);
    CrownEllipsoid below(one); // at its very top
    below.centre = {0.0f, 0.0f, -1.0f};
    below.halfAxes = glm::vec3(1.0f);
    osg::ref_ptr<osg::Geometry> cluster = makeLeafGeometry(one, model.leafMesh, below);
    cluster->setName("leaf cluster");
    // Its vertex array holds anchors, which are all the origin: bounds come from the corners.
    osg::BoundingBox box;
    for (const LeafVertex& vertex : model.leafMesh)
        box.expandBy(toOsg(vertex.corner));
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
    : _model(std::move(model)), _skin(makeSkinGeometry(_model->skin)),
      _leaves(makeLeafGeometry(_model->leaves, _model->leafMesh, CrownEllipsoid(_model->leaves))),
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

std::vector<osg::Geometry*> TreeShape::geometries() const {
    std::vector<osg::Geometry*> all = {_skin, _leaves, _leafCluster};
    for (const osg::ref_ptr<osg::Geometry>& unit : _unitSkins)
        if (unit)
            all.push_back(unit);
    return all;
}

void TreeShape::resizeGLObjectBuffers(unsigned maxSize) {
    for (osg::Geometry* geometry : geometries())
        geometry->resizeGLObjectBuffers(maxSize);
}

void TreeShape::releaseGLObjects(osg::State* state) const {
    for (const osg::Geometry* geometry : geometries())
        geometry->releaseGLObjects(state);
}

} // namespace osgTreeWind

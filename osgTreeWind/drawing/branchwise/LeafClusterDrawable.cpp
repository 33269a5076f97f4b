// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/LeafClusterDrawable.h>

#include <osgTreeWind/drawing/instanced/TreeGeometry.h>

namespace osgTreeWind {

namespace {

osg::ref_ptr<osg::Geometry> clusterGeometry(const TreeModel& model) {
    const std::vector<LeafCluster> one(1);
    osg::ref_ptr<osg::Geometry> cluster = makeLeafGeometry(one, model.leafMesh, CrownShade());
    cluster->setName("leaf cluster");
    return cluster;
}

} // namespace

LeafClusterDrawable::LeafClusterDrawable(const TreeModel& model)
    : TreeDrawable(clusterGeometry(model), nullptr) {
    for (const LeafVertex& vertex : model.leafMesh)
        _corners.push_back(toOsg(vertex.corner));
}

osg::BoundingBox LeafClusterDrawable::computeBoundingBox() const {
    osg::BoundingBox box;
    for (const osg::Vec3& corner : _corners)
        box.expandBy(corner);
    return box;
}

TreeDrawable::Triangles LeafClusterDrawable::posedTriangles() const {
    return {_corners, leafIndices(_corners.size() / verticesPerLeafCluster)};
}

} // namespace osgTreeWind

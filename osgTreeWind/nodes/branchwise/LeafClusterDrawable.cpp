// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/branchwise/LeafClusterDrawable.h>

#include <osgTreeWind/nodes/TreeGeometry.h>

namespace osgTreeWind {

LeafClusterDrawable::LeafClusterDrawable(const TreeModel& model)
    : TreeDrawable(makeLeafGeometry({LeafCluster()}, model.leafMesh, {{0.0f, 0.0f, 1.0f, 1.0f}}), nullptr) {
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

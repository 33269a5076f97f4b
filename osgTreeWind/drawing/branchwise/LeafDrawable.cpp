// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/LeafDrawable.h>

#include <osgTreeWind/drawing/instanced/TreeGeometry.h>

namespace osgTreeWind {

TreeDrawable::Triangles LeafDrawable::posedTriangles() const {
    Triangles triangles;
    if (!_tree)
        return triangles;
    const std::size_t leaves = _tree->model().leaves.size();
    triangles.vertices.reserve(leaves * verticesPerLeafCluster);
    glm::vec3 corners[verticesPerLeafCluster];
    for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
        _tree->leafPoints(leaf, corners);
        for (const glm::vec3& corner : corners)
            triangles.vertices.push_back(toOsg(corner));
    }
    triangles.indices = leafIndices(leaves);
    return triangles;
}

} // namespace osgTreeWind

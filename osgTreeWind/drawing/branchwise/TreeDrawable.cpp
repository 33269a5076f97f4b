// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>

#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/gpu/DrawTimer.h>

namespace osgTreeWind {

TreeDrawable::TreeDrawable(const char* className, osg::Geometry* geometry, PosedTree* tree)
    : _className(className), _geometry(geometry), _tree(tree) {
    setSupportsDisplayList(false);
    setDataVariance(osg::Object::DYNAMIC); // the poses change every frame
}

void TreeDrawable::accept(osg::PrimitiveFunctor& functor) const {
    const Triangles triangles = posedTriangles();
    if (triangles.indices.empty())
        return;
    functor.setVertexArray(static_cast<unsigned>(triangles.vertices.size()), triangles.vertices.data());
    functor.drawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.indices.size()),
                         triangles.indices.data());
}

void TreeDrawable::drawImplementation(osg::RenderInfo& renderInfo) const {
    const DrawTimer time(renderInfo, "Forest draw");
    _geometry->draw(renderInfo);
}

void TreeDrawable::compileGLObjects(osg::RenderInfo& renderInfo) const {
    _geometry->compileGLObjects(renderInfo);
}

osg::BoundingBox SkinDrawable::computeBoundingBox() const {
    if (_unit == wholeTree)
        return TreeDrawable::computeBoundingBox();
    osg::BoundingBox box;
    for (const osg::Vec3& vertex : posedTriangles().vertices)
        box.expandBy(vertex);
    return box;
}

TreeDrawable::Triangles SkinDrawable::posedTriangles() const {
    const BranchSkin& skin = _tree->model().skin();
    const bool whole = _unit == wholeTree;
    const std::size_t first = whole ? 0 : static_cast<std::size_t>(_unit);
    const std::size_t after = whole ? _tree->model().skeleton.units.size() : first + 1;
    const std::uint32_t firstVertex = skin.firstVertices[first];

    Triangles triangles;
    triangles.vertices.reserve(skin.firstVertices[after] - firstVertex);
    for (std::size_t i = firstVertex; i < skin.firstVertices[after]; ++i) {
        const SkinVertex& vertex = skin.vertices[i];
        const UnitPose pose = whole ? _tree->pose(static_cast<std::size_t>(vertex.unit)) : UnitPose();
        triangles.vertices.push_back(toOsg(_tree->skinPoint(vertex, pose)));
    }
    triangles.indices.reserve(skin.firstIndices[after] - skin.firstIndices[first]);
    for (std::size_t i = skin.firstIndices[first]; i < skin.firstIndices[after]; ++i)
        triangles.indices.push_back(skin.indices[i] - firstVertex);
    return triangles;
}

TreeDrawable::Triangles LeafDrawable::posedTriangles() const {
    const std::size_t leaves = _tree->model().leaves.size();
    Triangles triangles;
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

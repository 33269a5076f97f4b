// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/SkinDrawable.h>

namespace osgTreeWind {

SkinDrawable::SkinDrawable(osg::Geometry* geometry, PosedTree* tree, int unit)
    : TreeDrawable(geometry, tree), _unit(unit) {}

SkinDrawable::SkinDrawable(const SkinDrawable& other, const osg::CopyOp& copyop)
    : TreeDrawable(other, copyop), _unit(other._unit) {}

osg::BoundingBox SkinDrawable::computeBoundingBox() const {
    if (!_tree || _unit == wholeTree)
        return _tree ? _tree->bounds() : osg::BoundingBox();
    osg::BoundingBox box;
    for (const osg::Vec3& vertex : posedTriangles().vertices)
        box.expandBy(vertex);
    return box;
}

TreeDrawable::Triangles SkinDrawable::posedTriangles() const {
    if (!_tree)
        return {};
    const BranchSkin& skin = _tree->model().skin;
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

} // namespace osgTreeWind

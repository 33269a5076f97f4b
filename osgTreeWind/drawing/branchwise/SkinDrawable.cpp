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
    const std::size_t units = _tree->model().skeleton.units.size();
    const std::size_t perUnit = skin.vertices.size() / units;
    const bool whole = _unit == wholeTree;
    const std::size_t first = whole ? 0 : static_cast<std::size_t>(_unit), count = whole ? units : 1;

    Triangles triangles;
    triangles.vertices.reserve(count * perUnit);
    for (std::size_t unit = first; unit < first + count; ++unit) {
        const UnitPose pose = whole ? _tree->pose(unit) : UnitPose();
        for (std::size_t i = unit * perUnit; i < (unit + 1) * perUnit; ++i)
            triangles.vertices.push_back(toOsg(_tree->skinPoint(skin.vertices[i], pose)));
    }
    triangles.indices.reserve(count * skin.indicesPerUnit);
    for (std::size_t i = 0; i < count * skin.indicesPerUnit; ++i)
        triangles.indices.push_back(skin.indices[i]); // units are alike: those of unit 0 fit any one unit
    return triangles;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeBuffers.h>

#include <osgTreeWind/drawing/stand/TreeGeometry.h>
#include <osgTreeWind/species/LeafCoverage.h>

namespace osgTreeWind {
namespace {

std::vector<unsigned> unitsWithoutLeaves(const TreeModel& model) {
    std::vector<bool> leafy(model.skeleton.units.size(), false);
    for (const LeafCluster& leaf : model.leaves)
        leafy[static_cast<std::size_t>(leaf.unit)] = true;
    std::vector<unsigned> units;
    for (unsigned unit = 0; unit < leafy.size(); ++unit)
        if (!leafy[unit])
            units.push_back(unit);
    return units;
}

} // namespace

TreeBuffers::TreeBuffers(std::shared_ptr<const TreeModel> model, LeafForm leafForm)
    : _model(std::move(model)), _leafCluster(new LeafClusterDrawable(*_model)),
      _unitSkins(_model->skeleton.units.size()) {
    const CrownShade crown(_model->leaves, _model->leafMesh, leafCoverage(leafForm));
    _skin = makeSkinGeometry(_model->skin, crown);
    _leaves = makeLeafGeometry(_model->leaves, _model->leafMesh, crown);
    _bareSkin = skinOf(unitsWithoutLeaves(*_model));
}

osg::ref_ptr<osg::Geometry> TreeBuffers::skinOf(const std::vector<unsigned>& units) const {
    const BranchSkin& skin = _model->skin;
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (const unsigned unit : units)
        triangles->insert(triangles->end(), skin.indices.begin() + skin.firstIndices[unit],
                          skin.indices.begin() + skin.firstIndices[unit + 1]);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(*_skin);
    geometry->setPrimitiveSet(0, triangles);
    return geometry;
}

osg::Geometry* TreeBuffers::unitSkin(unsigned unit) {
    if (!_unitSkins[unit])
        _unitSkins[unit] = skinOf({unit});
    return _unitSkins[unit].get();
}

std::vector<osg::Geometry*> TreeBuffers::geometries() const {
    std::vector<osg::Geometry*> all = {_skin, _bareSkin, _leaves, _leafCluster->geometry()};
    for (const osg::ref_ptr<osg::Geometry>& unit : _unitSkins)
        if (unit)
            all.push_back(unit);
    return all;
}

void TreeBuffers::resizeGLObjectBuffers(unsigned maxSize) {
    for (osg::Geometry* geometry : geometries())
        geometry->resizeGLObjectBuffers(maxSize);
}

void TreeBuffers::releaseGLObjects(osg::State* state) const {
    for (const osg::Geometry* geometry : geometries())
        geometry->releaseGLObjects(state);
}

} // namespace osgTreeWind

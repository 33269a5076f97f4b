// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeBuffers.h>

#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/gpu/SharedObjects.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <utility>

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

/// The bark of some units, with the vertex buffer of the whole bark.
osg::ref_ptr<osg::Geometry> skinOf(const std::vector<unsigned>& units, const BranchSkin& skin,
                                   const osg::Geometry& whole) {
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (const unsigned unit : units)
        triangles->insert(triangles->end(), skin.indices.begin() + skin.firstIndices[unit],
                          skin.indices.begin() + skin.firstIndices[unit + 1]);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(whole);
    geometry->setPrimitiveSet(0, triangles);
    return geometry;
}

/// One leaf cluster of size 1 in the leaf frame, below the transforms of all clusters of a model: the display
/// list of the thesis (§2.4.1).
class LeafClusterDrawable : public TreeDrawable {
public:
    explicit LeafClusterDrawable(const TreeModel& model)
        : TreeDrawable(
              "LeafClusterDrawable",
              makeLeafGeometry(std::vector<LeafCluster>(1), Skeleton(), model.leafMesh, CrownShade()),
              nullptr) {
        _geometry->setName("leaf cluster");
        for (const LeafVertex& vertex : model.leafMesh)
            _corners.push_back(toOsg(vertex.corner));
    }
    osg::BoundingBox computeBoundingBox() const override {
        osg::BoundingBox box;
        for (const osg::Vec3& corner : _corners)
            box.expandBy(corner);
        return box;
    }

protected:
    Triangles posedTriangles() const override {
        return {_corners, leafIndices(_corners.size() / verticesPerLeafCluster)};
    }

private:
    std::vector<osg::Vec3> _corners;
};

} // namespace

TreeBuffers::Meshes::Meshes(const TreeModel& model, LeafForm leafForm) {
    const CrownShade crown(model.leaves, model.leafMesh, leafCoverage(leafForm));
    skin = makeSkinGeometry(model.skin(), model.skeleton, crown);
    bareSkin = skinOf(unitsWithoutLeaves(model), model.skin(), *skin);
    leaves = makeLeafGeometry(model.leaves, model.skeleton, model.leafMesh, crown);
}

osg::ref_ptr<TreeBuffers::Meshes> TreeBuffers::sharedMeshes(const TreeModel& model, LeafForm leafForm) {
    static SharedObjects<std::pair<std::uint64_t, LeafForm>, Meshes> meshes;
    const auto make = [&] { return osg::ref_ptr<Meshes>(new Meshes(model, leafForm)); };
    return model.identity == 0 ? make() : meshes.get({model.identity, leafForm}, make);
}

TreeBuffers::TreeBuffers(std::shared_ptr<const TreeModel> model, LeafForm leafForm)
    : _model(std::move(model)), _meshes(sharedMeshes(*_model, leafForm)),
      _leafCluster(new LeafClusterDrawable(*_model)), _unitSkins(_model->skeleton.units.size()) {}

osg::Geometry* TreeBuffers::unitSkin(unsigned unit) {
    if (!_unitSkins[unit])
        _unitSkins[unit] = skinOf({unit}, _model->skin(), *skin());
    return _unitSkins[unit].get();
}

std::vector<osg::Geometry*> TreeBuffers::geometries() const {
    std::vector<osg::Geometry*> all = {skin(), bareSkin(), leaves(), _leafCluster->geometry()};
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

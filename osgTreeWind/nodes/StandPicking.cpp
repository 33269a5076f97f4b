// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/StandPicking.h>

#include <osgTreeWind/nodes/PickedTree.h>

namespace osgTreeWind {
namespace {

/// Something with bounds that an intersector can be asked about.
class Bounds : public osg::Node {
public:
    void set(const osg::BoundingBox& box) {
        _sphere = osg::BoundingSphere(box);
        dirtyBound();
    }
    osg::BoundingSphere computeBound() const override { return _sphere; }

private:
    osg::BoundingSphere _sphere;
};

} // namespace

void intersectTrees(osgUtil::IntersectionVisitor& visitor, const ForestSimulation& simulation,
                    const TreeCells& cells) {
    if (!visitor.getIntersector())
        return;
    const osg::ref_ptr<Bounds> bounds = new Bounds;
    const auto mayHit = [&](const osg::BoundingBox& box) {
        bounds->set(box);
        return visitor.getIntersector()->enter(*bounds);
    };
    for (const TreeCells::Cell& cell : cells.cells()) {
        if (cell.trees.empty() || !mayHit(cell.box))
            continue;
        for (const TreeCells::Tree& tree : cell.trees)
            if (mayHit(TreeCells::boxOf(tree))) {
                const osg::ref_ptr<PickedTree> picked = new PickedTree(simulation, tree.number);
                picked->accept(visitor);
            }
    }
}

} // namespace osgTreeWind

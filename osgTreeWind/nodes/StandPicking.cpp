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
    const auto within = [&](const osg::BoundingBox& box, const auto& meet) {
        bounds->set(box);
        if (!visitor.getIntersector()->enter(*bounds))
            return;
        meet();
        visitor.getIntersector()->leave();
    };
    for (const TreeCells::Cell& cell : cells.cells())
        if (!cell.trees.empty())
            within(cell.box, [&] {
                for (const TreeCells::Tree& tree : cell.trees)
                    within(TreeCells::boxOf(tree), [&] {
                        const osg::ref_ptr<PickedTree> picked = new PickedTree(simulation, tree.number);
                        picked->accept(visitor);
                    });
            });
}

} // namespace osgTreeWind

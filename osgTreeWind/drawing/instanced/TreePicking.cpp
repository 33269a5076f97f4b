// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreePicking.h>

#include <osgTreeWind/drawing/instanced/TreeHit.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/Group>

#include <functional>
#include <utility>

namespace osgTreeWind {
namespace {

/// Calls a function if the visitor's intersector hits a box. It does not become part of a node path.
class BoxTest : public osg::Group {
public:
    explicit BoxTest(std::function<void()> onHit) : _onHit(std::move(onHit)) {}
    void run(osg::NodeVisitor& visitor, const osg::BoundingBox& box) {
        _sphere = osg::BoundingSphere(box);
        dirtyBound();
        visitor.apply(*this); // tests the bound in local coordinates
    }
    osg::BoundingSphere computeBound() const override { return _sphere; }
    void traverse(osg::NodeVisitor&) override { _onHit(); }

private:
    std::function<void()> _onHit;
    osg::BoundingSphere _sphere;
};

} // namespace

void intersectTrees(osgUtil::IntersectionVisitor& visitor, const ForestSimulation& simulation,
                    const TreeCells& cells) {
    const TreeCells::Cell* cell = nullptr;
    const TreeCells::Tree* tree = nullptr;
    const osg::ref_ptr<BoxTest> treeTest = new BoxTest([&] {
        const osg::ref_ptr<TreeHit> picked =
            new TreeHit(simulation, movingForest(simulation).placed().idOf(tree->slot));
        picked->accept(visitor);
    });
    const osg::ref_ptr<BoxTest> cellTest = new BoxTest([&] {
        for (const TreeCells::Tree& each : cell->trees) {
            tree = &each;
            treeTest->run(visitor, TreeCells::swayBox(each));
        }
    });
    for (const TreeCells::Cell& each : cells.cells())
        if (!each.trees.empty()) {
            cell = &each;
            cellTest->run(visitor, each.box);
        }
}

} // namespace osgTreeWind

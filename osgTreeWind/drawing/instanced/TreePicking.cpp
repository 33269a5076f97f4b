// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreePicking.h>

#include <osgTreeWind/drawing/instanced/TreeHit.h>

#include <osg/Group>

#include <functional>
#include <utility>

namespace osgTreeWind {
namespace {

/// Trees within bounds, met if the visitor's intersector reaches these. Not a part of any path.
class Within : public osg::Group {
public:
    explicit Within(std::function<void()> meet) : _meet(std::move(meet)) {}
    void meet(osg::NodeVisitor& visitor, const osg::BoundingBox& box) {
        _sphere = osg::BoundingSphere(box);
        dirtyBound();
        visitor.apply(*this); // only there it is asked in coordinates of this place
    }
    osg::BoundingSphere computeBound() const override { return _sphere; }
    void traverse(osg::NodeVisitor&) override { _meet(); }

private:
    std::function<void()> _meet;
    osg::BoundingSphere _sphere;
};

} // namespace

void intersectTrees(osgUtil::IntersectionVisitor& visitor, const ForestSimulation& simulation,
                    const TreeCells& cells) {
    const TreeCells::Cell* cell = nullptr;
    const TreeCells::Tree* tree = nullptr;
    const osg::ref_ptr<Within> ofTree = new Within([&] {
        const osg::ref_ptr<TreeHit> picked = new TreeHit(simulation, tree->number);
        picked->accept(visitor);
    });
    const osg::ref_ptr<Within> ofCell = new Within([&] {
        for (const TreeCells::Tree& each : cell->trees) {
            tree = &each;
            ofTree->meet(visitor, TreeCells::boxOf(each));
        }
    });
    for (const TreeCells::Cell& each : cells.cells())
        if (!each.trees.empty()) {
            cell = &each;
            ofCell->meet(visitor, each.box);
        }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/TreeStand.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/StatelessFlutter.h>
#include <osgTreeWind/nodes/StandPicking.h>
#include <osgTreeWind/nodes/TreeStandCull.h>

#include <osgUtil/IntersectionVisitor>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr unsigned framesNear = 60;     // for which a tree is followed closely after it was last seen so

} // namespace

TreeStand::TreeStand() : TreeStand(std::make_shared<ForestSimulation>(ForestDescription())) {}

TreeStand::TreeStand(std::shared_ptr<ForestSimulation> simulation)
    : TreeStand(simulation, StandDrawing(simulation->forest())) {}

TreeStand::TreeStand(std::shared_ptr<ForestSimulation> simulation, const StandDrawing& drawing)
    : _simulation(std::move(simulation)), _drawing(drawing),
      _tiers(_simulation->description().drawing), _flutter(_simulation->description().species.size()) {
    setName("trees");
    setSupportsDisplayList(false);
    for (const TreeModel& model : _simulation->models())
        _passes.push_back(new PosePass(model.skeleton, _drawing.programs));
    for (std::size_t tree = 0; tree < _simulation->trees().size(); ++tree)
        if (_simulation->trees()[tree].alive)
            treeChanged(tree);
    updateFlutter(0.0);
}

TreeStand::TreeStand(const TreeStand& other, const osg::CopyOp&) : TreeStand(other._simulation, other._drawing) {}

void TreeStand::treeChanged(std::size_t tree) {
    const PlacedTree& placed = _simulation->trees()[tree];
    const auto number = static_cast<std::uint32_t>(tree);
    if (tree >= _seen.size())
        _seen.resize(tree + 1);
    if (!placed.alive) {
        _cells.take(number);
        _near.remove(number);
        _keptNear.remove(number);
    } else {
        const std::array<float, 5> reach = _simulation->forest().modelOf(placed).extents.reach(placed.scale);
        const float aside = std::max({reach[0], reach[1], reach[2], reach[3]});
        _cells.put({toOsg(placed.position), reach[4], aside, number});
        if (placed.leaves < 0.5f)
            _drawing.shapes[placed.model]->paintBare(_simulation->forest().modelOf(placed),
                                                     _simulation->forest().speciesOf(placed).appearance,
                                                     _drawing.impostorProgram);
        if (_simulation->modal()->level(tree) == ModalMotion::Level::Near && !_keptNear.has(number))
            _near.add(number);
    }
    dirtyBound();
}

void TreeStand::keepNear(std::size_t tree) {
    _simulation->setLevel(tree, ModalMotion::Level::Near);
    _near.remove(static_cast<std::uint32_t>(tree));
    _keptNear.add(static_cast<std::uint32_t>(tree));
}

void TreeStand::update(unsigned frame, double time) {
    updateFlutter(time);
    if (!_tiers.on())
        return;
    {
        const std::lock_guard<std::mutex> lock(_listsMutex);
        for (auto each = _lists.begin(); each != _lists.end();) {
            CullLists& lists = *each->second;
            for (const std::uint32_t tree : lists.awoken())
                if (_simulation->trees()[tree].alive &&
                    _simulation->modal()->level(tree) == ModalMotion::Level::Far) {
                    _simulation->setLevel(tree, ModalMotion::Level::Near);
                    _near.add(tree);
                }
            lists.awoken().clear();
            const bool gone = frame > lists.frame() + framesNear; // its cull visitor is no more
            each = gone ? _lists.erase(each) : std::next(each);
        }
    }
    if (frame % 8 != 0 || _culledFrame == ~0u || frame > _culledFrame + framesNear) // without a viewer all stay
        return;
    _near.removeIf([&](std::uint32_t tree) {
        const bool unseen = static_cast<std::uint8_t>(frame - _seen[tree]) >= framesNear;
        if (unseen)
            _simulation->setLevel(tree, ModalMotion::Level::Far);
        return unseen;
    });
}

void TreeStand::updateFlutter(double time) {
    const std::vector<Species>& species = _simulation->description().species;
    for (std::size_t i = 0; i < species.size(); ++i)
        _flutter[i] = toOsg(flutterPhases(time, species[i].leaf));
}

void TreeStand::accept(osg::NodeVisitor& visitor) {
    if (!visitor.validNodeMask(*this))
        return;
    if (auto* cull = visitor.asCullVisitor()) {
        visitor.pushOntoNodePath(this);
        this->cull(*cull);
        visitor.popFromNodePath();
    } else if (auto* picking = dynamic_cast<osgUtil::IntersectionVisitor*>(&visitor)) {
        visitor.pushOntoNodePath(this);
        intersectTrees(*picking, *_simulation, _cells);
        visitor.popFromNodePath();
    } else {
        osg::Drawable::accept(visitor);
    }
}

CullLists& TreeStand::listsOf(const osgUtil::CullVisitor& visitor) {
    const std::lock_guard<std::mutex> lock(_listsMutex);
    std::unique_ptr<CullLists>& lists = _lists[&visitor];
    if (!lists)
        lists = std::make_unique<CullLists>();
    return *lists;
}

void TreeStand::cull(osgUtil::CullVisitor& visitor) {
    const unsigned frame = visitor.getFrameStamp() ? visitor.getFrameStamp()->getFrameNumber() : 0;
    _culledFrame = frame;
    TreeStandCull{visitor, frame,  *_simulation, _drawing, _passes,
                  _tiers,  _cells, _flutter,     _seen,    listsOf(visitor)}
        .run();
}

std::array<std::size_t, tierCount> TreeStand::listedTrees() const {
    std::array<std::size_t, tierCount> trees{};
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const auto& each : _lists)
        if (each.second->frame() == _culledFrame)
            each.second->countTrees(trees);
    return trees;
}

void TreeStand::resizeGLObjectBuffers(unsigned maxSize) {
    osg::Drawable::resizeGLObjectBuffers(maxSize);
    _drawing.resizeGLObjectBuffers(maxSize);
}

void TreeStand::releaseGLObjects(osg::State* state) const {
    osg::Drawable::releaseGLObjects(state);
    _drawing.releaseGLObjects(state);
    for (const osg::ref_ptr<PosePass>& passes : _passes)
        passes->releaseGLObjects(state);
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const auto& each : _lists)
        each.second->releaseGLObjects(state);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>

#include <osgTreeWind/drawing/instanced/InstancedCull.h>
#include <osgTreeWind/drawing/instanced/TreePicking.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/SimulationAccess.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osgUtil/IntersectionVisitor>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr unsigned framesNear = 60; // at Level::Near after a camera last saw the branches

} // namespace

InstancedTrees::InstancedTrees() : InstancedTrees(std::make_shared<ForestSimulation>(ForestDescription())) {}

InstancedTrees::InstancedTrees(const std::shared_ptr<ForestSimulation>& simulation)
    : InstancedTrees(simulation, InstancedResources(*simulation)) {}

InstancedTrees::InstancedTrees(std::shared_ptr<ForestSimulation> simulation, InstancedResources resources)
    : _simulation(std::move(simulation)), _resources(std::move(resources)),
      _tiers(_simulation->description().drawing) {
    setName("trees");
    setDataVariance(DYNAMIC); // osgUtil::Optimizer would flatten transforms above it
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true); // makes osgUtil::GLObjectsVisitor call compileGLObjects()
    addPasses();
    for (std::size_t tree = 0; tree < SimulationAccess::trees(*_simulation).size(); ++tree)
        if (SimulationAccess::trees(*_simulation)[tree].alive)
            treeChanged(tree);
    updateFlutter(0.0);
    _shade.update();
}

void InstancedTrees::addPasses() {
    const auto& models = SimulationAccess::models(*_simulation);
    for (std::size_t model = _passes.size(); model < models.size(); ++model)
        _passes.push_back(new PosePass(models[model]->skeleton, _resources.programs));
    _flutter.resize(_simulation->description().species.size());
}

void InstancedTrees::speciesAdded() {
    _resources.addSpecies(*_simulation);
    addPasses();
}

void InstancedTrees::treeChanged(std::size_t tree) {
    const PlacedTree& placed = SimulationAccess::trees(*_simulation)[tree];
    const auto slot = static_cast<std::uint32_t>(tree);
    if (tree >= _nearStates.size())
        _nearStates.resize(tree + 1);
    if (!placed.alive) {
        _cells.remove(slot);
        updateShade(slot);
        _nearStates[tree].pinned = false;
    } else {
        const std::array<float, 5> reach =
            SimulationAccess::forest(*_simulation).modelOf(placed).extents.reach(placed.scale);
        const TreeFall* fall = SimulationAccess::modal(*_simulation)->fall(tree);
        const bool isDown = fall && fall->isDown;
        const float aside = std::max({reach[0], reach[1], reach[2], reach[3], isDown ? reach[4] : 0.0f});
        _cells.insert({toOsg(placed.position), reach[4], aside, slot});
        updateShade(slot);
        _resources.paintImpostor(*_simulation, placed);
        if (SimulationAccess::modal(*_simulation)->level(tree) == ModalMotion::Level::Near)
            markNear(slot);
    }
    dirtyBound();
}

osg::BoundingBox InstancedTrees::computeBoundingBox() const {
    osg::BoundingBox box;
    for (const PlacedTree& tree : SimulationAccess::trees(*_simulation)) {
        if (!tree.alive)
            continue;
        const std::array<float, 5> reach =
            SimulationAccess::forest(*_simulation).modelOf(tree).extents.reach(tree.scale);
        const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
        for (const float x : {-reach[1], reach[0]})
            for (const float y : {-reach[3], reach[2]})
                for (const float z : {0.0f, reach[4]})
                    box.expandBy(toOsg(tree.position + rotateAboutZ({x, y, z}, sine, cosine)));
    }
    return box;
}

void InstancedTrees::seasonChanged() {
    _resources.updateSeason(*_simulation);
    for (std::size_t tree = 0; tree < SimulationAccess::trees(*_simulation).size(); ++tree)
        updateShade(static_cast<std::uint32_t>(tree));
}

/// A fallen tree shades no neighbours.
void InstancedTrees::updateShade(std::uint32_t tree) {
    const PlacedTree& placed = SimulationAccess::trees(*_simulation)[tree];
    const TreeFall* fall = SimulationAccess::modal(*_simulation)->fall(tree);
    if (!placed.alive || (fall && fall->isDown)) {
        _shade.remove(tree);
        return;
    }
    const TreeSize size = SimulationAccess::forest(*_simulation).sizeOf(placed);
    _shade.insert(tree, {placed.position, size.height, 0.5f * size.crownWidth, 0.35f + 0.6f * placed.leaves});
}

void InstancedTrees::markNear(std::uint32_t tree) {
    NearState& state = _nearStates[tree];
    state.lastSeen = static_cast<std::uint8_t>(_frame);
    if (!state.isNear)
        _nearTrees.push_back(tree);
    state.isNear = true;
}

void InstancedTrees::keepNear(std::size_t tree, bool pinned) {
    _nearStates[tree].pinned = pinned;
    if (!pinned)
        return;
    SimulationAccess::modal(*_simulation)->setLevel(tree, ModalMotion::Level::Near);
    markNear(static_cast<std::uint32_t>(tree));
}

void InstancedTrees::update(unsigned frame, double time) {
    _frame = frame;
    updateFlutter(time);
    _shade.update();
    ModalMotion& modal = *SimulationAccess::modal(*_simulation);
    {
        const std::lock_guard<std::mutex> lock(_listsMutex);
        for (const VisitorLists& each : _lists) {
            for (const std::uint32_t tree : each.lists->nearTrees()) {
                if (!SimulationAccess::trees(*_simulation)[tree].alive)
                    continue;
                if (modal.level(tree) == ModalMotion::Level::Far)
                    modal.setLevel(tree, ModalMotion::Level::Near);
                markNear(tree);
            }
            each.lists->nearTrees().clear();
        }
        // Visitors and cameras may have been deleted.
        const auto removeUnused = [](auto& items, const auto& isUnused) {
            items.erase(std::remove_if(items.begin(), items.end(), isUnused), items.end());
        };
        removeUnused(_lists,
                     [&](const VisitorLists& each) { return frame > each.lists->frame() + framesNear; });
        removeUnused(_views, [&](const View& each) { return frame > each.frame + framesNear; });
    }
    // Without a viewer, trees keep their levels.
    if (!_tiers.areEnabled() || frame % 8 != 0 || _culledFrame == ~0u || frame > _culledFrame + framesNear)
        return;
    _nearTrees.erase(
        std::remove_if(_nearTrees.begin(), _nearTrees.end(),
                       [&](std::uint32_t tree) {
                           NearState& state = _nearStates[tree];
                           const bool isNear = SimulationAccess::trees(*_simulation)[tree].alive &&
                                               modal.level(tree) == ModalMotion::Level::Near;
                           if (isNear && (state.pinned ||
                                          static_cast<std::uint8_t>(frame - state.lastSeen) < framesNear))
                               return false;
                           if (isNear)
                               modal.setLevel(tree, ModalMotion::Level::Far);
                           state.isNear = false;
                           return true;
                       }),
        _nearTrees.end());
}

void InstancedTrees::updateFlutter(double time) {
    const std::vector<Species>& species = _simulation->description().species;
    for (std::size_t i = 0; i < species.size(); ++i)
        _flutter[i] = toOsg(flutterPhases(time, species[i].leaf));
}

void InstancedTrees::accept(osg::NodeVisitor& visitor) {
    if (!visitor.validNodeMask(*this))
        return;
    if (auto* cull = visitor.asCullVisitor()) {
        visitor.pushOntoNodePath(this);
        const osg::ref_ptr<osgUtil::StateGraph> place = cull->getCurrentStateGraph();
        if (!_guard.run("trees of the forest may be missing in pictures", [&] { this->cull(*cull); }))
            while (cull->getCurrentStateGraph() != place)
                cull->popStateSet();
        visitor.popFromNodePath();
    } else if (auto* picking = dynamic_cast<osgUtil::IntersectionVisitor*>(&visitor)) {
        visitor.pushOntoNodePath(this);
        _guard.run("trees of the forest may not be picked",
                   [&] { intersectTrees(*picking, *_simulation, _cells); });
        visitor.popFromNodePath();
    } else {
        osg::Drawable::accept(visitor);
    }
}

/// Lists of this visitor whose draws have finished, or new ones.
osg::ref_ptr<CullLists> InstancedTrees::acquireLists(const osgUtil::CullVisitor& visitor) {
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const VisitorLists& each : _lists)
        if (each.visitor == &visitor && each.lists->referenceCount() == 1)
            return each.lists;
    _lists.push_back({&visitor, new CullLists});
    return _lists.back().lists;
}

/// The detail that the budget of the view allows. Shadow cameras and the like share the budget of their view.
float InstancedTrees::detailOf(osgUtil::CullVisitor& visitor, unsigned frame) {
    const float budget = _simulation->description().drawing.budget;
    const osg::Camera* camera = budget > 0.0f ? visitor.getRenderStage()->getCamera() : nullptr;
    osg::Stats* stats = camera ? const_cast<osg::Stats*>(camera->getStats()) : nullptr;
    if (!stats || !_tiers.areEnabled())
        return 1.0f;
    if (!stats->collectStats("rendering"))
        stats->collectStats("rendering", true);
    const std::lock_guard<std::mutex> lock(_listsMutex);
    const auto known =
        std::find_if(_views.begin(), _views.end(), [&](const View& each) { return each.camera == camera; });
    View& view = known != _views.end() ? *known : _views.emplace_back(View{camera, {}, frame});
    view.frame = frame;
    const float detail = view.budget.updateDetail(*stats, frame, budget);
    stats->setAttribute(frame, "Tree detail", static_cast<double>(detail));
    return detail;
}

void InstancedTrees::cull(osgUtil::CullVisitor& visitor) {
    const unsigned frame = visitor.getFrameStamp() ? visitor.getFrameStamp()->getFrameNumber() : 0;
    _culledFrame = frame;
    const osg::ref_ptr<CullLists> lists = acquireLists(visitor);
    InstancedCull{visitor,    frame,   *_simulation, *SimulationAccess::modal(*_simulation),
                  _resources, _passes, _tiers,       detailOf(visitor, frame),
                  _cells,     _shade,  _flutter,     *lists}
        .run();
}

std::array<std::size_t, tierCount> InstancedTrees::treesByTier() const {
    std::array<std::size_t, tierCount> trees{};
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const VisitorLists& each : _lists)
        if (each.lists->frame() == _culledFrame)
            each.lists->addTreeCounts(trees);
    return trees;
}

void InstancedTrees::compileGLObjects(osg::RenderInfo& renderInfo) const {
    _guard.run("trees of the forest are compiled as they are drawn", [&] {
        for (osg::Object* object : _resources.glObjects())
            if (const osg::StateSet* state = object->asStateSet())
                state->compileGLObjects(*renderInfo.getState());
            else if (const osg::StateAttribute* program = object->asStateAttribute())
                program->compileGLObjects(*renderInfo.getState());
            else
                object->asDrawable()->compileGLObjects(renderInfo);
    });
}

void InstancedTrees::resizeGLObjectBuffers(unsigned maxSize) {
    osg::Drawable::resizeGLObjectBuffers(maxSize);
    for (osg::Object* object : _resources.glObjects())
        object->resizeGLObjectBuffers(maxSize);
}

void InstancedTrees::releaseGLObjects(osg::State* state) const {
    osg::Drawable::releaseGLObjects(state);
    for (const osg::Object* object : _resources.glObjects())
        object->releaseGLObjects(state);
    for (const osg::ref_ptr<PosePass>& passes : _passes)
        passes->releaseGLObjects(state);
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const VisitorLists& each : _lists)
        each.lists->releaseGLObjects(state);
}

} // namespace osgTreeWind

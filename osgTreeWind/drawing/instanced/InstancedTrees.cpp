// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/drawing/instanced/TreePicking.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>

#include <osgUtil/IntersectionVisitor>

#include <algorithm>
#include <functional>

namespace osgTreeWind {
namespace {

constexpr unsigned framesNear = 60; // at Level::Near after a camera last saw the branches

} // namespace

InstancedTrees::InstancedTrees() : InstancedTrees(std::make_shared<ForestSimulation>(ForestDescription())) {}

InstancedTrees::InstancedTrees(const std::shared_ptr<ForestSimulation>& simulation)
    : InstancedTrees(simulation, InstancedResources(*simulation)) {}

InstancedTrees::InstancedTrees(std::shared_ptr<ForestSimulation> simulation, InstancedResources resources)
    : _simulation(std::move(simulation)), _scene{movingForest(*_simulation), std::move(resources),
                                                 TreeTiers(_simulation->description().drawing)} {
    setName("trees");
    setDataVariance(DYNAMIC); // osgUtil::Optimizer would flatten transforms above it
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true); // makes osgUtil::GLObjectsVisitor call compileGLObjects()
    addModels();
    for (std::size_t tree = 0; tree < _scene.forest.trees().size(); ++tree)
        if (_scene.forest.trees()[tree].alive)
            treeChanged(tree);
    updateFlutter(0.0);
    _scene.shade.update();
}

void InstancedTrees::addModels() {
    const auto& models = _scene.forest.models();
    for (std::size_t model = _scene.poses->modelCount(); model < models.size(); ++model)
        _scene.poses->addModel(models[model]->skeleton);
    _scene.flutter.resize(_simulation->description().species.size());
}

void InstancedTrees::speciesAdded() {
    _scene.resources.addSpecies(*_simulation);
    addModels();
}

void InstancedTrees::treeChanged(std::size_t tree) {
    const PlacedTree& placed = _scene.forest.trees()[tree];
    const auto slot = static_cast<std::uint32_t>(tree);
    if (tree >= _nearStates.size())
        _nearStates.resize(tree + 1);
    if (!placed.alive) {
        _scene.cells.remove(slot);
        updateShade(slot);
        _nearStates[tree].pinned = false;
    } else {
        const std::array<float, 5> reach = _scene.forest.placed().modelOf(placed).extents.reach(placed.scale);
        const TreeFall* fall = _scene.forest.modal()->fall(tree);
        const bool isDown = fall && fall->isDown;
        const float aside = std::max({reach[0], reach[1], reach[2], reach[3], isDown ? reach[4] : 0.0f});
        _scene.cells.insert({toOsg(placed.position), reach[4], aside, slot});
        updateShade(slot);
        _scene.resources.prepareTree(*_simulation, placed);
        if (_scene.forest.modal()->level(tree) == ModalLevel::Near)
            markNear(slot);
    }
    dirtyBound();
}

osg::BoundingBox InstancedTrees::computeBoundingBox() const {
    osg::BoundingBox box;
    for (const PlacedTree& tree : _scene.forest.trees()) {
        if (!tree.alive)
            continue;
        const std::array<float, 5> reach = _scene.forest.placed().modelOf(tree).extents.reach(tree.scale);
        const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
        for (const float x : {-reach[1], reach[0]})
            for (const float y : {-reach[3], reach[2]})
                for (const float z : {0.0f, reach[4]})
                    box.expandBy(toOsg(tree.position + rotateAboutZ({x, y, z}, sine, cosine)));
    }
    return box;
}

void InstancedTrees::seasonChanged() {
    _scene.resources.updateSeason(*_simulation);
    for (std::size_t tree = 0; tree < _scene.forest.trees().size(); ++tree)
        updateShade(static_cast<std::uint32_t>(tree));
}

/// A fallen tree shades no neighbours.
void InstancedTrees::updateShade(std::uint32_t tree) {
    const PlacedTree& placed = _scene.forest.trees()[tree];
    const TreeFall* fall = _scene.forest.modal()->fall(tree);
    if (!placed.alive || (fall && fall->isDown)) {
        _scene.shade.remove(tree);
        return;
    }
    const TreeSize size = _scene.forest.placed().sizeOf(placed);
    _scene.shade.insert(tree,
                        {placed.position, size.height, 0.5f * size.crownWidth, 0.35f + 0.6f * placed.leaves});
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
    _scene.forest.modal()->setLevel(tree, ModalLevel::Near);
    markNear(static_cast<std::uint32_t>(tree));
}

void InstancedTrees::update(unsigned frame, double time) {
    _frame = frame;
    updateFlutter(time);
    _scene.shade.update();
    promoteSeenTrees();
    forgetViews();
    // Without a viewer, trees keep their levels.
    if (_scene.tiers.areEnabled() && frame % 8 == 0 && _culledFrame != ~0u &&
        frame <= _culledFrame + framesNear)
        demoteUnseenTrees();
}

/// Gives the trees whose branches a camera saw the motion of near ones.
void InstancedTrees::promoteSeenTrees() {
    ModalMotion& modal = *_scene.forest.modal();
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const VisitorLists& each : _lists) {
        for (const std::uint32_t tree : each.lists->nearTrees()) {
            if (!_scene.forest.trees()[tree].alive)
                continue;
            modal.setLevel(tree, ModalLevel::Near);
            markNear(tree);
        }
        each.lists->nearTrees().clear();
    }
}

/// Gives trees that no camera has seen for a while the motion of far ones.
void InstancedTrees::demoteUnseenTrees() {
    ModalMotion& modal = *_scene.forest.modal();
    std::size_t kept = 0;
    for (const std::uint32_t tree : _nearTrees) {
        NearState& state = _nearStates[tree];
        state.isNear = _scene.forest.trees()[tree].alive && modal.level(tree) == ModalLevel::Near;
        const bool isSeen = state.pinned || static_cast<std::uint8_t>(_frame - state.lastSeen) < framesNear;
        if (state.isNear && !isSeen) {
            modal.setLevel(tree, ModalLevel::Far);
            state.isNear = false;
        }
        if (state.isNear)
            _nearTrees[kept++] = tree;
    }
    _nearTrees.resize(kept);
}

/// Drops what belongs to visitors and cameras that have been gone for a while.
void InstancedTrees::forgetViews() {
    const std::lock_guard<std::mutex> lock(_listsMutex);
    const auto remove = [](auto& items, const auto& isUnused) {
        items.erase(std::remove_if(items.begin(), items.end(), isUnused), items.end());
    };
    remove(_lists, [&](const VisitorLists& each) { return _frame > each.lists->frame() + framesNear; });
    remove(_views, [&](const View& each) { return _frame > each.frame + framesNear; });
}

void InstancedTrees::updateFlutter(double time) {
    const std::vector<Species>& species = _simulation->description().species;
    for (std::size_t i = 0; i < species.size(); ++i)
        _scene.flutter[i] = toOsg(flutterPhases(time, species[i].leaf));
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
                   [&] { intersectTrees(*picking, *_simulation, _scene.cells); });
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
    if (!stats || !_scene.tiers.areEnabled())
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
    InstancedCull{visitor, frame, _scene, detailOf(visitor, frame), *lists}.run();
}

std::array<std::size_t, tierCount> InstancedTrees::treesByTier() const {
    std::array<std::size_t, tierCount> trees{};
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const VisitorLists& each : _lists)
        if (each.lists->frame() == _culledFrame)
            std::transform(trees.begin(), trees.end(), each.lists->treesByTier().begin(), trees.begin(),
                           std::plus<>());
    return trees;
}

void InstancedTrees::compileGLObjects(osg::RenderInfo& renderInfo) const {
    _guard.run("trees of the forest are compiled as they are drawn", [&] {
        for (osg::Object* object : _scene.resources.glObjects())
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
    for (osg::Object* object : _scene.resources.glObjects())
        object->resizeGLObjectBuffers(maxSize);
}

void InstancedTrees::releaseGLObjects(osg::State* state) const {
    osg::Drawable::releaseGLObjects(state);
    for (const osg::Object* object : _scene.resources.glObjects())
        object->releaseGLObjects(state);
    _scene.poses->releaseGLObjects(state);
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const VisitorLists& each : _lists)
        each.lists->releaseGLObjects(state);
}

} // namespace osgTreeWind

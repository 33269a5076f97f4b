// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>

#include <osgTreeWind/drawing/instanced/InstancedCull.h>
#include <osgTreeWind/drawing/instanced/TreePicking.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/SimulationParts.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osgUtil/IntersectionVisitor>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr unsigned framesNear = 60; // for which a tree is followed closely after it was last seen so

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
    setUseVertexBufferObjects(true); // else nobody asks it to compile them
    addPasses();
    for (std::size_t tree = 0; tree < SimulationParts::trees(*_simulation).size(); ++tree)
        if (SimulationParts::trees(*_simulation)[tree].alive)
            treeChanged(tree);
    updateFlutter(0.0);
    _shade.update();
}

void InstancedTrees::addPasses() {
    const auto& models = SimulationParts::models(*_simulation);
    for (std::size_t model = _passes.size(); model < models.size(); ++model)
        _passes.push_back(new PosePass(models[model]->skeleton, _resources.programs));
    _flutter.resize(_simulation->description().species.size());
}

void InstancedTrees::speciesAdded() {
    _resources.addSpecies(*_simulation);
    addPasses();
}

void InstancedTrees::treeChanged(std::size_t tree) {
    const PlacedTree& placed = SimulationParts::trees(*_simulation)[tree];
    const auto number = static_cast<std::uint32_t>(tree);
    if (tree >= _attention.size())
        _attention.resize(tree + 1);
    if (!placed.alive) {
        _cells.take(number);
        shadeNeighbours(number);
        _attention[tree].kept = false;
    } else {
        const std::array<float, 5> reach =
            SimulationParts::forest(*_simulation).modelOf(placed).extents.reach(placed.scale);
        const TreeFall* fall = SimulationParts::modal(*_simulation)->fall(tree);
        const bool isDown = fall && fall->isDown;
        const float aside = std::max({reach[0], reach[1], reach[2], reach[3], isDown ? reach[4] : 0.0f});
        _cells.put({toOsg(placed.position), reach[4], aside, number});
        shadeNeighbours(number);
        _resources.paintImpostor(*_simulation, placed);
        if (SimulationParts::modal(*_simulation)->level(tree) == ModalMotion::Level::Near)
            follow(number);
    }
    dirtyBound();
}

osg::BoundingBox InstancedTrees::computeBoundingBox() const {
    osg::BoundingBox box;
    for (const PlacedTree& tree : SimulationParts::trees(*_simulation)) {
        if (!tree.alive)
            continue;
        const std::array<float, 5> reach =
            SimulationParts::forest(*_simulation).modelOf(tree).extents.reach(tree.scale);
        const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
        for (const float x : {-reach[1], reach[0]})
            for (const float y : {-reach[3], reach[2]})
                for (const float z : {0.0f, reach[4]})
                    box.expandBy(toOsg(tree.position + turnHeading({x, y, z}, sine, cosine)));
    }
    return box;
}

void InstancedTrees::seasonChanged() {
    _resources.followSeason(*_simulation);
    for (std::size_t tree = 0; tree < SimulationParts::trees(*_simulation).size(); ++tree)
        shadeNeighbours(static_cast<std::uint32_t>(tree));
}

/// As long as it stands.
void InstancedTrees::shadeNeighbours(std::uint32_t tree) {
    const PlacedTree& placed = SimulationParts::trees(*_simulation)[tree];
    const TreeFall* fall = SimulationParts::modal(*_simulation)->fall(tree);
    if (!placed.alive || (fall && fall->isDown)) {
        _shade.take(tree);
        return;
    }
    const TreeSize size = SimulationParts::forest(*_simulation).measured(placed);
    _shade.put(tree, {placed.position, size.height, 0.5f * size.crownWidth, 0.35f + 0.6f * placed.leaves});
}

void InstancedTrees::follow(std::uint32_t tree) {
    Attention& attention = _attention[tree];
    attention.seen = static_cast<std::uint8_t>(_frame);
    if (!attention.isNear)
        _near.push_back(tree);
    attention.isNear = true;
}

void InstancedTrees::keepNear(std::size_t tree, bool kept) {
    _attention[tree].kept = kept;
    if (!kept)
        return;
    SimulationParts::modal(*_simulation)->setLevel(tree, ModalMotion::Level::Near);
    follow(static_cast<std::uint32_t>(tree));
}

void InstancedTrees::update(unsigned frame, double time) {
    _frame = frame;
    updateFlutter(time);
    _shade.update();
    ModalMotion& modal = *SimulationParts::modal(*_simulation);
    {
        const std::lock_guard<std::mutex> lock(_listsMutex);
        for (const Lists& each : _lists) {
            for (const std::uint32_t tree : each.lists->near()) {
                if (!SimulationParts::trees(*_simulation)[tree].alive)
                    continue;
                if (modal.level(tree) == ModalMotion::Level::Far)
                    modal.setLevel(tree, ModalMotion::Level::Near);
                follow(tree);
            }
            each.lists->near().clear();
        }
        const auto forget = [](auto& past, const auto& isPast) { // those culled for may be no more
            past.erase(std::remove_if(past.begin(), past.end(), isPast), past.end());
        };
        forget(_lists, [&](const Lists& each) { return frame > each.lists->frame() + framesNear; });
        forget(_views, [&](const View& each) { return frame > each.frame + framesNear; });
    }
    // Without a viewer all stay.
    if (!_tiers.on() || frame % 8 != 0 || _culledFrame == ~0u || frame > _culledFrame + framesNear)
        return;
    _near.erase(std::remove_if(_near.begin(), _near.end(),
                               [&](std::uint32_t tree) {
                                   Attention& attention = _attention[tree];
                                   const bool isNear = SimulationParts::trees(*_simulation)[tree].alive &&
                                                       modal.level(tree) == ModalMotion::Level::Near;
                                   if (isNear && (attention.kept || static_cast<std::uint8_t>(
                                                                        frame - attention.seen) < framesNear))
                                       return false;
                                   if (isNear)
                                       modal.setLevel(tree, ModalMotion::Level::Far);
                                   attention.isNear = false;
                                   return true;
                               }),
                _near.end());
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
        _guard.run("trees of the forest may not be met",
                   [&] { intersectTrees(*picking, *_simulation, _cells); });
        visitor.popFromNodePath();
    } else {
        osg::Drawable::accept(visitor);
    }
}

/// Lists of this visitor that nobody draws from any more.
osg::ref_ptr<CullLists> InstancedTrees::freeLists(const osgUtil::CullVisitor& visitor) {
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const Lists& each : _lists)
        if (each.visitor == &visitor && each.lists->referenceCount() == 1)
            return each.lists;
    _lists.push_back({&visitor, new CullLists});
    return _lists.back().lists;
}

/// What its view's budget leaves of the trees' detail; shadow cameras and the like are part of a view.
float InstancedTrees::detailOf(osgUtil::CullVisitor& visitor, unsigned frame) {
    const float budget = _simulation->description().drawing.budget;
    const osg::Camera* camera = budget > 0.0f ? visitor.getRenderStage()->getCamera() : nullptr;
    osg::Stats* stats = camera ? const_cast<osg::Stats*>(camera->getStats()) : nullptr;
    if (!stats || !_tiers.on())
        return 1.0f;
    if (!stats->collectStats("rendering"))
        stats->collectStats("rendering", true);
    const std::lock_guard<std::mutex> lock(_listsMutex);
    const auto known =
        std::find_if(_views.begin(), _views.end(), [&](const View& each) { return each.camera == camera; });
    View& view = known != _views.end() ? *known : _views.emplace_back(View{camera, {}, frame});
    view.frame = frame;
    const float detail = view.budget.follow(*stats, frame, budget);
    stats->setAttribute(frame, "Tree detail", static_cast<double>(detail));
    return detail;
}

void InstancedTrees::cull(osgUtil::CullVisitor& visitor) {
    const unsigned frame = visitor.getFrameStamp() ? visitor.getFrameStamp()->getFrameNumber() : 0;
    _culledFrame = frame;
    const osg::ref_ptr<CullLists> lists = freeLists(visitor);
    InstancedCull{visitor,    frame,   *_simulation, *SimulationParts::modal(*_simulation),
                  _resources, _passes, _tiers,       detailOf(visitor, frame),
                  _cells,     _shade,  _flutter,     *lists}
        .run();
}

std::array<std::size_t, tierCount> InstancedTrees::listedTrees() const {
    std::array<std::size_t, tierCount> trees{};
    const std::lock_guard<std::mutex> lock(_listsMutex);
    for (const Lists& each : _lists)
        if (each.lists->frame() == _culledFrame)
            each.lists->countTrees(trees);
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
    for (const Lists& each : _lists)
        each.lists->releaseGLObjects(state);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/CullLists.h>

#include <osgTreeWind/drawing/looks/SceneShading.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>

namespace osgTreeWind {
namespace {

/// Number of kinds for one model and band.
constexpr std::size_t withBranches = 2 * branchTiers * LeafOrders::count,
                      kinds = withBranches + 4 * impostorTiers;

std::size_t kindIndex(const CullLists::Kind& kind) {
    const auto tier = static_cast<std::size_t>(kind.tier);
    return kind.tier < Tier::Impostor
               ? 2 * (tier * LeafOrders::count + kind.order) + kind.fading
               : withBranches + 4 * (tier - branchTiers) + 2 * kind.fading + kind.small;
}

} // namespace

CullLists::CullLists() {
    for (osg::ref_ptr<osg::StateSet>& state : _bandStates)
        state = new osg::StateSet;
}

std::size_t CullLists::bandOf(float distance) {
    std::size_t band = 0;
    for (float end = 60.0f; band + 1 < bands && distance >= end; end *= 2.0f)
        ++band;
    return band;
}

void CullLists::begin(unsigned frame, std::size_t models, osgUtil::RenderStage* stage,
                      osgUtil::StateGraph* stateGraph, osg::Camera* camera) {
    _frame = frame;
    _camera = camera;
    _stage = stage;
    _stateGraph = stateGraph;
    _used = 0;
    _nearTrees.clear();
    _models = models;
    _currentLists.assign(bands * models * kinds, 0);
}

InstanceList& CullLists::list(const Kind& kind, const PosePass* passes, PosePage* page) {
    std::size_t& current = _currentLists[(kind.band * _models + kind.model) * kinds + kindIndex(kind)];
    if (current != 0 && _lists[current - 1].trees->page == page)
        return *_lists[current - 1].trees;
    if (_used == _lists.size())
        _lists.emplace_back();
    List& list = _lists[_used++];
    current = _used;
    static_cast<Kind&>(list) = kind;
    list.trees->clear();
    list.trees->passes = passes;
    list.trees->page = page;
    return *list.trees;
}

void CullLists::addTreeCounts(std::array<std::size_t, tierCount>& trees) const {
    for (std::size_t i = 0; i < _used; ++i)
        trees[static_cast<std::size_t>(_lists[i].tier)] += _lists[i].trees->size();
}

void CullLists::draw(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*&) {
    prepareProfile(*renderInfo.getState()); // before the textures of the trees are made
    osg::ref_ptr<osg::Camera> camera;
    setSceneDefines(*_shading, _stage->getStateSet(), _stateGraph,
                    _camera.lock(camera) && supportsSampleMask(*camera, *renderInfo.getState()));
    static const ExceptionGuard guard;
    guard.run("trees may be missing in pictures", [&] {
        for (std::size_t i = 0; i < _used; ++i)
            if (const InstanceList& trees = *_lists[i].trees; trees.page)
                trees.passes->prepare(*renderInfo.getState(), *trees.page);
    });
}

void CullLists::releaseGLObjects(osg::State* state) const {
    for (const List& list : _lists) {
        list.trees->values->getVertexBufferObject()->releaseGLObjects(state);
        list.bark->releaseGLObjects(state);
        list.leaves->releaseGLObjects(state);
    }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/CullLists.h>

#include <osgTreeWind/drawing/looks/SceneShading.h>
#include <osgTreeWind/gpu/EntryGuard.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

namespace osgTreeWind {

namespace {

/// Kinds of lists of a model in a band.
constexpr std::size_t withBranches = 2 * branchTiers * LeafOrders::count,
                      kinds = withBranches + 4 * impostorTiers;

std::size_t numberOf(const CullLists::Kind& kind) {
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

void CullLists::begin(unsigned frame, std::size_t models, osgUtil::StateGraph* place, osg::Camera* camera) {
    _frame = frame;
    _camera = camera;
    _place = place;
    _used = 0;
    _near.clear();
    _models = models;
    _open.assign(bands * models * kinds, 0);
}

InstanceList& CullLists::list(const Kind& kind, const PosePass* passes, PosePage* page) {
    std::size_t& open = _open[(kind.band * _models + kind.model) * kinds + numberOf(kind)];
    if (open != 0 && _lists[open - 1].trees->page == page)
        return *_lists[open - 1].trees;
    if (_used == _lists.size())
        _lists.emplace_back();
    List& list = _lists[_used++];
    open = _used;
    static_cast<Kind&>(list) = kind;
    list.trees->clear();
    list.trees->passes = passes;
    list.trees->page = page;
    return *list.trees;
}

void CullLists::countTrees(std::array<std::size_t, tierCount>& trees) const {
    for (std::size_t i = 0; i < _used; ++i)
        trees[static_cast<std::size_t>(_lists[i].tier)] += _lists[i].trees->size();
}

void CullLists::draw(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*&) {
    if (!canRunPrograms(*renderInfo.getState()))
        return;
    osg::ref_ptr<osg::Camera> camera;
    setSceneDefines(*_shading, _place,
                    _camera.lock(camera) && choosesSamples(*camera, *renderInfo.getState()));
    static const EntryGuard guard;
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

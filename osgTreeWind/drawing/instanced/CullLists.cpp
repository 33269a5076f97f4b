// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/CullLists.h>

#include <osgTreeWind/drawing/looks/SceneShading.h>
#include <osgTreeWind/gpu/DrawTimer.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>

namespace osgTreeWind {
namespace {

/// Number of kinds for one model and band: trees with branches, and impostors.
constexpr std::size_t kinds = 1 + 2 * impostorTiers;

std::size_t kindIndex(const CullLists::Kind& kind) {
    const auto tier = static_cast<std::size_t>(kind.tier);
    return kind.tier < Tier::Impostor ? 0 : 1 + 2 * (tier - branchTiers) + kind.small;
}

} // namespace

CullLists::CullLists() {
    for (osg::ref_ptr<osg::StateSet>& state : _bandStates)
        state = new osg::StateSet;
}

std::size_t CullLists::bandOf(float distance) {
    std::size_t band = 0;
    for (float end = 8.0f; band + 1 < bands && distance >= end; end *= 4.0f)
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
    _buffer->clear();
    _drawnTrees.clear();
    _treesByTier = {};
    _nearTrees.clear();
    _models = models;
    _currentLists.assign(bands * models * kinds, 0);
}

CullLists::List& CullLists::list(const Kind& kind, const DrawnPoses& poses) {
    std::size_t& current = _currentLists[(kind.band * _models + kind.model) * kinds + kindIndex(kind)];
    if (current != 0 && _lists[current - 1].poses.page == poses.page)
        return _lists[current - 1];
    if (_used == _lists.size())
        _lists.emplace_back();
    List& list = _lists[_used++];
    current = _used;
    static_cast<Kind&>(list) = kind;
    list.poses = poses;
    list.trees.clear();
    list.barkCommands.clear();
    list.leafCommands.clear();
    return list;
}

void CullLists::List::draw(const MeshPart& part, bool isLeaf, std::uint32_t instance) {
    std::vector<DrawCommand>& commands = isLeaf ? leafCommands : barkCommands;
    if (!commands.empty()) {
        DrawCommand& last = commands.back();
        if (last.firstInstance == instance && last.firstVertex == part.firstVertex &&
            last.firstIndex + last.indices == part.firstIndex) {
            last.indices += part.indices;
            return;
        }
    }
    commands.push_back({part.indices, 1, part.firstIndex, part.firstVertex, instance});
}

void CullLists::draw(osg::RenderInfo& renderInfo, osgUtil::RenderLeaf*&) {
    _buffer->beginDraws(*renderInfo.getState()); // before the textures of the trees are made
    osg::ref_ptr<osg::Camera> camera;
    setSceneDefines(*_shading, _stage->getStateSet(), _stateGraph,
                    _camera.lock(camera) && supportsSampleMask(*camera, *renderInfo.getState()));
    static const ExceptionGuard guard;
    guard.run("trees may be missing in pictures", [&] {
        const DrawTimer time(renderInfo, "Forest pose");
        std::optional<PassState> passes;
        for (std::size_t i = 0; i < _used; ++i)
            if (const osg::ref_ptr<PosePage>& page = _lists[i].poses.page)
                _buffer->poses->prepare(*renderInfo.getState(), *page, passes);
    });
}

void CullLists::releaseGLObjects(osg::State* state) const {
    _buffer->releaseGLObjects(state);
    for (const List& list : _lists) {
        list.bark->releaseGLObjects(state);
        list.leaves->releaseGLObjects(state);
    }
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/CullLists.h>

#include <algorithm>

namespace osgTreeWind {

void CullLists::begin(unsigned frame, std::size_t shapes) {
    if (frame != _frame) {
        _frame = frame;
        _used = _stagesUsed = 0;
    }
    _first = _used;
    _open.assign(shapes * tierCount, 0);
}

InstanceList& CullLists::list(std::size_t shape, Tier tier, const PosePass* passes, PosePage* page) {
    std::size_t& open = _open[shape * tierCount + static_cast<std::size_t>(tier)];
    if (open != 0 && _lists[open - 1].trees->page == page)
        return *_lists[open - 1].trees;
    if (_used == _lists.size())
        _lists.emplace_back();
    List& list = _lists[_used++];
    open = _used;
    list.shape = shape;
    list.tier = tier;
    list.trees->clear();
    list.trees->passes = passes;
    list.trees->page = page;
    return *list.trees;
}

PoseStage* CullLists::stage(osgUtil::StateGraph* place) {
    if (_stagesUsed == _stages.size())
        _stages.push_back(new PoseStage);
    PoseStage* stage = _stages[_stagesUsed++].get();
    stage->begin(place);
    return stage;
}

void CullLists::countTrees(std::array<std::size_t, tierCount>& trees) const {
    for (std::size_t i = 0; i < _used; ++i)
        trees[static_cast<std::size_t>(_lists[i].tier)] += _lists[i].trees->size();
}

void CullLists::releaseGLObjects(osg::State* state) const {
    for (const List& list : _lists) {
        list.trees->values->getVertexBufferObject()->releaseGLObjects(state);
        list.bark->releaseGLObjects(state);
        list.leaves->releaseGLObjects(state);
    }
}

} // namespace osgTreeWind

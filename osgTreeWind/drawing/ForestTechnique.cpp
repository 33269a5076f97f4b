// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ForestTechnique.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <utility>

namespace osgTreeWind {

ForestTechnique::ForestTechnique() {
    setDataVariance(osg::Object::DYNAMIC);
}

ForestTechnique::ForestTechnique(const ForestTechnique& other, const osg::CopyOp& copyop)
    : osg::Group(other, osg::CopyOp(copyop.getCopyFlags() &
                                    ~(osg::CopyOp::DEEP_COPY_NODES | osg::CopyOp::DEEP_COPY_DRAWABLES))) {
    removeChildren(0, getNumChildren());
}

ForestTechnique::~ForestTechnique() = default;

void ForestTechnique::setSimulation(std::shared_ptr<ForestSimulation> simulation) {
    removeChildren(0, getNumChildren());
    _simulation = std::move(simulation);
    osg::StateSet& state = *getOrCreateStateSet();
    state.removeDefine("EXPOSURE");
    if (_simulation && _simulation->description().drawing.exposure > 0.0f)
        state.setDefine("EXPOSURE", numberText(_simulation->description().drawing.exposure));
}

bool ForestTechnique::stepsItself() const {
    return false;
}

void ForestTechnique::update(const osg::FrameStamp&, bool) {}

void ForestTechnique::treeChanged(TreeId) {}

void ForestTechnique::speciesAdded() {}

void ForestTechnique::seasonChanged() {}

BranchTransform* ForestTechnique::branch(TreeId, unsigned) {
    return nullptr;
}

bool ForestTechnique::releaseBranch(TreeId, unsigned) {
    return false;
}

InstancedForest* ForestTechnique::asInstancedForest() {
    return nullptr;
}

BranchwiseForest* ForestTechnique::asBranchwiseForest() {
    return nullptr;
}

} // namespace osgTreeWind

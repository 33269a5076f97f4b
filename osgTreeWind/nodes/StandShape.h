// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePass.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/nodes/TreeTiers.h>

#include <osg/Geometry>
#include <osg/StateSet>

namespace osgTreeWind {

/// What the trees of one model are drawn from, at each tier with branches; and the passes that pose them.
class StandShape : public osg::Referenced {
public:
    StandShape(const TreeModel& model, PosePrograms* programs);

    osg::Geometry* bark(Tier tier) const { return _bark[static_cast<int>(tier)].get(); }
    /// Null where there are none.
    osg::Geometry* leaves(Tier tier) const { return _leaves[static_cast<int>(tier)].get(); }
    /// Instead of the model's own, at every tier with branches.
    void setGeometry(osg::Geometry* bark, osg::Geometry* leaves);

    osg::StateSet* state() const { return _state.get(); }
    PosePass* passes() const { return _passes.get(); }

    void resizeGLObjectBuffers(unsigned maxSize);
    void releaseGLObjects(osg::State* state) const;

private:
    osg::ref_ptr<osg::Geometry> _bark[tierCount - 1], _leaves[tierCount - 1];
    osg::ref_ptr<PosePass> _passes;
    osg::ref_ptr<osg::StateSet> _state;
};

} // namespace osgTreeWind

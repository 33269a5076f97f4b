// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePass.h>
#include <osgTreeWind/motion/PlacedForest.h>
#include <osgTreeWind/nodes/SpeciesLooks.h>
#include <osgTreeWind/nodes/StandShape.h>

#include <vector>

namespace osgTreeWind {

/// What the trees of a stand are drawn from. A copy shares all of it.
struct StandDrawing {
    StandDrawing() = default;
    explicit StandDrawing(const PlacedForest& forest);

    std::vector<osg::ref_ptr<StandShape>> shapes; ///< By model.
    std::vector<SpeciesLooks> looks;              ///< By species.
    osg::ref_ptr<osg::StateSet> state;            ///< Of all trees with branches.
    osg::ref_ptr<osg::StateSet> fading;           ///< Of trees that cross over to another tier.
    osg::ref_ptr<osg::Program> impostorProgram;
    osg::ref_ptr<PosePrograms> programs;

    void resizeGLObjectBuffers(unsigned maxSize) const;
    void releaseGLObjects(osg::State* state) const;
};

} // namespace osgTreeWind

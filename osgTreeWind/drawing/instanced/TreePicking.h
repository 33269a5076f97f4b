// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/TreeCells.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgUtil/IntersectionVisitor>

namespace osgTreeWind {

/// Passes each tree whose bounds the intersection visitor hits to it, as a TreeHit. Between frames, or in any
/// traversal that does not move the trees.
void intersectTrees(osgUtil::IntersectionVisitor& visitor, const ForestSimulation& simulation,
                    const TreeCells& cells);

} // namespace osgTreeWind

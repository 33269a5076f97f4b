// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/TreeCells.h>
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgUtil/IntersectionVisitor>

namespace osgTreeWind {

/// Has an intersection visitor meet the trees that it may hit, each as a TreeHit. Between frames, or in
/// any traversal that does not move the trees.
void intersectTrees(osgUtil::IntersectionVisitor& visitor, const ForestSimulation& simulation,
                    const TreeCells& cells);

} // namespace osgTreeWind

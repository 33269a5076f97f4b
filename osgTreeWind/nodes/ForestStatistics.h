// SPDX-License-Identifier: MIT
#pragma once

#include <osg/NodeVisitor>

namespace osgTreeWind {

class Forest;
class TilePager;

/// What a forest costs and draws, for those who look at a view's statistics (osgViewer::StatsHandler): in the
/// osg::Stats of the view whose cull traversal it is, by the names that docs/view.md lists; of the forest
/// that was culled last. Nothing where nobody collects "update".
/// @param step,cull seconds that the last update and this cull traversal took. @param tiles null: none.
void reportStatistics(Forest& forest, osg::NodeVisitor& cullVisitor, double step, double cull,
                      const TilePager* tiles);

} // namespace osgTreeWind

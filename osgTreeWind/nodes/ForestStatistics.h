// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/DrawnTrees.h>

#include <osg/NodeVisitor>
#include <osg/Stats>

#include <optional>

namespace osgTreeWind {

/// What a forest costs and draws.
struct ForestStatistics {
    double step = 0.0, cull = 0.0; ///< Seconds that the last update and this cull traversal took.
    std::size_t trees = 0;
    std::optional<std::size_t> tiles; ///< Nothing: the forest has no tiles.
    std::optional<DrawnTrees> drawn;  ///< Of instances.

    /// For those who look at a view's statistics (osgViewer::StatsHandler): adds them to the osg::Stats of
    /// the view whose cull traversal this is, by the names that docs/view.md lists.
    void report(osg::Stats& stats, unsigned frame) const;
};

/// That the process has in memory.
double residentBytes();

/// The statistics of the view whose cull traversal this is; null where nobody collects "update".
osg::Stats* statisticsOf(osg::NodeVisitor& cullVisitor);

} // namespace osgTreeWind

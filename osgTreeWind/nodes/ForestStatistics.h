// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/DrawnTrees.h>

#include <osg/NodeVisitor>
#include <osg/Stats>

#include <optional>

namespace osgTreeWind {

/// Timings and counts of a forest, for osgViewer::StatsHandler.
struct ForestStatistics {
    double step = 0.0, cull = 0.0; ///< Duration of the last update and of this cull traversal, seconds.
    std::size_t trees = 0;
    std::optional<std::size_t> tiles; ///< Loaded tiles; empty for a forest without tiles.
    std::optional<DrawnTrees> drawn;  ///< Empty if the trees are not drawn as instances.

    /// Sets the attributes of a frame, by the names in docs/view.md.
    void report(osg::Stats& stats, unsigned frame) const;
};

/// The statistics of the view that a cull traversal belongs to; null if it does not collect "update".
osg::Stats* viewStatistics(osg::NodeVisitor& cullVisitor);

} // namespace osgTreeWind

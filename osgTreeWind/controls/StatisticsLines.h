// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec4>

#include <string>

namespace osgTreeWind {

/// Has OSG's statistics (key `s`) show what forests say of themselves in a view's osg::Stats (docs/view.md):
/// a line for each. Once for each handler, before its first key. @param handler an osgViewer::StatsHandler;
/// the library itself does without osgViewer.
template <typename StatsHandler>
void addStatisticsLines(StatsHandler& handler) {
    const osg::Vec4 color(0.6f, 1.0f, 0.5f, 1.0f);
    const auto line = [&](const std::string& name, const std::string& unit, float scale, float most) {
        handler.addUserStatsLine(name + unit, color, color, name, scale, unit == ", ms", false, "", "", most);
    };
    for (const char* name : {"Forest step", "Forest cull", "Forest pose", "Forest draw"})
        line(name, ", ms", 1000.0f, 100.0f);
    for (const char* name : {"Forest trees", "Forest trees in full", "Forest trees by boughs",
                             "Forest trees as pictures", "Forest tiles"})
        line(name, "", 1.0f, 1e6f);
    line("Process memory", ", MB", 1e-6f, 1e6f);
}

} // namespace osgTreeWind

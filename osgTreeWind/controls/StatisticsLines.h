// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec4>

#include <string>

namespace osgTreeWind {

/// Adds the attributes that forests report in a view's osg::Stats (docs/view.md) to OSG's statistics display
/// (key `s`), one line per attribute. Call it once per handler, before the display is first shown.
/// @param handler an osgViewer::StatsHandler; a template, as the library does not depend on osgViewer.
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

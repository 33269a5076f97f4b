// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

class Drawing;

/// A picture of the sway of one tree under the law `modal`: the path of its top from above, and the moment at
/// its foot over time.
class MotionPlot {
public:
    MotionPlot(const osgTreeWind::ForestSimulation& simulation, osgTreeWind::TreeId tree);

    void add(double time); ///< Adds the present state, at a later time than the last one, seconds.
    /// Writes SVG or PNG, by the file extension. Throws CommandError on failure.
    void write(const std::string& path) const;

private:
    /// State at one time.
    struct Point {
        double time = 0.0;
        std::optional<glm::vec2> shift; ///< Of the top, metres; empty: fallen.
        double moment = 0.0;            ///< kN m
    };
    /// Draws the points while the tree stands. @param at place of a point in the picture.
    template <typename At>
    void drawLine(Drawing& drawing, const At& at) const;
    void drawPath(Drawing& drawing) const;
    void drawMoment(Drawing& drawing) const;

    const osgTreeWind::ForestSimulation& _simulation;
    osgTreeWind::TreeId _tree;
    double _limit = 0.0; ///< Moment that fells the tree, kN m; 0: unknown.
    std::vector<Point> _points;
};

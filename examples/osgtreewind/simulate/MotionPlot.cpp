// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/simulate/MotionPlot.h>

#include <examples/osgtreewind/pictures/Drawing.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace osgTreeWind;

namespace {

using Align = Drawing::Align;

constexpr glm::dvec2 plotSize(1100.0, 520.0);
constexpr double top = 80.0, bottom = 450.0;
constexpr glm::vec3 gridGrey(0.85f), blue(0.0f, 0.45f, 0.7f), orange(0.84f, 0.37f, 0.0f);

/// Numbers along an axis, drawn from `from` to `to` in the picture.
struct Axis {
    double low, high, from, to;

    double at(double number) const { return from + (to - from) * (number - low) / (high - low); }
};

/// Draws a grid with labels. @param most labels along each axis.
void drawGrid(Drawing& drawing, const Axis& x, const Axis& y, int most) {
    for (const double number : ticksOf(x.low, x.high, most)) {
        drawing.setColour(gridGrey);
        drawing.drawLine({{x.at(number), y.from}, {x.at(number), y.to}});
        drawing.setColour(Drawing::black);
        drawing.write(tickText(number), {x.at(number), y.from + 16.0}, Align::Centre);
    }
    for (const double number : ticksOf(y.low, y.high, most)) {
        drawing.setColour(gridGrey);
        drawing.drawLine({{x.from, y.at(number)}, {x.to, y.at(number)}});
        drawing.setColour(Drawing::black);
        drawing.write(tickText(number), {x.from - 8.0, y.at(number)}, Align::Right);
    }
    drawing.drawLine({{x.from, y.to}, {x.from, y.from}, {x.to, y.from}});
}

} // namespace

MotionPlot::MotionPlot(const ForestSimulation& simulation, TreeId tree)
    : _simulation(simulation), _tree(tree) {}

void MotionPlot::add(double time) {
    Point& point = _points.emplace_back();
    point.time = time;
    if (const std::optional<TreeSway> sway = _simulation.sway(_tree)) {
        point.shift = sway->displacement;
        point.moment = 0.001 * sway->moment();
        _limit = 0.001 * sway->limit;
    }
}

template <typename At>
void MotionPlot::drawLine(Drawing& drawing, const At& at) const {
    std::vector<glm::dvec2> line;
    drawing.setColour(blue);
    for (const Point& point : _points) {
        if (point.shift)
            line.push_back(at(point));
        if (!point.shift || &point == &_points.back()) {
            drawing.drawLine(line, 1.2);
            line.clear();
        }
    }
}

void MotionPlot::drawPath(Drawing& drawing) const {
    glm::dvec2 low(0.0), high(0.0); // the place at rest is in the picture
    for (const Point& point : _points)
        if (point.shift) {
            low = glm::min(low, glm::dvec2(*point.shift));
            high = glm::max(high, glm::dvec2(*point.shift));
        }
    const glm::dvec2 middle = 0.5 * (low + high);
    const double half = 0.55 * std::max({high.x - low.x, high.y - low.y, 0.001}); // one scale for both axes
    const Axis east{middle.x - half, middle.x + half, 90.0, 90.0 + bottom - top},
        north{middle.y - half, middle.y + half, bottom, top};
    const auto at = [&](const glm::dvec2& shift) { return glm::dvec2(east.at(shift.x), north.at(shift.y)); };
    drawing.write("Path of the top from above, from its place at rest (+)", {east.from, top - 18.0},
                  Align::Left);
    drawGrid(drawing, east, north, 6);
    drawing.write("shift east (m)", {0.5 * (east.from + east.to), bottom + 40.0}, Align::Centre);
    drawing.write("shift north (m)", {28.0, 0.5 * (top + bottom)}, Align::Centre, 13.0, true);
    drawLine(drawing, [&](const Point& point) { return at(glm::dvec2(*point.shift)); });
    drawing.setColour(Drawing::black);
    const glm::dvec2 rest = at(glm::dvec2(0.0)), across(6.0, 0.0), along(0.0, 6.0);
    drawing.drawLine({rest - across, rest + across}, 1.5);
    drawing.drawLine({rest - along, rest + along}, 1.5);
}

void MotionPlot::drawMoment(Drawing& drawing) const {
    double largest = 0.0;
    for (const Point& point : _points)
        largest = std::max(largest, point.moment);
    const bool showsLimit = _limit > 0.0 && largest > 0.4 * _limit;
    const Axis time{_points.front().time, std::max(_points.back().time, _points.front().time + 1e-3), 560.0,
                    plotSize.x - 30.0},
        moment{0.0, 1.08 * std::max({largest, showsLimit ? _limit : 0.0, 1e-6}), bottom, top};
    drawing.write("Moment at the foot" + (_limit > 0.0
                                              ? "; it fails at " + tickText(std::round(_limit)) + " kN m"
                                              : std::string()),
                  {time.from, top - 18.0}, Align::Left);
    drawGrid(drawing, time, moment, 8);
    drawing.write("time (s)", {0.5 * (time.from + time.to), bottom + 40.0}, Align::Centre);
    drawing.write("moment (kN m)", {504.0, 0.5 * (top + bottom)}, Align::Centre, 13.0, true);
    if (showsLimit) {
        drawing.setColour(orange);
        drawing.drawLine({{time.from, moment.at(_limit)}, {time.to, moment.at(_limit)}}, 1.5);
    }
    drawLine(drawing,
             [&](const Point& point) { return glm::dvec2(time.at(point.time), moment.at(point.moment)); });
}

void MotionPlot::write(const std::string& path) const {
    Drawing drawing(path, plotSize);
    const TreePlacement placement = *_simulation.placementOf(_tree);
    const std::string name = placement.name.empty() ? std::to_string(slotOfTree(_tree)) : placement.name;
    char height[32];
    std::snprintf(height, sizeof height, "%.1f m high", static_cast<double>(placement.size.height));
    drawing.setColour(Drawing::black);
    drawing.write("Tree " + name + ": " + _simulation.description().species[placement.species].name + ", " +
                      height,
                  {70.0, 28.0}, Align::Left, 17.0);
    drawPath(drawing);
    drawMoment(drawing);
    drawing.finish();
}

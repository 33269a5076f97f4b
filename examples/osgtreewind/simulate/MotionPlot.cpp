// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/simulate/MotionPlot.h>

#include <examples/osgtreewind/output/CommandError.h>
#include <examples/osgtreewind/pictures/WritePicture.h>

#include <osgTreeWind/base/TemporaryPath.h>

#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <unistd.h>

using namespace osgTreeWind;

namespace {

/// Sizes in the picture.
constexpr double width = 1100.0, height = 520.0, top = 80.0, bottom = 450.0;

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

std::string numberOf(double number, const char* format = "%.6g") {
    char text[32];
    std::snprintf(text, sizeof text, format, number + 0.0); // no -0
    return text;
}

/// Numbers along an axis, drawn from `from` to `to` in the picture.
struct Axis {
    double low, high, from, to;

    double at(double number) const { return from + (to - from) * (number - low) / (high - low); }
    /// Distance of labels: 1, 2 or 5 times a power of ten, so that there are at most `most`.
    double step(double most) const {
        const double least = (high - low) / most, decade = std::pow(10.0, std::floor(std::log10(least)));
        for (const double digit : {1.0, 2.0, 5.0})
            if (digit * decade >= least)
                return digit * decade;
        return 10.0 * decade;
    }
};

class Drawing {
public:
    Drawing() {
        _out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
                "width=\""
             << width << "\" height=\"" << height << "\" viewBox=\"0 0 " << width << ' ' << height
             << "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"13\">\n"
                "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    }
    void text(double x, double y, const char* anchor, const std::string& words, const char* style = "") {
        _out << "<text x=\"" << numberOf(x, "%.1f") << "\" y=\"" << numberOf(y, "%.1f") << "\" text-anchor=\""
             << anchor << "\" " << style << '>' << escaped(words) << "</text>\n";
    }
    void upward(double x, double y, const std::string& words) {
        text(x, y, "middle", words,
             ("transform=\"rotate(-90 " + numberOf(x) + ' ' + numberOf(y) + ")\"").c_str());
    }
    void line(double x1, double y1, double x2, double y2, const char* style) {
        _out << "<line x1=\"" << numberOf(x1, "%.1f") << "\" y1=\"" << numberOf(y1, "%.1f") << "\" x2=\""
             << numberOf(x2, "%.1f") << "\" y2=\"" << numberOf(y2, "%.1f") << "\" " << style << "/>\n";
    }
    /// @param labels the most labels along each axis.
    void axes(const Axis& x, const Axis& y, double labels) {
        constexpr const char* grid = "stroke=\"#ddd\"";
        const double across = x.step(labels), upward = y.step(labels);
        for (double at = across * std::ceil(x.low / across - 1e-9); at <= x.high + 1e-9 * across;
             at += across) {
            line(x.at(at), y.from, x.at(at), y.to, grid);
            text(x.at(at), y.from + 18, "middle", numberOf(std::abs(at) < 1e-9 * across ? 0.0 : at));
        }
        for (double at = upward * std::ceil(y.low / upward - 1e-9); at <= y.high + 1e-9 * upward;
             at += upward) {
            line(x.from, y.at(at), x.to, y.at(at), grid);
            text(x.from - 8, y.at(at) + 4, "end", numberOf(std::abs(at) < 1e-9 * upward ? 0.0 : at));
        }
        _out << "<rect x=\"" << x.from << "\" y=\"" << y.to << "\" width=\"" << x.to - x.from
             << "\" height=\"" << y.from - y.to << "\" fill=\"none\" stroke=\"#666\"/>\n";
    }
    /// A point of the line; leaves out points that nobody can see apart.
    void add(double x, double y) {
        const std::string point = numberOf(x, "%.1f") + ',' + numberOf(y, "%.1f") + ' ';
        if (point == _last)
            return;
        _last = point;
        _points += point;
    }
    void endLine() {
        if (!_points.empty())
            _out
                << R"(<polyline fill="none" stroke="#0072b2" stroke-width="1.2" stroke-linejoin="round" points=")"
                << _points << "\"/>\n";
        _points.clear();
        _last.clear();
    }
    std::string finish() { return _out.str() + "</svg>\n"; }

private:
    std::ostringstream _out;
    std::string _points, _last;
};

} // namespace

MotionPlot::MotionPlot(const ForestSimulation& simulation, TreeId tree)
    : _simulation(simulation), _tree(tree) {}

void MotionPlot::add(double time) {
    Point& point = _points.emplace_back();
    point.time = time;
    if (const std::optional<TreeSway> sway = _simulation.sway(_tree)) {
        point.shift = sway->displacement;
        point.moment = sway->moment();
        _limit = sway->limit;
    }
}

std::string MotionPlot::svg() const {
    glm::vec2 low(0.0f), high(0.0f); // the place at rest is in the picture
    double largest = 0.0;
    for (const Point& point : _points) {
        if (!point.shift)
            continue;
        low = glm::min(low, *point.shift);
        high = glm::max(high, *point.shift);
        largest = std::max(largest, 0.001 * point.moment);
    }
    Drawing drawing;
    const TreePlacement placement = *_simulation.placementOf(_tree);
    const std::string name = placement.name.empty() ? std::to_string(slotOfTree(_tree)) : placement.name;
    drawing.text(70, 30, "start",
                 "Tree " + name + ": " + _simulation.description().species[placement.species].name + ", " +
                     numberOf(static_cast<double>(placement.size.height), "%.1f") + " m high",
                 "font-size=\"17\" font-weight=\"bold\"");

    // Both axes of the path have the same scale.
    const glm::dvec2 middle = 0.5 * glm::dvec2(low + high);
    const double half =
        0.55 * std::max({static_cast<double>(high.x - low.x), static_cast<double>(high.y - low.y), 0.001});
    const Axis east{middle.x - half, middle.x + half, 90.0, 90.0 + bottom - top},
        north{middle.y - half, middle.y + half, bottom, top};
    drawing.text(east.from, top - 14, "start", "Path of the top from above, from its place at rest (+)");
    drawing.axes(east, north, 6.0);
    drawing.text(0.5 * (east.from + east.to), bottom + 42, "middle", "shift east (m)");
    drawing.upward(32, 0.5 * (top + bottom), "shift north (m)");
    for (const Point& point : _points)
        if (point.shift)
            drawing.add(east.at(point.shift->x), north.at(point.shift->y));
        else
            drawing.endLine();
    drawing.endLine();
    constexpr const char* cross = "stroke=\"#000\" stroke-width=\"1.5\"";
    drawing.line(east.at(0) - 6, north.at(0), east.at(0) + 6, north.at(0), cross);
    drawing.line(east.at(0), north.at(0) - 6, east.at(0), north.at(0) + 6, cross);

    const double limit = 0.001 * _limit;
    const bool showsLimit = largest > 0.4 * limit && limit > 0.0;
    const Axis time{_points.front().time, std::max(_points.back().time, _points.front().time + 1e-3), 560.0,
                    width - 30.0},
        moment{0.0, 1.08 * std::max({largest, showsLimit ? limit : 0.0, 1e-6}), bottom, top};
    drawing.text(time.from, top - 14, "start",
                 "Moment at the foot" +
                     (limit > 0.0 ? "; limit " + numberOf(limit, "%.3g") + " kN m" : std::string()) +
                     (showsLimit ? " (dashed)" : ""));
    drawing.axes(time, moment, 8.0);
    drawing.text(0.5 * (time.from + time.to), bottom + 42, "middle", "time (s)");
    drawing.upward(504, 0.5 * (top + bottom), "moment (kN m)");
    if (showsLimit)
        drawing.line(time.from, moment.at(limit), time.to, moment.at(limit),
                     "stroke=\"#d55e00\" stroke-width=\"1.5\" stroke-dasharray=\"6 4\"");
    // Of the points in each half pixel, the least and the largest moment are drawn.
    std::size_t first = 0;
    const auto column = [&](std::size_t i) { return std::floor(2.0 * time.at(_points[i].time)); };
    for (std::size_t i = 1; i <= _points.size(); ++i) {
        const bool ends = i == _points.size() || column(i) != column(first) ||
                          _points[i].shift.has_value() != _points[first].shift.has_value();
        if (!ends)
            continue;
        if (_points[first].shift) {
            const auto isLess = [](const Point& a, const Point& b) { return a.moment < b.moment; };
            auto [least, most] =
                std::minmax_element(_points.begin() + static_cast<std::ptrdiff_t>(first),
                                    _points.begin() + static_cast<std::ptrdiff_t>(i), isLess);
            if (most < least)
                std::swap(least, most);
            for (const auto& point : {least, most})
                drawing.add(time.at(point->time), moment.at(0.001 * point->moment));
        } else {
            drawing.endLine();
        }
        first = i;
    }
    drawing.endLine();
    return drawing.finish();
}

void MotionPlot::write(const std::string& path) const {
    if (osgDB::getLowerCaseFileExtension(path) == "svg")
        return writeOrThrow(path, svg());
    const TemporaryPath drawing(path + '.' + std::to_string(getpid()) +
                                ".svg"); // OSG reads SVG from files only
    writeOrThrow(drawing.path(), svg());
    const osg::ref_ptr<osg::Image> picture = osgDB::readRefImageFile(drawing.path());
    if (!picture)
        throw CommandError{Failed, path + ": cannot be written: the svg plugin of OpenSceneGraph is missing; "
                                          "choose a name that ends in .svg"};
    writePicture(*picture, path);
}

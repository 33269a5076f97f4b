// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchReport.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace {

struct Point {
    int trees;
    double fps;
};

struct Series {
    std::string name, colour;
    std::vector<Point> points;
};

/// Colours safe for colour-blind readers (Okabe and Ito, Tol), in the order of benchStages().
const char* const colours[] = {"#000000", "#e69f00", "#0072b2", "#009e73", "#d55e00", "#cc79a7",
                               "#56b4e9", "#882255", "#999933", "#999999", "#332288"};

constexpr double top = 70.0, bottom = 400.0, panelWidth = 330.0;

std::vector<Series> publishedSeries() {
    std::vector<Series> all;
    for (std::size_t i = 0; i < benchStages().size(); ++i) {
        Series series{benchStages()[i].name, colours[i], {}};
        for (const int fps : benchStages()[i].thesisFps)
            series.points.push_back({static_cast<int>(series.points.size()) + 1, static_cast<double>(fps)});
        all.push_back(series);
    }
    return all;
}

std::vector<Series> measuredSeries(const std::vector<BenchResult>& results) {
    std::vector<Series> all;
    for (std::size_t i = 0; i < benchStages().size(); ++i) {
        Series series{benchStages()[i].name, colours[i], {}};
        for (const BenchResult& result : results)
            if (result.stage.name == series.name)
                series.points.push_back({result.trees, framesPerSecond(result.moving)});
        all.push_back(series);
    }
    return all;
}

/// Text escaped for XML.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

/// One set of axes: numbers of trees evenly spaced, frames per second on a logarithmic scale.
class Panel {
public:
    Panel(std::ostream& out, double left, const std::vector<Series>& all, double lowest, double highest)
        : _out(out), _left(left), _low(std::log10(lowest)), _high(std::log10(highest)) {
        for (const Series& series : all)
            for (const Point& point : series.points)
                _trees[point.trees] = 0.0;
        double place = 0.5;
        for (auto& [trees, x] : _trees)
            x = left + panelWidth * place++ / static_cast<double>(_trees.size());
    }

    void draw(const std::string& title, const std::vector<Series>& all) {
        text(_left, top - 14, "start", title, "font-weight=\"bold\"");
        for (double decade = std::pow(10.0, std::floor(_low)); decade < std::pow(10.0, _high); decade *= 10.0)
            for (const int digit : {1, 2, 5})
                gridLine(digit * decade);
        _out << "<line x1=\"" << _left << "\" y1=\"" << y(30.0) << "\" x2=\"" << _left + panelWidth
             << "\" y2=\"" << y(30.0) << "\" stroke=\"#888\" stroke-dasharray=\"5 4\"/>\n";
        text(_left + 4, y(30.0) + 14, "start", "30 fps", "fill=\"#666\"");
        for (const auto& [trees, x] : _trees)
            text(x, bottom + 18, "middle", std::to_string(trees));
        text(_left + panelWidth / 2, bottom + 40, "middle", "trees");
        for (const Series& series : all)
            line(series);
    }

private:
    double y(double fps) const { return bottom - (bottom - top) * (std::log10(fps) - _low) / (_high - _low); }
    void text(double x, double y, const char* anchor, const std::string& words, const char* style = "") {
        _out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\" " << style << ">"
             << escaped(words) << "</text>\n";
    }
    void gridLine(double fps) {
        if (std::log10(fps) < _low - 1e-9 || std::log10(fps) > _high + 1e-9)
            return;
        _out << "<line x1=\"" << _left << "\" y1=\"" << y(fps) << "\" x2=\"" << _left + panelWidth
             << "\" y2=\"" << y(fps) << "\" stroke=\"#ddd\"/>\n";
        std::ostringstream label;
        label << fps;
        text(_left - 8, y(fps) + 4, "end", label.str());
    }
    void line(const Series& series) {
        _out << R"(<polyline fill="none" stroke-width="2" stroke=")" << series.colour << R"(" points=")";
        for (const Point& point : series.points)
            _out << _trees[point.trees] << ',' << y(point.fps) << ' ';
        _out << "\"/>\n";
        for (const Point& point : series.points)
            _out << R"(<circle r="3.5" fill=")" << series.colour << R"(" cx=")" << _trees[point.trees]
                 << "\" cy=\"" << y(point.fps) << "\"/>\n";
    }

    std::ostream& _out;
    double _left, _low, _high;
    std::map<int, double> _trees; ///< Position of each number of trees.
};

/// Next smaller or larger number of the form 1, 2 or 5 times a power of ten.
double roundScale(double value, bool upward) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    double best = upward ? 10.0 * decade : decade;
    for (const double digit : {1.0, 2.0, 5.0})
        if (upward ? digit * decade >= value && digit * decade < best : digit * decade <= value)
            best = digit * decade;
    return best;
}

} // namespace

std::string benchChart(const BenchConditions& conditions, const std::vector<BenchResult>& results) {
    const std::vector<Series> published = publishedSeries(), measured = measuredSeries(results);
    double lowest = 10.0, highest = 100.0;
    for (const std::vector<Series>* all : {&published, &measured}) {
        for (const Series& series : *all) {
            for (const Point& point : series.points) {
                lowest = std::min(lowest, point.fps);
                highest = std::max(highest, point.fps);
            }
        }
    }
    lowest = roundScale(lowest, false);
    highest = roundScale(highest, true);

    std::ostringstream out;
    out << std::fixed << std::setprecision(1)
        << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- SPDX-License-Identifier: MIT -->\n"
           "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000\" height=\"500\" viewBox=\"0 0 1000 500\" "
           "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"13\">\n"
           "<rect width=\"1000\" height=\"500\" fill=\"#fff\"/>\n"
           "<text x=\"60\" y=\"28\" font-size=\"17\" font-weight=\"bold\">Frames a second by number of trees"
           "</text>\n";
    Panel(out, 60, published, lowest, highest).draw("As published, 2007 (tables 6.1 to 6.5)", published);
    Panel(out, 460, measured, lowest, highest)
        .draw("Here: " + std::to_string(conditions.settings.size.width) + "x" +
                  std::to_string(conditions.settings.size.height) + ", " + conditions.backend,
              measured);
    double y = top + 20;
    for (const Series& series : measured) {
        if (series.points.empty())
            continue;
        out << R"(<line x1="815" x2="840" y1=")" << y - 4 << R"(" y2=")" << y - 4
            << R"(" stroke-width="2" stroke=")" << series.colour
            << "\"/>\n<circle r=\"3.5\" cx=\"827.5\" cy=\"" << y - 4 << "\" fill=\"" << series.colour
            << "\"/>\n<text x=\"848\" y=\"" << y << "\">" << series.name << "</text>\n";
        y += 24;
    }
    out << "<text x=\"60\" y=\"465\" font-size=\"11\" fill=\"#555\">Left: Pentium M 1.86 GHz, ATI Mobility "
           "Radeon X300.</text>\n<text x=\"60\" y=\"483\" font-size=\"11\" fill=\"#555\">Right: "
        << escaped(machineName() + "; " + conditions.driver.renderer) << "; " << conditions.date.substr(0, 10)
        << ".</text>\n</svg>\n";
    return out.str();
}

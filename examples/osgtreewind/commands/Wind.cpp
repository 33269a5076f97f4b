// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/Json.h>
#include <examples/osgtreewind/pictures/WritePicture.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Viridis.h>
#include <osgTreeWind/wind/WindField.h>
#include <osgTreeWind/windfiles/WindFile.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <osg/Image>
#include <osg/ref_ptr>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

namespace {

using namespace osgTreeWind;

constexpr int longSide = 960, shortSide = 240; // pixels
constexpr int arrowCell = 32;                  // distance between arrows, pixels

struct Canvas {
    osg::ref_ptr<osg::Image> image = new osg::Image; ///< Lowest row first.

    explicit Canvas(const glm::ivec2& size) {
        image->allocateImage(size.x, size.y, 1, GL_RGB, GL_UNSIGNED_BYTE);
    }

    void set(int x, int y, const glm::vec3& colour) {
        if (x < 0 || y < 0 || x >= image->s() || y >= image->t())
            return;
        for (int i = 0; i < 3; ++i)
            image->data(x, y)[i] = static_cast<unsigned char>(std::lround(255.0f * colour[i]));
    }

    void line(const glm::vec2& from, const glm::vec2& to, const glm::vec3& colour) {
        const int steps = static_cast<int>(std::ceil(2.0f * glm::length(to - from)));
        for (int i = 0; i <= steps; ++i) {
            const glm::vec2 at =
                glm::mix(from, to, steps > 0 ? static_cast<float>(i) / static_cast<float>(steps) : 0.0f);
            set(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)), colour);
        }
    }

    /// Draws an arrow around its middle, or a dot for a length of 0.
    void arrow(const glm::vec2& middle, const glm::vec2& along, const glm::vec3& colour) {
        const glm::vec2 tip = middle + 0.5f * along, side(-along.y, along.x);
        line(middle - 0.5f * along, tip, colour);
        line(tip, tip - 0.3f * along + 0.18f * side, colour);
        line(tip, tip - 0.3f * along - 0.18f * side, colour);
    }
};

/// Draws a map of the lowest layer of a wind at time 0, north up: colours from dark blue (calm) to yellow
/// (`fastest`), and arrows in the direction of the air.
/// @param low, high corners in the scene, metres. @param fastest m/s.
osg::ref_ptr<osg::Image> drawArrows(const WindField& wind, const glm::dvec3& low, const glm::dvec3& high,
                                    double fastest) {
    glm::dvec2 extent = glm::dvec2(high - low);
    const double longest = std::max({extent.x, extent.y, 1.0});
    const glm::ivec2 size = glm::clamp(glm::ivec2(glm::round(extent / longest * double(longSide))),
                                       glm::ivec2(shortSide), glm::ivec2(longSide));
    Canvas canvas(size);
    const auto windAt = [&](const glm::dvec2& pixel) {
        const glm::dvec2 share = pixel / glm::dvec2(size);
        return wind.velocity(glm::vec3(low + glm::dvec3(share * extent, 0.0)), 0.0);
    };
    const double scale = 1.0 / std::max(fastest, 1e-9);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            canvas.set(x, y, viridis(glm::length(windAt({x + 0.5, y + 0.5})) * scale));
    for (int y = arrowCell / 2; y < size.y; y += arrowCell)
        for (int x = arrowCell / 2; x < size.x; x += arrowCell) {
            const glm::vec3 velocity = windAt({x, y});
            const bool bright = glm::length(velocity) * scale > 0.6;
            canvas.arrow({x, y}, glm::vec2(velocity) * static_cast<float>(0.9 * arrowCell * scale),
                         glm::vec3(bright ? 0.0f : 1.0f));
        }
    return canvas.image;
}

struct WindArguments {
    std::vector<std::string> files;
    std::vector<double> times;
    std::string unit;
    std::vector<std::string> variable;
    std::string crs;
    std::vector<double> at;
    std::string time = "0";
    std::string picture;
    bool json = false;
};

const char* heightsOf(const WindSummary& summary) {
    return summary.aboveGround ? "above the ground" : "above the zero of the file";
}

Json toJson(const WindSummary& summary) {
    Json times = {{"count", std::max<std::size_t>(1, summary.times.size())}};
    if (!summary.times.empty())
        times.update({{"first", summary.times.front()}, {"last", summary.times.back()}});
    if (!summary.start.empty())
        times["start"] = summary.start;
    return {{"format", summary.format},
            {"points", {summary.points.x, summary.points.y, summary.points.z}},
            {"extent", {{"low", vectorJson(summary.low)}, {"high", vectorJson(summary.high)}}},
            {"coordinates", summary.coordinates},
            {"crs", summary.crs},
            {"heights", heightsOf(summary)},
            {"unit", summary.unit},
            {"direction", summary.direction},
            {"times", times},
            {"speed", {{"slowest", summary.slowest}, {"fastest", summary.fastest}}},
            {"notes", summary.notes}};
}

std::string text(double number, int digits) {
    std::ostringstream out;
    out << std::setprecision(digits) << number;
    return out.str();
}

std::string text(const glm::dvec3& v, int digits) {
    return text(v.x, digits) + ", " + text(v.y, digits) + ", " + text(v.z, digits);
}

void print(const WindSummary& summary) {
    const auto row = [](const char* name) -> std::ostream& {
        return std::cout << std::left << std::setw(12) << name;
    };
    row("format") << summary.format << '\n';
    row("points") << summary.points.x << " east, " << summary.points.y << " north, " << summary.points.z
                  << " up\n";
    row("extent") << text(summary.low, 9) << " to " << text(summary.high, 9) << '\n';
    row("heights") << heightsOf(summary) << ", m\n";
    if (!summary.coordinates.empty())
        row("coordinates") << summary.coordinates << '\n';
    row("unit") << (summary.unit.empty() ? "not in the file" : summary.unit) << '\n';
    row("direction") << summary.direction << '\n';
    if (summary.times.empty())
        row("times") << "1\n";
    else
        row("times") << summary.times.size() << ", " << text(summary.times.front(), 9) << " to "
                     << text(summary.times.back(), 9) << " s\n";
    if (!summary.start.empty())
        row("start") << summary.start << '\n';
    row("speed") << text(summary.slowest, 4) << " to " << text(summary.fastest, 4) << " m/s\n";
    for (const std::string& note : summary.notes)
        row("note") << note << '\n';
}

/// Reads the wind with `origin` as the origin of the scene, where floats are exact.
WindFile load(const WindArguments& arguments, const glm::dvec3& origin) {
    WindFileOptions options;
    options.speedUnit = arguments.unit;
    options.variable = arguments.variable;
    options.origin = origin;
    options.crs = arguments.crs;
    options.low = glm::dvec2(-1000.0);
    options.high = glm::dvec2(1000.0);
    options.asStored = arguments.crs.empty();
    const bool alone = arguments.files.size() == 1 && arguments.times.empty();
    return valueOrThrow(alone ? readWindFile(arguments.files.front(), options)
                              : readWindFiles(arguments.files, arguments.times, options));
}

/// Seconds on the clock of the wind file; empty if the text is a date and the file has no dates.
std::optional<double> secondsOf(const std::string& time, const WindSummary& summary) {
    if (const auto seconds = parseNumber(time))
        return seconds;
    const auto asked = parseDate(time), start = parseDate(summary.start);
    return asked && start ? std::optional<double>(*asked - *start) : std::nullopt;
}

void printVelocity(const WindFile& wind, const WindArguments& arguments) {
    const std::vector<double>& at = arguments.at;
    const auto time = secondsOf(arguments.time, wind.summary);
    if (!time)
        throw CommandError{BadInput,
                           "--time: expected seconds, or a date and time if the file has dates; found " +
                               arguments.time};
    const glm::dvec3 velocity = asField(wind.wind)->velocity({0.0f, 0.0f, static_cast<float>(at[2])}, *time);
    if (!wind.covers(glm::dvec2(0.0)))
        std::cerr << arguments.files.front()
                  << ": note: the place is outside the grid of the file; this is the wind at the edge of the "
                     "grid\n";
    if (arguments.json) {
        std::cout << textOf(Json{{"at", {at[0], at[1], at[2]}},
                                 {"crs", arguments.crs.empty() ? wind.summary.crs : arguments.crs},
                                 {"heights", heightsOf(wind.summary)},
                                 {"time", *time},
                                 {"velocity", vectorJson(velocity)},
                                 {"speed", glm::length(velocity)},
                                 {"notes", wind.summary.notes}})
                  << '\n';
        return;
    }
    std::cout << text(velocity, 6) << " m/s toward east, north, up\n";
    printNotes(arguments.files.front(), wind.summary.notes);
}

void drawPicture(const WindArguments& arguments, const WindSummary& summary) {
    const glm::dvec3 corner{summary.low.x, summary.low.y, 0.0};
    const WindFile wind = load(arguments, corner);
    const auto image =
        drawArrows(*asField(wind.wind), summary.low - corner, summary.high - corner, summary.fastest);
    writePicture(*image, arguments.picture);
}

void run(const WindArguments& arguments) {
    glm::dvec3 origin(0.0);
    if (!arguments.at.empty())
        origin = {arguments.at[0], arguments.at[1], 0.0};
    const WindFile wind = load(arguments, origin);
    if (!arguments.at.empty())
        printVelocity(wind, arguments);
    else if (arguments.json)
        std::cout << textOf(toJson(wind.summary)) << '\n';
    else
        print(wind.summary);
    if (!arguments.picture.empty())
        drawPicture(arguments, wind.summary);
}

} // namespace

void addWindCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("wind", "Print what a wind file contains, or the wind at a place");
    auto arguments = std::make_shared<WindArguments>();
    command
        ->add_option("file", arguments->files,
                     "Wind files in order of time: ESRI ASCII or GeoTIFF pair, VTK, NetCDF, GRIB, TurbSim, "
                     "TOA5, QES XML or CSV")
        ->required();
    command
        ->add_option("--times", arguments->times,
                     "Times of several files, s: T1,T2,... (default: the times in the files)")
        ->delimiter(',')
        ->allow_extra_args(false);
    CLI::Option* at = command
                          ->add_option("--at", arguments->at,
                                       "Place to print the wind at: X,Y,Z in the coordinates of the file or "
                                       "of --crs; Z in m, counted as in the file")
                          ->delimiter(',')
                          ->expected(3)
                          ->check(between(-1e15, 1e15))
                          ->allow_extra_args(false);
    command
        ->add_option("--time", arguments->time,
                     "Time for --at: seconds since the first time of the file, or a date and time such as "
                     "2017-10-26T15:00Z (default: 0)")
        ->needs(at);
    command
        ->add_option(
            "--crs", arguments->crs,
            "Projected coordinate system of --at, such as EPSG:32611; velocities are turned to its axes")
        ->needs(at);
    command->add_option(
        "--unit", arguments->unit,
        "Unit of speeds: m/s, km/h, kn, mph, ft/s or another (default: that of the file, or m/s)");
    command
        ->add_option("--variable", arguments->variable,
                     "Wind of a VTK, NetCDF or GRIB file that has several: NAME, or EAST,NORTH[,UP] or "
                     "SPEED,DIRECTION (default: the usual names)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("-o,--output", arguments->picture,
                        "PNG file for a picture: arrows over colours of speed");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->footer("Example: osgtreewind wind wind.vtk --at 120,40,10");
    command->callback([arguments] { run(*arguments); });
}

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/windfiles/TextTokens.h>
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindInput.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

constexpr float noData = std::numeric_limits<float>::quiet_NaN();
constexpr double farthest = 1e9; // metres

struct Header {
    std::map<std::string, double> values;

    bool has(const char* key) const { return values.count(key) != 0; }
    double of(const char* key) const { return values.at(key); }
};

/// Keys and values up to the first line that begins with a number.
Header readHeader(TextTokens& tokens, std::string_view text) {
    Header header;
    while (tokens.good()) {
        TextTokens ahead = tokens;
        const std::string_view word = ahead.next();
        if (word.empty() || !std::isalpha(static_cast<unsigned char>(word.front())))
            break;
        const std::string key = lower(std::string(tokens.next()));
        const bool size = key == "ncols" || key == "nrows";
        if (size)
            header.values[key] = tokens.whole("a number of cells from 1 to 100000", 1, 100000);
        else if (key == "cellsize")
            header.values[key] = tokens.number("metres above 0", 1e-6, farthest);
        else if (key == "nodata_value")
            header.values[key] = tokens.number("a number", -1e300, 1e300);
        else if (key == "xllcorner" || key == "yllcorner" || key == "xllcenter" || key == "yllcenter")
            header.values[key] = tokens.number("metres within 1e9", -farthest, farthest);
        else
            tokens.fail(expectedFound("a key of an ESRI ASCII grid", key));
    }
    for (const char* key : {"ncols", "nrows", "cellsize"})
        if (!header.has(key))
            tokens.fail("expected " + std::string(key) + " in the header");
    for (const char* axis : {"x", "y"})
        if (header.has((axis + std::string("llcorner")).c_str()) ==
            header.has((axis + std::string("llcenter")).c_str()))
            tokens.fail("expected either " + std::string(axis) + "llcorner or " + axis +
                        "llcenter in the header");
    if (tokens.good() && header.of("ncols") * header.of("nrows") * 2 > static_cast<double>(text.size()) + 1)
        tokens.fail("the file is too short for " + numberText(header.of("ncols")) + " x " +
                    numberText(header.of("nrows")) + " cells");
    return header;
}

double firstCentre(const Header& header, const std::string& axis) {
    const std::string corner = axis + "llcorner", centre = axis + "llcenter";
    return header.has(corner.c_str()) ? header.of(corner.c_str()) + 0.5 * header.of("cellsize")
                                      : header.of(centre.c_str());
}

/// The name in the .prj beside a grid; empty without one.
std::string coordinatesBeside(const std::string& path) {
    std::ifstream file(fs::path(path).replace_extension(".prj"));
    std::string text, name;
    std::getline(file, text, '"');
    std::getline(file, name, '"');
    return name;
}

} // namespace

Result<EsriGrid> readEsriGrid(std::string_view text, const std::string& file) {
    TextTokens tokens(text, file);
    const Header header = readHeader(tokens, text);
    if (!tokens.good())
        return tokens.problem();
    EsriGrid grid;
    grid.cells = {header.of("ncols"), header.of("nrows")};
    grid.cellSize = header.of("cellsize");
    grid.south = {firstCentre(header, "x"), firstCentre(header, "y")};
    const auto columns = static_cast<std::size_t>(grid.cells.x),
               rows = static_cast<std::size_t>(grid.cells.y);
    const double missing = header.has("nodata_value") ? header.of("nodata_value") : -9999.0;
    grid.values.resize(columns * rows);
    for (std::size_t row = rows; row-- > 0;)
        for (std::size_t column = 0; column < columns; ++column) {
            const double value = tokens.number("a number", -1e30, 1e30);
            grid.values[row * columns + column] = value == missing ? noData : static_cast<float>(value);
            if (!tokens.good())
                return tokens.problem();
        }
    if (const std::string_view extra = tokens.next(); !extra.empty())
        tokens.fail(expectedFound("the end after " + std::to_string(columns * rows) + " cells", extra));
    if (!tokens.good())
        return tokens.problem();
    return grid;
}

Result<WindContent> windOfEsriGrids(const EsriGrid& speed, const EsriGrid& direction,
                                    const std::string& file) {
    const glm::dvec2 apart = glm::abs(speed.south - direction.south);
    const double tolerance = 1e-3 * speed.cellSize;
    if (speed.cells != direction.cells || std::max(apart.x, apart.y) > tolerance ||
        std::abs(speed.cellSize - direction.cellSize) * speed.cells.x > tolerance)
        return fileProblem(file, "expected the same header in both grids of the pair");
    WindContent content;
    content.summary.format = "ESRI ASCII speed and direction";
    content.summary.direction = "from, degrees clockwise from grid north";
    GridWind::Grid grid;
    grid.points = {speed.cells, 1};
    grid.origin = {speed.south, 0.0};
    grid.cell = {speed.cellSize, speed.cellSize, 1.0};
    grid.values.reserve(3 * speed.values.size());
    for (std::size_t i = 0; i < speed.values.size(); ++i) {
        const double s = speed.values[i], d = direction.values[i];
        const bool known = !std::isnan(s) && !std::isnan(d);
        if (known && (s < 0.0 || std::abs(d) > maxDirection))
            return fileProblem(file,
                               "expected a speed not below 0 and a direction of -360 to 360 degrees, found " +
                                   numberText(s) + " and " + numberText(d) + " in row " +
                                   std::to_string(speed.cells.y - static_cast<int>(i) / speed.cells.x) +
                                   ", column " + std::to_string(static_cast<int>(i) % speed.cells.x + 1));
        const glm::vec3 v = known ? windVelocity({s, d}, DirectionSense::From) : glm::vec3(noData);
        grid.values.insert(grid.values.end(), {v.x, v.y, v.z});
    }
    content.data = std::move(grid);
    return content;
}

Result<WindContent> readEsriPair(const std::string& path) {
    const fs::path given(path);
    const std::string stem = given.stem().string(), extension = given.extension().string();
    const std::string end = stem.size() > 4 ? stem.substr(stem.size() - 4) : "";
    if (end != "_vel" && end != "_ang")
        return fileProblem(path, "expected the name to end in _vel" + extension + " or _ang" + extension +
                                     ", a pair of speed and direction");
    const std::string begin = (given.parent_path() / stem.substr(0, stem.size() - 4)).string();
    EsriGrid grids[2];
    const std::string paths[2] = {begin + "_vel" + extension, begin + "_ang" + extension};
    for (int i = 0; i < 2; ++i) {
        const Result<std::string> text = readBytes(paths[i]);
        if (!text)
            return text.problems();
        Result<EsriGrid> grid = readEsriGrid(text.value(), paths[i]);
        if (!grid)
            return grid.problems();
        grids[i] = std::move(grid.value());
    }
    Result<WindContent> content = windOfEsriGrids(grids[0], grids[1], path);
    if (content)
        content.value().summary.coordinates = coordinatesBeside(path);
    return content;
}

} // namespace osgTreeWind

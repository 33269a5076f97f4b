// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/base/Number.h>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace osgTreeWind {

namespace {

constexpr float gravity = 9.81f; // as WRF has it

/// Sizes of the mass grid: times, layers, rows, columns.
struct Sizes {
    std::size_t t, z, y, x;
};

/// The mean of neighbours along one staggered axis of an array of blocks of (size + 1) * stride numbers.
std::vector<float> destaggered(const std::vector<float>& values, std::size_t blocks, std::size_t size,
                               std::size_t stride) {
    std::vector<float> means;
    means.reserve(blocks * size * stride);
    for (std::size_t block = 0; block < blocks; ++block)
        for (std::size_t i = 0; i < size * stride; ++i) {
            const std::size_t at = block * (size + 1) * stride + i;
            means.push_back(0.5f * (values[at] + values[at + stride]));
        }
    return means;
}

/// The model's map as PROJ writes it; empty where the file names none of those known here.
std::string mapOf(const NetCdfFile& file) {
    const auto attribute = [&](const char* name) {
        const std::optional<double> number = file.number(name);
        return number ? numberText(std::round(*number * 1e5) / 1e5) : std::string(); // a 32-bit float
    };
    const std::string kind = attribute("MAP_PROJ"), first = attribute("TRUELAT1"),
                      second = attribute("TRUELAT2"), middle = attribute("MOAD_CEN_LAT"),
                      meridian = attribute("STAND_LON");
    if (first.empty() || meridian.empty())
        return {};
    const std::string rest = " +lon_0=" + meridian + " +R=6370000";
    if (kind == "1" && !second.empty() && !middle.empty())
        return "+proj=lcc +lat_1=" + first + " +lat_2=" + second + " +lat_0=" + middle + rest;
    if (kind == "2")
        return "+proj=stere +lat_0=" + std::string(first[0] == '-' ? "-90" : "90") + " +lat_ts=" + first +
               rest;
    if (kind == "3")
        return "+proj=merc +lat_ts=" + first + rest;
    return {};
}

/// Where the model's grid stands.
struct Place {
    glm::dvec2 corner{0.0};        ///< The south-western cell at the first time, metres on the map.
    std::vector<glm::ivec2> moved; ///< By these cells east and north since then, at each time.
};

/// The numbers of an array over the cells, of one time for all or of each; none where it is of another shape.
std::vector<float> overCells(NetCdfFile& file, const char* name, const Sizes& n) {
    const NetCdfFile::Array array = file.array(name);
    std::vector<std::size_t> sizes;
    if (array)
        for (const NetCdfDimension& dimension : array->dimensions)
            sizes.push_back(dimension.size);
    const bool steady = sizes == std::vector<std::size_t>{n.y, n.x};
    if (!steady && sizes != std::vector<std::size_t>{n.t, n.y, n.x})
        return {};
    return file.read(*array, static_cast<double>(steady ? 1 : n.t) * static_cast<double>(n.y) *
                                 static_cast<double>(n.x));
}

/// The place by XLAT and XLONG; empty where they are not on the map, or not as far apart as the cells.
std::optional<Place> placeOn(const std::string& map, NetCdfFile& file, const Sizes& n,
                             const glm::dvec2& cell) {
    const Projection model(map);
    const std::vector<float> longitudes = overCells(file, "XLONG", n), latitudes = overCells(file, "XLAT", n);
    if (!model.good() || longitudes.empty() || latitudes.empty())
        return {};

    const glm::dvec2 size(n.x, n.y);
    Place place;
    for (std::size_t t = 0; t < n.t; ++t) {
        const std::size_t first = t * n.y * n.x, last = first + n.y * n.x - 1;
        const auto at = [](const std::vector<float>& numbers, std::size_t cell) {
            return numbers[cell % numbers.size()];
        };
        std::vector<glm::dvec2> corners = {{at(longitudes, first), at(latitudes, first)},
                                           {at(longitudes, last), at(latitudes, last)}};
        if (!model.toMap(corners))
            return {};
        const glm::dvec2 &corner = corners[0], &opposite = corners[1];
        if (t == 0)
            place.corner = corner;
        const glm::dvec2 cells = (opposite - corner) / cell, moved = (corner - place.corner) / cell;
        const glm::dvec2 off = glm::max(glm::abs(cells - (size - 1.0)), glm::abs(moved - glm::round(moved)));
        if (!(off.x < 0.1 && off.y < 0.1))
            return {};
        place.moved.emplace_back(glm::clamp(glm::round(moved), -size, size));
    }
    return place;
}

/// Velocities and heights at the centres of all cells.
struct Means {
    std::vector<float> u, v, w, height;
};

/// Puts one time behind those in the grid. @param moved cells by which the model's grid stands farther east
/// and north than it; where it does not reach, its edges hold.
void append(const Means& means, std::size_t t, const Sizes& n, const glm::ivec2& moved,
            GridWind::Grid& grid) {
    const glm::ivec2 last(static_cast<int>(n.x) - 1, static_cast<int>(n.y) - 1);
    for (std::size_t layer = t * n.z; layer < (t + 1) * n.z; ++layer)
        for (int y = 0; y <= last.y; ++y)
            for (int x = 0; x <= last.x; ++x) {
                const glm::ivec2 cell = glm::clamp(glm::ivec2(x, y) - moved, glm::ivec2(0), last);
                const std::size_t at =
                    (layer * n.y + static_cast<std::size_t>(cell.y)) * n.x + static_cast<std::size_t>(cell.x);
                grid.values.insert(grid.values.end(), {means.u[at], means.v[at], means.w[at]});
                grid.heights.push_back(means.height[at]);
            }
}

/// The arrays of a file, in the order of the names below.
constexpr const char* names[] = {"U", "V", "W", "PH", "PHB"};
using Arrays = std::vector<NetCdfFile::Array>;

Arrays arraysOf(NetCdfFile& file) {
    Arrays arrays;
    for (const char* name : names) {
        arrays.push_back(file.array(name));
        if (!arrays.back() || arrays.back()->dimensions.size() != 4)
            file.fail(name, "expected this array of 4 dimensions in WRF output");
    }
    return arrays;
}

Sizes sizesOf(NetCdfFile& file, const NetCdfArray& u) {
    const std::size_t t = u.dimensions[0].size, z = u.dimensions[1].size, y = u.dimensions[2].size,
                      x = u.dimensions[3].size;
    if (t < 1 || z < 1 || y < 1 || x < 2 || y > 100000 || x > 100000)
        file.fail("U", "expected at least one point in each direction, and 100000 at most");
    return {t, z, y, x - 1};
}

/// Velocities and heights, and the times and the unit of speed that go with them.
Means readMeans(NetCdfFile& file, const Arrays& arrays, const Sizes& n, GridWind::Grid& grid,
                WindSummary& summary) {
    const double t = static_cast<double>(n.t), z = static_cast<double>(n.z), y = static_cast<double>(n.y),
                 x = static_cast<double>(n.x);
    summary.unit = file.speedUnitOf({arrays[0], arrays[1], arrays[2]});
    const std::vector<float> east = file.read(*arrays[0], t * z * y * (x + 1.0)),
                             north = file.read(*arrays[1], t * z * (y + 1.0) * x),
                             up = file.read(*arrays[2], t * (z + 1.0) * (y * x));
    std::vector<float> heights = file.read(*arrays[3], t * (z + 1.0) * (y * x));
    const std::vector<float> base = file.read(*arrays[4], t * (z + 1.0) * (y * x));
    const auto times = file.array("XTIME");
    if (times)
        grid.times = file.seconds(*times, summary.start);
    if (!times || (file.good() && grid.times.size() != n.t))
        file.fail("XTIME", "expected " + std::to_string(n.t) + " times");
    if (!file.good())
        return {};
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = (heights[i] + base[i]) / gravity;
    return {destaggered(east, n.t * n.z * n.y, n.x, 1), destaggered(north, n.t * n.z, n.y, n.x),
            destaggered(up, n.t, n.z, n.y * n.x), destaggered(heights, n.t, n.z, n.y * n.x)};
}

/// Says where the model's grid stands, and what that leaves to be known.
void notePlace(const std::string& map, const std::optional<Place>& place, bool asStored,
               WindSummary& summary) {
    if (!place) {
        summary.notes.push_back(
            std::string(map.empty() ? "the file names no map that is known here (MAP_PROJ 1, 2 or 3)"
                                    : "XLAT and XLONG are not on the map and cells that the file names") +
            "; x and y are metres from the centre of the south-western cell");
        return;
    }
    summary.coordinates = map;
    const auto stands = [](const glm::ivec2& moved) { return moved == glm::ivec2(0); };
    if (!std::all_of(place->moved.begin(), place->moved.end(), stands))
        summary.notes.emplace_back(
            asStored ? "the model's grid moves; winds of later times are shown at the places that their "
                       "cells have at the first time, in a forest they are where they blew"
                     : "the model's grid moves; its winds are read at the cells of its "
                       "first time, edges held where later ones do not reach");
}

} // namespace

Result<WindContent> readNetCdfWrf(NetCdfFile& file, const WindRequest& request) {
    const bool asStored = request.asStored;
    const Arrays arrays = arraysOf(file);
    if (!file.good())
        return file.problem();
    const Sizes n = sizesOf(file, *arrays[0]);
    const glm::dvec2 cell(file.positive("DX"), file.positive("DY"));
    WindContent content;
    GridWind::Grid grid;
    const Means means = readMeans(file, arrays, n, grid, content.summary);
    if (!file.good())
        return file.problem();
    const std::string map = mapOf(file);
    const std::optional<Place> place = map.empty() ? std::nullopt : placeOn(map, file, n, cell);
    if (!file.good())
        return file.problem();

    grid.points = {static_cast<int>(n.x), static_cast<int>(n.y), static_cast<int>(n.z)};
    grid.cell = {cell, 1.0};
    if (place)
        grid.origin = {place->corner, 0.0};
    grid.values.reserve(3 * means.u.size());
    grid.heights.reserve(means.u.size());
    for (std::size_t step = 0; step < n.t; ++step)
        append(means, step, n, place && !asStored ? place->moved[step] : glm::ivec2(0), grid);
    content.summary.format = "NetCDF, WRF output";
    content.summary.direction = "components toward x, y and up of the model's grid";
    content.summary.notes = {"velocities at cell centres, means of the staggered neighbours",
                             "heights are (PH + PHB) / 9.81, metres above sea level, of each point and time"};
    notePlace(map, place, asStored, content.summary);
    content.data = std::move(grid);
    return content;
}

} // namespace osgTreeWind

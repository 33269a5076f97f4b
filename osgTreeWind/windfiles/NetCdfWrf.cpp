// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/NetCdfFile.h>

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
        for (const auto& dimension : array->GetDimensions())
            sizes.push_back(static_cast<std::size_t>(dimension->GetSize()));
    const bool steady = sizes == std::vector<std::size_t>{n.y, n.x};
    if (!steady && sizes != std::vector<std::size_t>{n.t, n.y, n.x})
        return {};
    return file.read(array, static_cast<double>(steady ? 1 : n.t) * static_cast<double>(n.y) *
                                static_cast<double>(n.x));
}

/// The place by XLAT and XLONG; empty where they are not on the map, or not as far apart as the cells.
std::optional<Place> placeOn(const std::string& map, NetCdfFile& file, const Sizes& n,
                             const glm::dvec2& cell) {
    OGRSpatialReference model;
    if (model.importFromProj4(map.c_str()) != OGRERR_NONE)
        return {};
    const Projection ways(model);
    const std::vector<float> longitudes = overCells(file, "XLONG", n), latitudes = overCells(file, "XLAT", n);
    if (!ways.toMap || longitudes.empty() || latitudes.empty())
        return {};

    const glm::dvec2 size(n.x, n.y);
    Place place;
    for (std::size_t t = 0; t < n.t; ++t) {
        const std::size_t first = t * n.y * n.x, last = first + n.y * n.x - 1;
        const auto at = [](const std::vector<float>& numbers, std::size_t cell) {
            return numbers[cell % numbers.size()];
        };
        double x[] = {at(longitudes, first), at(longitudes, last)},
               y[] = {at(latitudes, first), at(latitudes, last)};
        if (!ways.toMap->Transform(2, x, y))
            return {};
        const glm::dvec2 corner(x[0], y[0]), opposite(x[1], y[1]);
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

} // namespace

Result<WindContent> readNetCdfWrf(NetCdfFile& file, bool asStored) {
    NetCdfFile::Array arrays[5];
    const char* names[5] = {"U", "V", "W", "PH", "PHB"};
    for (int i = 0; i < 5; ++i) {
        arrays[i] = file.array(names[i]);
        if (!arrays[i] || arrays[i]->GetDimensionCount() != 4) {
            file.fail(names[i], "expected this array of 4 dimensions in WRF output");
            return file.problem();
        }
    }
    const auto& u = arrays[0]->GetDimensions();
    const Sizes n{static_cast<std::size_t>(u[0]->GetSize()), static_cast<std::size_t>(u[1]->GetSize()),
                  static_cast<std::size_t>(u[2]->GetSize()), static_cast<std::size_t>(u[3]->GetSize()) - 1};
    if (n.t < 1 || n.z < 1 || n.y < 1 || u[3]->GetSize() < 2 || u[2]->GetSize() > 100000 ||
        u[3]->GetSize() > 100000)
        file.fail("U", "expected at least one point in each direction, and 100000 at most");

    WindContent content;
    GridWind::Grid grid;
    const double layer = static_cast<double>(n.y) * static_cast<double>(n.x), t = static_cast<double>(n.t),
                 z = static_cast<double>(n.z);
    const double dx = file.positive("DX"), dy = file.positive("DY");
    content.summary.unit = file.speedUnitOf({arrays[0], arrays[1], arrays[2]});
    const std::vector<float> east =
        file.read(arrays[0], t * z * static_cast<double>(n.y) * static_cast<double>(n.x + 1));
    const std::vector<float> north =
        file.read(arrays[1], t * z * static_cast<double>(n.y + 1) * static_cast<double>(n.x));
    const std::vector<float> up = file.read(arrays[2], t * (z + 1.0) * layer);
    std::vector<float> heights = file.read(arrays[3], t * (z + 1.0) * layer);
    const std::vector<float> base = file.read(arrays[4], t * (z + 1.0) * layer);
    const auto times = file.array("XTIME");
    if (times)
        grid.times = file.seconds(times, content.summary.start);
    if (!times || (file.good() && grid.times.size() != n.t))
        file.fail("XTIME", "expected " + std::to_string(n.t) + " times");
    if (!file.good())
        return file.problem();

    const std::string map = mapOf(file);
    const std::optional<Place> place = map.empty() ? std::nullopt : placeOn(map, file, n, {dx, dy});
    if (!file.good())
        return file.problem();

    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = (heights[i] + base[i]) / gravity;
    const Means means{destaggered(east, n.t * n.z * n.y, n.x, 1), destaggered(north, n.t * n.z, n.y, n.x),
                      destaggered(up, n.t, n.z, n.y * n.x), destaggered(heights, n.t, n.z, n.y * n.x)};
    grid.points = {static_cast<int>(n.x), static_cast<int>(n.y), static_cast<int>(n.z)};
    grid.cell = {dx, dy, 1.0};
    grid.values.reserve(3 * means.u.size());
    grid.heights.reserve(means.u.size());
    for (std::size_t step = 0; step < n.t; ++step)
        append(means, step, n, place && !asStored ? place->moved[step] : glm::ivec2(0), grid);
    content.summary.format = "NetCDF, WRF output";
    content.summary.direction = "components toward x, y and up of the model's grid";
    content.summary.notes = {"velocities at cell centres, means of the staggered neighbours",
                             "heights are (PH + PHB) / 9.81, metres above sea level, of each point and time"};
    if (!place) {
        content.summary.notes.push_back(
            std::string(map.empty() ? "the file names no map that is known here (MAP_PROJ 1, 2 or 3)"
                                    : "XLAT and XLONG are not on the map and cells that the file names") +
            "; x and y are metres from the centre of the south-western cell");
    } else {
        grid.origin = {place->corner, 0.0};
        content.summary.coordinates = map;
        const auto stands = [](const glm::ivec2& moved) { return moved == glm::ivec2(0); };
        if (!std::all_of(place->moved.begin(), place->moved.end(), stands))
            content.summary.notes.emplace_back(
                asStored ? "the model's grid moves; winds of later times are shown at the places that their "
                           "cells have at the first time, in a forest they are where they blew"
                         : "the model's grid moves; its winds are read at the cells of its "
                           "first time, edges held where later ones do not reach");
    }
    content.data = std::move(grid);
    return content;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/weather/CfTime.h>
#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/places/CrsTransform.h>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace osgTreeWind {

namespace {

constexpr float wrfGravity = 9.81f;

/// Size of the mass grid: times, layers, rows, columns.
struct Sizes {
    std::size_t t, z, y, x;
};

/// Means of neighbours along the staggered axis of an array of blocks of (size + 1) * stride numbers.
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

/// PROJ text of the model's projection; empty if it is unknown.
std::string projText(const NetCdfFile& file) {
    const auto attribute = [&](const char* name) {
        const std::optional<double> number = file.number(name);
        return number ? numberText(std::round(*number * 1e5) / 1e5) : std::string(); // rounds a 32-bit float
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

/// Position of the model's grid.
struct GridPosition {
    glm::dvec2 corner{0.0};        ///< South-western cell at the first time, projected metres.
    std::vector<glm::ivec2> moved; ///< Cells east and north since the first time, at each time.
};

/// The cells of the model to be read.
struct Window {
    glm::ivec2 low{0}, high{0}; ///< Inclusive.

    std::size_t columns() const { return static_cast<std::size_t>(high.x - low.x + 1); }
    std::size_t rows() const { return static_cast<std::size_t>(high.y - low.y + 1); }
};

std::vector<std::size_t> range(int low, int high) {
    std::vector<std::size_t> indices;
    for (int i = low; i <= high; ++i)
        indices.push_back(static_cast<std::size_t>(i));
    return indices;
}

/// Reads an array over cells, with or without a time dimension; empty if it has another shape.
std::vector<float> readCells(NetCdfFile& file, const char* name, const Sizes& n,
                             const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns) {
    const NetCdfFile::Array array = file.array(name);
    std::vector<std::size_t> sizes;
    if (array)
        for (const NetCdfDimension& dimension : array->dimensions)
            sizes.push_back(dimension.size);
    if (sizes == std::vector<std::size_t>{n.y, n.x})
        return file.read(*array, {rows, columns});
    if (sizes == std::vector<std::size_t>{n.t, n.y, n.x})
        return file.read(*array, {allOf(n.t), rows, columns});
    return {};
}

/// The position from XLAT and XLONG; empty if they do not match the projection and cell size.
std::optional<GridPosition> findPosition(const Crs& map, NetCdfFile& file, const Sizes& n,
                                         const glm::dvec2& cell) {
    const auto transform = CrsTransform::between(Crs::wgs84(), map);
    // Reads the four corners; two opposite ones are used: the first and the last.
    const std::vector<std::size_t> rows = {0, n.y - 1}, columns = {0, n.x - 1};
    const std::vector<float> longitudes = readCells(file, "XLONG", n, rows, columns),
                             latitudes = readCells(file, "XLAT", n, rows, columns);
    if (!transform || longitudes.empty() || latitudes.empty())
        return {};
    const auto cornerAt = [&](std::size_t i, glm::dvec2& corner) {
        corner = {longitudes[i % longitudes.size()], latitudes[i % latitudes.size()]};
        return transform.value().apply(corner);
    };
    const glm::dvec2 size(n.x, n.y);
    GridPosition position;
    for (std::size_t t = 0; t < n.t; ++t) {
        glm::dvec2 corner, opposite;
        if (!cornerAt(4 * t, corner) || !cornerAt(4 * t + 3, opposite))
            return {};
        if (t == 0)
            position.corner = corner;
        const glm::dvec2 cells = (opposite - corner) / cell, moved = (corner - position.corner) / cell;
        const glm::dvec2 off = glm::max(glm::abs(cells - (size - 1.0)), glm::abs(moved - glm::round(moved)));
        if (!(off.x < 0.1 && off.y < 0.1))
            return {};
        position.moved.emplace_back(glm::clamp(glm::round(moved), -size, size));
    }
    return position;
}

/// The cells that are in a part of the grid at any time.
Window windowOf(const AxisPart& x, const AxisPart& y, const std::vector<glm::ivec2>& moved, const Sizes& n) {
    const glm::ivec2 first(static_cast<int>(x.indices.front()), static_cast<int>(y.indices.front())),
        last(static_cast<int>(x.indices.back()), static_cast<int>(y.indices.back())),
        end(static_cast<int>(n.x) - 1, static_cast<int>(n.y) - 1);
    Window window{end, glm::ivec2(0)};
    for (const glm::ivec2& cells : moved) {
        window.low = glm::min(window.low, glm::clamp(first - cells, glm::ivec2(0), end));
        window.high = glm::max(window.high, glm::clamp(last - cells, glm::ivec2(0), end));
    }
    return window;
}

/// Velocities and heights at cell centres.
struct CellValues {
    std::vector<float> u, v, w, height;
};

/// The part of the model to be read.
struct ModelPart {
    Sizes n;                ///< Size of the model.
    AxisPart x, y;          ///< Points of the grid.
    Window window;          ///< Cells of the file.
    std::size_t layers = 0; ///< Layers of the grid.
    WindExtent fileExtent;  ///< Extent of the file.

    std::size_t cells() const { return window.rows() * window.columns(); }
};

/// Appends one time, clamped to the edges of the model. @param moved displacement of the model in cells.
void append(const CellValues& means, std::size_t t, const ModelPart& part, const glm::ivec2& moved,
            GridWind::Grid& grid) {
    const glm::ivec2 last(static_cast<int>(part.n.x) - 1, static_cast<int>(part.n.y) - 1);
    for (std::size_t layer = t * part.layers; layer < (t + 1) * part.layers; ++layer)
        for (const std::size_t y : part.y.indices)
            for (const std::size_t x : part.x.indices) {
                const glm::ivec2 cell =
                    glm::clamp(glm::ivec2(x, y) - moved, glm::ivec2(0), last) - part.window.low;
                const std::size_t at =
                    (layer * part.window.rows() + static_cast<std::size_t>(cell.y)) * part.window.columns() +
                    static_cast<std::size_t>(cell.x);
                grid.values.insert(grid.values.end(),
                                   {means.u[at], means.v[at], means.w.empty() ? 0.0f : means.w[at]});
                if (!means.height.empty())
                    grid.heights.push_back(means.height[at]);
            }
}

/// Names of the arrays with levels, in the order of Arrays.
constexpr const char* names[] = {"U", "V", "W", "PH", "PHB"};
using Arrays = std::vector<NetCdfFile::Array>;

/// @param variable as WindFileOptions::variable.
bool hasLevels(const NetCdfFile& file, const std::vector<std::string>& variable) {
    const NetCdfFile::Array u = file.array("U");
    return u && u->dimensions.size() == 4 && (variable.empty() || variable.front() == "U");
}

void expectShape(NetCdfFile& file, const NetCdfArray& array, const std::vector<std::size_t>& sizes) {
    std::string expected, found;
    for (const std::size_t size : sizes)
        expected += (expected.empty() ? "" : " x ") + std::to_string(size);
    for (const NetCdfDimension& dimension : array.dimensions)
        found += (found.empty() ? "" : " x ") + std::to_string(dimension.size);
    if (expected != found)
        file.fail(array.name, "expected " + expected + " numbers, as U has them, found " + found);
}

/// Finds the staggered U, V, W, PH and PHB, or U10 and V10, and checks their shapes.
Arrays arraysOf(NetCdfFile& file, const std::vector<std::string>& variable, Sizes& n) {
    const bool levels = hasLevels(file, variable);
    Arrays arrays;
    const std::vector<std::string> wanted =
        levels ? std::vector<std::string>(names, names + 5) : std::vector<std::string>{"U10", "V10"};
    for (std::size_t i = 0; i < variable.size(); ++i)
        if (i >= (levels ? 3u : 2u) || variable[i] != wanted[i])
            file.fail({}, expectedFound("wind.variable = \"U\" or \"U10\" for WRF output", variable[i]));
    for (const std::string& name : wanted) {
        arrays.push_back(file.array(name));
        if (!arrays.back() || arrays.back()->dimensions.size() != (levels ? 4 : 3)) {
            file.fail(name, "expected this array of " + std::string(levels ? "4" : "3") +
                                " dimensions in WRF output");
            return arrays;
        }
    }
    const auto& of = arrays[0]->dimensions;
    n = levels ? Sizes{of[0].size, of[1].size, of[2].size, of[3].size - 1}
               : Sizes{of[0].size, 1, of[1].size, of[2].size};
    if (n.t < 1 || n.z < 1 || n.y < 1 || of.back().size < (levels ? 2u : 1u) || n.y > 100000 ||
        n.x > 100000) {
        file.fail(arrays[0]->name, "expected at least one point in each direction, and 100000 at most");
        return arrays;
    }
    if (!levels)
        expectShape(file, *arrays[1], {n.t, n.y, n.x});
    else {
        expectShape(file, *arrays[1], {n.t, n.z, n.y + 1, n.x});
        for (std::size_t i = 2; i < arrays.size(); ++i)
            expectShape(file, *arrays[i], {n.t, n.z + 1, n.y, n.x});
    }
    return arrays;
}

/// Reads times from XTIME; without a date they are relative to the start of the simulation.
void readTimes(NetCdfFile& file, const Sizes& n, GridWind::Grid& grid, WindSummary& summary) {
    const NetCdfFile::Array times = file.array("XTIME");
    if (!times || times->dimensions.size() > 1 ||
        (times->dimensions.empty() ? 1 : times->dimensions[0].size) != n.t)
        return file.fail("XTIME", "expected " + std::to_string(n.t) + " times");
    const std::string from = file.text("SIMULATION_START_DATE");
    std::string unit = times->unit.empty() ? "minutes" : times->unit;
    if (unit.find(" since ") == std::string::npos && !from.empty())
        unit += " since " + from;
    const Result<CfTimes> known = decodeCfTimes(file.coordinates(*times), unit, times->text("calendar"));
    if (!known)
        return file.fail("XTIME", known.problems().front().message);
    grid.times = known.value().seconds;
    summary.start = known.value().start;
}

/// Reads velocities and heights at cell centres.
CellValues readCellValues(NetCdfFile& file, const Arrays& arrays, const ModelPart& part, bool& aboveGround) {
    const Window& window = part.window;
    const std::vector<std::size_t> times = allOf(part.n.t), rows = range(window.low.y, window.high.y),
                                   columns = range(window.low.x, window.high.x);
    if (arrays.size() == 2)
        return {file.read(*arrays[0], {times, rows, columns}),
                file.read(*arrays[1], {times, rows, columns}),
                {},
                {}};
    const std::size_t t = part.n.t, z = part.n.z, cells = part.cells();
    const std::vector<std::size_t> layers = allOf(z), faces = allOf(z + 1);
    const std::vector<float> east = file.read(*arrays[0],
                                              {times, layers, rows, range(window.low.x, window.high.x + 1)}),
                             north = file.read(*arrays[1], {times, layers,
                                                            range(window.low.y, window.high.y + 1), columns}),
                             up = file.read(*arrays[2], {times, faces, rows, columns});
    std::vector<float> heights = file.read(*arrays[3], {times, faces, rows, columns});
    const std::vector<float> base = file.read(*arrays[4], {times, faces, rows, columns}),
                             ground = readCells(file, "HGT", part.n, rows, columns);
    if (!file.good())
        return {};
    aboveGround = !ground.empty();
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const std::size_t below = i / ((z + 1) * cells) * cells + i % cells;
        heights[i] =
            (heights[i] + base[i]) / wrfGravity - (aboveGround ? ground[below % ground.size()] : 0.0f);
    }
    return {destaggered(east, t * z * window.rows(), window.columns(), 1),
            destaggered(north, t * z, window.rows(), window.columns()), destaggered(up, t, z, cells),
            destaggered(heights, t, z, cells)};
}

/// Sets coordinates and notes on the position of the grid.
void notePosition(const std::string& map, const std::optional<GridPosition>& position, bool asStored,
                  WindSummary& summary) {
    if (!position) {
        summary.notes.push_back(
            std::string(map.empty() ? "the file has no supported projection (MAP_PROJ 1, 2 or 3)"
                                    : "XLAT and XLONG do not match the projection and cell size") +
            "; x and y are metres from the centre of the south-western cell");
        return;
    }
    summary.coordinates = map;
    const auto stands = [](const glm::ivec2& moved) { return moved == glm::ivec2(0); };
    if (!std::all_of(position->moved.begin(), position->moved.end(), stands))
        summary.notes.emplace_back(
            asStored ? "the model's grid moves; later winds are shown at the places of their cells at the "
                       "first time, in a forest they are placed where they blew"
                     : "the model's grid moves; its winds are read at the cells of the first time, "
                       "clamped to the edges of the grid at later times");
}

/// Sets format, direction and notes on velocities and heights.
void noteValues(bool levels, bool aboveGround, WindSummary& summary) {
    summary.format = "NetCDF, WRF output";
    summary.direction = "components toward x, y and up of the model's grid";
    if (!levels)
        summary.notes = {"velocities 10 m above ground"};
    else
        summary.notes = {"velocities at cell centres, means of the staggered neighbours",
                         aboveGround
                             ? "heights are (PH + PHB) / 9.81 minus the terrain of the model, HGT, at each "
                               "point and time"
                             : "heights are (PH + PHB) / 9.81, metres above sea level, at each point "
                               "and time"};
}

/// The part around the requested area, or all.
ModelPart partOf(NetCdfFile& file, const Sizes& n, const glm::dvec2& corner, const glm::dvec2& cell,
                 const std::vector<glm::ivec2>& moved, const std::string& crs, const WindRequest& request) {
    const EvenAxis x{corner.x, cell.x, n.x, 0.0}, y{corner.y, cell.y, n.y, 0.0};
    const Result<GridPart> wanted = gridPartFor(request, crs, x, y);
    if (!wanted) {
        file.fail({}, wanted.problems().front().message);
        return {};
    }
    ModelPart part{n, wanted.value().x, wanted.value().y, {}, n.z, wanted.value().fileExtent};
    part.window = windowOf(part.x, part.y, moved, n);
    return part;
}

} // namespace

bool isWrf(const NetCdfFile& file) {
    const NetCdfFile::Array u = file.array("U"), u10 = file.array("U10");
    if (u)
        return u->dimensions.size() == 4 && u->dimensions[3].name == "west_east_stag";
    return u10 && u10->dimensions.size() == 3 && u10->dimensions[2].name == "west_east";
}

Result<WindContent> readNetCdfWrf(NetCdfFile& file, const WindRequest& request) {
    WindContent content;
    GridWind::Grid grid;
    Sizes n{};
    const Arrays arrays = arraysOf(file, request.variable, n);
    const glm::dvec2 cell(file.positiveNumber("DX"), file.positiveNumber("DY"));
    if (!file.good())
        return file.problem();
    const std::string map = projText(file);
    const Result<Crs> crs = map.empty() ? Result<Crs>(Crs()) : Crs::parse(map);
    std::optional<GridPosition> position;
    if (!map.empty() && crs)
        position = findPosition(crs.value(), file, n, cell);
    const std::vector<glm::ivec2> moved =
        position && !request.asStored ? position->moved : std::vector<glm::ivec2>(n.t, glm::ivec2(0));
    if (position)
        content.summary.crs = crs.value().text();
    const glm::dvec2 corner = position ? position->corner : glm::dvec2(0.0);
    const ModelPart part = partOf(file, n, corner, cell, moved, content.summary.crs, request);
    if (!file.good())
        return file.problem();
    content.summary.unit = file.speedUnitOf({arrays.begin(), arrays.begin() + (arrays.size() == 2 ? 2 : 3)});
    content.fileExtent = part.fileExtent;
    const CellValues means = readCellValues(file, arrays, part, grid.aboveGround);
    readTimes(file, n, grid, content.summary);
    if (!file.good())
        return file.problem();

    grid.points = {static_cast<int>(part.x.indices.size()), static_cast<int>(part.y.indices.size()),
                   static_cast<int>(n.z)};
    grid.cell = {cell, 1.0};
    grid.origin = {part.x.first, part.y.first, 0.0};
    for (std::size_t step = 0; step < n.t; ++step)
        append(means, step, part, moved[step], grid);
    noteValues(arrays.size() > 2, grid.aboveGround, content.summary);
    if (arrays.size() == 2) {
        grid.heights = {10.0f};
        grid.aboveGround = true;
    }
    notePosition(map, position, request.asStored, content.summary);
    content.data = std::move(grid);
    return content;
}

} // namespace osgTreeWind

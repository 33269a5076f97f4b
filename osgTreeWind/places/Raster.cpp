// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/Raster.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/places/MapProgram.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// As GDALApplyGeoTransform() does.
glm::dvec2 transformed(const std::array<double, 6>& transform, const glm::dvec2& point) {
    return {transform[0] + point.x * transform[1] + point.y * transform[2],
            transform[3] + point.x * transform[4] + point.y * transform[5]};
}

} // namespace

Result<Raster> Raster::open(const std::string& path) {
    MapProgram program({path});
    return open(path, program);
}

Result<Raster> Raster::open(const std::string& path, MapProgram& program, const std::string& band) {
    if (const auto problem = problemOfInput(path))
        return *problem;
    const auto head = program.ask<RasterHead>({MapQuestion::Task::ReadRaster, {path, band}});
    if (!head)
        return head.problems();
    Raster raster;
    raster._path = path;
    if (const auto& crs = head.value().crs)
        raster._crs = Crs(*crs);
    raster._columns = head.value().columns;
    raster._rows = head.value().rows;
    raster._toPlace = head.value().toPlace;
    raster._toCell = head.value().toCell;
    const auto cells = static_cast<std::size_t>(raster._columns) * static_cast<std::size_t>(raster._rows);
    const std::string size = std::to_string(raster._columns) + " x " + std::to_string(raster._rows);
    if (const std::string memory = problemOfMemory("its " + size + " cells", cells * sizeof(float));
        !memory.empty())
        return fileProblem(path, memory);
    raster._heights.reserve(cells);
    while (raster._heights.size() < cells) {
        const auto rows = program.get<std::vector<float>>();
        if (!rows)
            return rows.problems();
        raster._heights.insert(raster._heights.end(), rows.value().begin(), rows.value().end());
    }
    return raster;
}

glm::dvec2 Raster::placeOf(const glm::dvec2& cell) const {
    return transformed(_toPlace, cell);
}

std::optional<double> Raster::height(const glm::dvec2& place) const {
    constexpr double rounding = 1e-6; // cells; of places on the edge, and of those on a centre beside a hole
    const glm::dvec2 cell = transformed(_toCell, place);
    if (!(cell.x >= -rounding && cell.x <= _columns + rounding && cell.y >= -rounding &&
          cell.y <= _rows + rounding))
        return std::nullopt;
    const double u = std::clamp(cell.x - 0.5, 0.0, _columns - 1.0),
                 v = std::clamp(cell.y - 0.5, 0.0, _rows - 1.0);
    double height = 0.0, weights = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        const double x = std::floor(u) + (corner & 1), y = std::floor(v) + (corner >> 1),
                     weight = (1.0 - std::abs(u - x)) * (1.0 - std::abs(v - y));
        if (weight <= rounding)
            continue;
        const float known = _heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(_columns) +
                                     static_cast<std::size_t>(x)];
        if (std::isnan(known))
            return std::nullopt;
        height += weight * static_cast<double>(known);
        weights += weight;
    }
    return height / weights;
}

} // namespace osgTreeWind

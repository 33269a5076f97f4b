// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/Raster.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/places/MapProgram.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Applies a GDAL geotransform.
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
    const auto header = program.request<RasterHeader>({MapRequest::Task::ReadRaster, {path, band}});
    if (!header)
        return header.problems();
    Raster raster;
    raster._path = path;
    if (const auto& crs = header.value().crs)
        raster._crs = Crs(*crs);
    raster._columns = header.value().columns;
    raster._rows = header.value().rows;
    raster._geotransform = header.value().geotransform;
    raster._inverseGeotransform = header.value().inverseGeotransform;
    const auto cells = static_cast<std::size_t>(raster._columns) * static_cast<std::size_t>(raster._rows);
    const std::string size = std::to_string(raster._columns) + " x " + std::to_string(raster._rows);
    if (const std::string memory = problemOfMemory("its " + size + " cells", cells * sizeof(float));
        !memory.empty())
        return fileProblem(path, memory);
    raster._heights.reserve(cells);
    while (raster._heights.size() < cells) {
        const auto rows = program.receiveNext<std::vector<float>>();
        if (!rows)
            return rows.problems();
        raster._heights.insert(raster._heights.end(), rows.value().begin(), rows.value().end());
    }
    return raster;
}

glm::dvec2 Raster::placeOf(const glm::dvec2& cell) const {
    return transformed(_geotransform, cell);
}

std::optional<double> Raster::height(const glm::dvec2& place) const {
    // In cells: includes places on the edge, and ignores a hole next to a place on a cell's centre.
    constexpr double tolerance = 1e-6;
    const glm::dvec2 cell = transformed(_inverseGeotransform, place);
    if (!(cell.x >= -tolerance && cell.x <= _columns + tolerance && cell.y >= -tolerance &&
          cell.y <= _rows + tolerance))
        return std::nullopt;
    const double u = std::clamp(cell.x - 0.5, 0.0, _columns - 1.0),
                 v = std::clamp(cell.y - 0.5, 0.0, _rows - 1.0);
    double height = 0.0, weights = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        const double x = std::floor(u) + (corner & 1), y = std::floor(v) + (corner >> 1),
                     weight = (1.0 - std::abs(u - x)) * (1.0 - std::abs(v - y));
        if (weight <= tolerance)
            continue;
        const float value = _heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(_columns) +
                                     static_cast<std::size_t>(x)];
        if (std::isnan(value))
            return std::nullopt;
        height += weight * static_cast<double>(value);
        weights += weight;
    }
    return height / weights;
}

} // namespace osgTreeWind

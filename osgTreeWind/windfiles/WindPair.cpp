// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Trust.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>
#include <osgTreeWind/places/Crs.h>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

/// Reads an ESRI ASCII grid and the CRS from a .prj beside it.
Result<RasterBand> readAscii(const std::string& path) {
    const Result<std::string> text = readBytes(path);
    if (!text)
        return text.problems();
    Result<RasterBand> cells = readEsriGrid(text.value(), path);
    const std::string beside = toText(toPath(path).replace_extension(".prj"));
    if (const Result<std::string> map = readBytes(beside);
        cells && map && problemOfTrust(beside, {folderOf(path)}).empty()) {
        const Result<Crs> crs = Crs::parse(map.value());
        if (!crs)
            return fileProblem(beside, crs.problems().front().message);
        cells.value().crs = crs.value().text();
    }
    return cells;
}

/// The difference between both files of a pair; empty if they match.
std::string difference(const RasterBand& speed, const RasterBand& direction) {
    const glm::dvec2 apart = glm::abs(speed.southWest - direction.southWest);
    const double tolerance = 1e-3 * speed.cellSize;
    if (speed.cells != direction.cells || std::max(apart.x, apart.y) > tolerance ||
        std::abs(speed.cellSize - direction.cellSize) * speed.cells.x > tolerance)
        return "expected the same cells in both files of the pair";
    const bool sameMap = speed.crs.empty() || direction.crs.empty() || speed.crs == direction.crs;
    return sameMap ? "" : "expected the same map in both files of the pair";
}

} // namespace

Result<WindContent> windFromBands(const RasterBand& speed, const RasterBand& direction,
                                  const std::string& file) {
    if (const std::string problem = difference(speed, direction); !problem.empty())
        return fileProblem(file, problem);
    WindContent content;
    content.summary.direction = "from, degrees clockwise from grid north";
    content.summary.unit = canonicalUnit(Dimension::Speed, speed.unit);
    content.summary.crs = speed.crs.empty() ? direction.crs : speed.crs;
    if (!content.summary.crs.empty())
        content.summary.coordinates = Crs::parse(content.summary.crs).value().name();
    GridWind::Grid grid;
    grid.points = {speed.cells, 1};
    grid.origin = {speed.southWest, 0.0};
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
        const glm::vec3 v =
            known ? windVelocity({s, glm::radians(d)}, DirectionSense::From) : glm::vec3(noData);
        grid.values.insert(grid.values.end(), {v.x, v.y, v.z});
    }
    content.data = std::move(grid);
    return content;
}

/// Reads both files of a pair. @param path either of them.
Result<WindContent> readPair(const std::string& path, const char* format,
                             Result<RasterBand> (*readCells)(const std::string&)) {
    const std::string folder = folderOf(path), stem = stemOf(path), extension = extensionOf(path);
    const std::string end = stem.size() > 4 ? stem.substr(stem.size() - 4) : "";
    if (end != "_vel" && end != "_ang")
        return fileProblem(path, "expected the name to end in _vel" + extension + " or _ang" + extension +
                                     ", a pair of speed and direction");
    const std::string begin = toText(toPath(folder) / toPath(stem.substr(0, stem.size() - 4)));
    RasterBand cells[2];
    const char* const ends[] = {"_vel", "_ang"};
    for (int i = 0; i < 2; ++i) {
        std::string each = begin;
        each += ends[i] + extension;
        if (const std::string problem = problemOfTrust(each, {folder}); !problem.empty())
            return fileProblem(each, problem);
        Result<RasterBand> read = readCells(each);
        if (!read)
            return read.problems();
        cells[i] = std::move(read.value());
    }
    Result<WindContent> content = windFromBands(cells[0], cells[1], path);
    if (content)
        content.value().summary.format = format;
    return content;
}

Result<WindContent> readEsriPair(const std::string& path) {
    return readPair(path, "ESRI ASCII speed and direction", readAscii);
}

Result<WindContent> readTiffPair(const std::string& path) {
    return readPair(path, "GeoTIFF speed and direction", readGeoTiffBand);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/RasterGround.h>

#include <osgTreeWind/base/Problem.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

Result<std::shared_ptr<const RasterGround>> RasterGround::open(const Source& source, std::optional<Crs> map) {
    const auto ground = std::make_shared<RasterGround>();
    ground->_source = source;
    ground->_map = std::move(map);
    ground->_area = {glm::dvec2(1e300), glm::dvec2(-1e300), 1e300};
    if (!source.crs.empty()) {
        auto given = Crs::parse(source.crs);
        if (!given)
            return given.problems();
        ground->_given = given.value();
    }
    for (const std::string& file : source.files)
        if (Diagnostics problems = ground->add(file); !problems.empty())
            return problems;
    return std::shared_ptr<const RasterGround>(ground);
}

Diagnostics RasterGround::add(const std::string& file) {
    auto raster = Raster::open(file);
    if (!raster)
        return raster.problems();
    const std::optional<Crs>& crs = _given ? _given : raster.value().crs();
    const auto problem = [&](const std::string& message) { return Diagnostics{fileProblem(file, message)}; };
    if (!crs && _map)
        return problem("it has no coordinate reference system; expected ground.crs to say of what it is");
    Tile tile;
    if (crs) {
        if (!_map && !_tiles.empty())
            return problem("expected no coordinate reference system, as the file before it has none");
        if (!_map)
            if (Diagnostics problems = chooseMap(raster.value(), *crs); !problems.empty())
                return problems;
        const auto fromMap = CrsWay::between(*_map, *crs), toMap = CrsWay::between(*crs, *_map);
        if (!fromMap || !toMap)
            return problem((fromMap ? toMap : fromMap).problems().front().message);
        tile.fromMap = fromMap.value();
        tile.toMap = toMap.value();
        tile.isDegrees = crs->isDegrees();
    }
    tile.raster = std::move(raster.value());
    _tiles.push_back(std::move(tile));
    return cover(_tiles.back());
}

Diagnostics RasterGround::chooseMap(const Raster& raster, const Crs& crs) {
    if (crs.problemOfMap().empty()) {
        _map = crs;
        return {};
    }
    const glm::dvec2 middle = raster.placeOf(0.5 * glm::dvec2(raster.columns(), raster.rows()));
    const Result<Crs> zone = utmZoneOf(middle, crs, "ground.crs");
    if (!zone)
        return {fileProblem(raster.path(), zone.problems().front().message)};
    _map = zone.value();
    return {};
}

/// Grows the area over a tile: over points along its outline, as a map bends them.
Diagnostics RasterGround::cover(const Tile& tile) {
    constexpr int steps = 32;
    const glm::dvec2 size(tile.raster.columns(), tile.raster.rows());
    bool isSomewhere = false;
    for (int i = 0; i <= steps; ++i)
        for (int side = 0; side < 4; ++side) {
            const double along = static_cast<double>(i) / steps, across = side & 1;
            glm::dvec2 place = tile.raster.placeOf(
                size * (side & 2 ? glm::dvec2(along, across) : glm::dvec2(across, along)));
            if (!tile.toMap.go(place))
                continue;
            isSomewhere = true;
            _area.low = glm::min(_area.low, place);
            _area.high = glm::max(_area.high, place);
        }
    const auto placeOnMap = [&](const glm::dvec2& cell) {
        glm::dvec2 place = tile.raster.placeOf(cell);
        return tile.toMap.go(place) ? place : glm::dvec2(1e300);
    };
    const glm::dvec2 middle = 0.5 * size, here = placeOnMap(middle);
    for (const glm::dvec2& step : {glm::dvec2(1, 0), glm::dvec2(0, 1)})
        _area.cell = std::min(_area.cell, glm::distance(here, placeOnMap(middle + step)));
    if (isSomewhere && _area.cell > 0.0)
        return {};
    return {fileProblem(tile.raster.path(), "its places are not on the map of the forest, " +
                                                (_map ? _map->name() : "which is in metres"))};
}

std::optional<double> RasterGround::height(const glm::dvec2& place) const {
    for (const Tile& tile : _tiles) {
        glm::dvec2 there = place;
        if (tile.fromMap.transformation()) {
            const std::lock_guard lock(_mutex);
            if (!tile.fromMap.go(there))
                continue;
        }
        for (const double turn : {0.0, 360.0, -360.0}) { // longitudes from -180 or from 0
            if (const auto height = tile.raster.height(there + glm::dvec2(turn, 0.0)))
                return height;
            if (!tile.isDegrees)
                break;
        }
    }
    return std::nullopt;
}

} // namespace osgTreeWind

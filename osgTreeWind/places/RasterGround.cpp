// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/RasterGround.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/MapProgram.h>

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
        auto crs = Crs::parse(source.crs);
        if (!crs)
            return crs.problems();
        ground->_sourceCrs = crs.value();
    }
    const auto keepAlive = MapProgram::shared();
    MapProgram program(source.files);
    for (const std::string& file : source.files)
        if (Diagnostics problems = ground->add(file, program); !problems.empty())
            return problems;
    return std::shared_ptr<const RasterGround>(ground);
}

Diagnostics RasterGround::add(const std::string& file, MapProgram& program) {
    auto raster = Raster::open(file, program, _source.band);
    if (!raster)
        return raster.problems();
    const std::optional<Crs> crs = _sourceCrs ? _sourceCrs : raster.value().crs();
    const auto problem = [&](const std::string& message) { return Diagnostics{fileProblem(file, message)}; };
    if (!crs && _map)
        return problem("it has no coordinate reference system; expected ground.crs to state it");
    if (crs && !_map) {
        if (!_tiles.empty())
            return problem("expected no coordinate reference system, since the files before it have none");
        if (Diagnostics problems = chooseMap(raster.value(), *crs); !problems.empty())
            return problems;
    }
    _tiles.push_back({std::move(raster.value()), crs && crs->isDegrees()});
    return placeTile(_tiles.back(), crs);
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

/// Finds the transform of a tile, and extends the area by its outline, which the projection may bend.
Diagnostics RasterGround::placeTile(Tile& tile, const std::optional<Crs>& crs) {
    const auto problem = [&](const std::string& message) {
        return Diagnostics{fileProblem(tile.raster.path(), message)};
    };
    const auto toMap = crs ? CrsTransform::between(*crs, *_map) : CrsTransform();
    if (!toMap)
        return problem(toMap.problems().front().message);
    constexpr int steps = 32;
    const glm::dvec2 size(tile.raster.columns(), tile.raster.rows()), middle = 0.5 * size;
    std::vector<glm::dvec2> places = {tile.raster.placeOf(middle),
                                      tile.raster.placeOf(middle + glm::dvec2(1, 0)),
                                      tile.raster.placeOf(middle + glm::dvec2(0, 1))};
    const std::size_t outline = places.size();
    for (int i = 0; i <= steps; ++i)
        for (int side = 0; side < 4; ++side) {
            const double along = static_cast<double>(i) / steps, across = side & 1;
            places.push_back(tile.raster.placeOf(
                size * (side & 2 ? glm::dvec2(along, across) : glm::dvec2(across, along))));
        }
    toMap.value().apply(places);
    GroundArea area{glm::dvec2(1e300), glm::dvec2(-1e300), 1e300};
    for (std::size_t i = outline; i < places.size(); ++i)
        if (!std::isnan(places[i].x)) {
            area.low = glm::min(area.low, places[i]);
            area.high = glm::max(area.high, places[i]);
        }
    for (const int side : {1, 2})
        if (const double cell = glm::distance(places[0], places[side]); cell < area.cell)
            area.cell = cell;
    if (!(area.low.x <= area.high.x) || !(area.cell > 0.0))
        return problem("its places are not on the map of the forest, " +
                       (_map ? _map->name() : "which is in metres"));
    _area.low = glm::min(_area.low, area.low);
    _area.high = glm::max(_area.high, area.high);
    _area.cell = std::min(_area.cell, area.cell);
    if (toMap.value().isIdentity())
        return {};
    auto fromMap = CrsMesh::makeCubic(*_map, *crs, area.low, area.high);
    if (!fromMap)
        return problem(fromMap.problems().front().message);
    tile.fromMap = std::move(fromMap.value());
    return {};
}

std::optional<double> RasterGround::height(const glm::dvec2& place) const {
    for (const Tile& tile : _tiles) {
        if (tile.fromMap && !tile.fromMap->covers(place))
            continue;
        const glm::dvec2 tilePlace = tile.fromMap ? tile.fromMap->transformed(place) : place;
        for (const double turn : {0.0, 360.0, -360.0}) { // longitudes may start at -180 or at 0
            if (const auto height = tile.raster.height(tilePlace + glm::dvec2(turn, 0.0)))
                return height;
            if (!tile.isDegrees)
                break;
        }
    }
    return std::nullopt;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfLevels.h>

#include <plugins/weather/PointColumn.h>
#include <plugins/weather/Words.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

constexpr double standardGravity = 9.80665; // defines geopotential height

/// Metres per unit of an array of heights or geopotential; 0 for other units.
double metresIn(const NetCdfArray& array) {
    const std::string unit = lower(array.unit);
    if (isOneOf(unit, {"m", "gpm", "meter", "meters", "metre", "metres", "geopotential meters"}))
        return 1.0;
    return isOneOf(unit, {"m2 s-2", "m**2 s**-2", "m^2 s^-2", "m2/s2", "m^2/s^2", "m2.s-2", "j kg-1"})
               ? 1.0 / standardGravity
               : 0.0;
}

/// Extrapolates missing heights in steps of 1 m; without any height the wind becomes NaN.
void completeHeights(const PointColumn& column) {
    const std::size_t known = column.lowestWhere([](float height) { return !std::isnan(height); });
    if (known == column.layers)
        for (std::size_t layer = 0; layer < column.layers; ++layer) {
            column.height(layer) = static_cast<float>(layer + 1);
            *column.velocity(layer) = std::numeric_limits<float>::quiet_NaN();
        }
    for (std::size_t layer = std::min(known, column.layers - 1); layer-- > 0;)
        column.height(layer) = column.height(layer + 1) - 1.0f;
    for (std::size_t layer = known + 1; layer < column.layers; ++layer)
        if (std::isnan(column.height(layer)))
            column.height(layer) = column.height(layer - 1) + 1.0f;
}

/// Why a column cannot be read; empty if its heights increase upward.
std::string problemOf(const PointColumn& column) {
    for (std::size_t layer = 1; layer < column.layers; ++layer)
        if (const float below = column.height(layer - 1), above = column.height(layer); !(above > below))
            return "expected heights that increase upward, found " + numberText(below) + " m below " +
                   numberText(above) + " m";
    return {};
}

} // namespace

NetCdfLevels::NetCdfLevels(NetCdfFile& file, const NetCdfWinds& winds, NetCdfPoints& points) {
    points.levels = {0};
    if (points.level) {
        findLevels(file, *winds.pairs.front().first, points);
        return;
    }
    for (const NetCdfWindPair& pair : winds.pairs)
        if (pair.height)
            _heights.push_back(static_cast<float>(*pair.height));
    _aboveGround = !_heights.empty();
}

void NetCdfLevels::findLevels(NetCdfFile& file, const NetCdfArray& wind, NetCdfPoints& points) {
    const NetCdfDimension& level = *points.level;
    const NetCdfFile::Array coordinates = file.array(level.coordinates);
    const NetCdfMeasure measure = measureOf(file, level);
    const bool isHeight = measure == NetCdfMeasure::Metres || measure == NetCdfMeasure::None;
    points.levels = allOf(level.size);
    points.levelsAt = coordinatesOf(file, level);
    if (isHeight && (points.levelsAt.size() != level.size || level.size < 1 || level.size > 100000))
        return file.fail(level.name, "expected heights of this dimension, 1 to 100000 of them");
    if (!isHeight)
        findGeopotential(file, wind);
    if (!isHeight && !_geopotential)
        return file.fail(level.name,
                         "expected heights of these " +
                             std::string(measure == NetCdfMeasure::Pressure ? "pressure" : "model") +
                             " levels: an array of geopotential (z, zg or gh) on the same dimensions");
    if (!isHeight)
        findGround(file);
    if (isHeight ? points.levelsAt.front() > points.levelsAt.back() : !isUpward(file, points)) {
        std::reverse(points.levels.begin(), points.levels.end());
        std::reverse(points.levelsAt.begin(), points.levelsAt.end());
    }
    if (!isHeight)
        return;
    _heights.assign(points.levelsAt.begin(), points.levelsAt.end());
    _aboveGround = coordinates && (coordinates->text("standard_name") == "height" ||
                                   startsWithAny(lower(coordinates->name), {"height"}));
    if (_aboveGround)
        return;
    _origin = file.number("origin_z").value_or(0.0); // PALM
    for (float& height : _heights)
        height += static_cast<float>(_origin);
}

void NetCdfLevels::findGeopotential(const NetCdfFile& file, const NetCdfArray& wind) {
    const NetCdfRoles ofWind = rolesOf(file, wind);
    const std::string& level = wind.dimensions[*ofWind.level].name;
    const auto tells = [&](const NetCdfArray& array, bool byStandardName) {
        const NetCdfRoles roles = rolesOf(file, array);
        if (array.dimensions.size() < 3 || !roles.level || array.dimensions[*roles.level].name != level ||
            metresIn(array) == 0.0)
            return false;
        return byStandardName ? isOneOf(array.text("standard_name"),
                                        {"geopotential", "geopotential_height", "height", "altitude"})
                              : isOneOf(lower(array.name), {"z", "zg", "gh", "phi", "hgt", "geopotential"});
    };
    for (const bool byStandardName : {true, false})
        if (!_geopotential)
            _geopotential = file.find([&](const NetCdfArray& array) { return tells(array, byStandardName); });
    if (_geopotential)
        _geopotentialScale = metresIn(*_geopotential);
}

void NetCdfLevels::findGround(const NetCdfFile& file) {
    _ground = file.find([&](const NetCdfArray& array) {
        const NetCdfRoles roles = rolesOf(file, array);
        const std::size_t flat = 2 + (roles.time ? 1 : 0);
        if (array.dimensions.size() != flat || !roles.x || !roles.y || metresIn(array) == 0.0)
            return false;
        return isOneOf(array.text("standard_name"), {"surface_geopotential", "surface_altitude"}) ||
               isOneOf(lower(array.name), {"z", "zsfc", "z_sfc", "zs", "phis", "orog", "orography", "hsurf",
                                           "topography", "hgt", "surface_geopotential", "hgt_surface"});
    });
    if (_ground)
        _groundScale = metresIn(*_ground);
}

/// Checks the first point and time; for pressure levels, the coordinates.
bool NetCdfLevels::isUpward(NetCdfFile& file, const NetCdfPoints& points) const {
    if (measureOf(file, *points.level) == NetCdfMeasure::Pressure && points.levelsAt.size() > 1)
        return points.levelsAt.front() > points.levelsAt.back();
    NetCdfPoints one = points;
    one.times.resize(1);
    one.y.indices.resize(1);
    one.x.indices.resize(1);
    const std::vector<float> column = readAtPoints(file, *_geopotential, one);
    return column.size() < 2 || column.front() <= column.back();
}

void NetCdfLevels::setHeights(NetCdfFile& file, const NetCdfPoints& points, GridWind::Grid& grid,
                              WindSummary& summary) const {
    if (_origin != 0.0)
        summary.notes.push_back("heights include the model's origin_z, " + numberText(_origin) + " m");
    grid.heights = _heights;
    grid.aboveGround = _aboveGround || _ground;
    if (_geopotential)
        grid.heights = heightsOfPoints(file, points);
    if (!_geopotential || !file.good())
        return;
    std::size_t held = 0;
    forEachColumn(grid, [&](const PointColumn& column) {
        completeHeights(column);
        held += _ground ? column.replaceWindUpTo(0.0f) : 0;
        if (const std::string problem = problemOf(column); !problem.empty())
            file.fail(_geopotential->name, problem);
    });
    const std::string how = _geopotential->name + (_geopotentialScale == 1.0 ? "" : " over 9.80665");
    summary.notes.push_back(_ground
                                ? "heights are " + how + " minus the terrain of the model, " + _ground->name +
                                      ", at each point and time"
                                : "heights are " + how +
                                      ", metres above sea level, at each point and time; the file does not "
                                      "contain the terrain of the model");
    if (held > 0)
        summary.notes.push_back(
            std::to_string(held) + " of " + std::to_string(points.count()) +
            " velocities are below the terrain of the model and replaced by those of the lowest "
            "level above it");
}

/// Heights in the order time, level, row, column; NaN if missing.
std::vector<float> NetCdfLevels::heightsOfPoints(NetCdfFile& file, const NetCdfPoints& points) const {
    const std::vector<float> geopotential = readAtPoints(file, *_geopotential, points),
                             ground =
                                 _ground ? readAtPoints(file, *_ground, points, true) : std::vector<float>(1);
    std::vector<float> heights(file.good() ? points.count() : 0);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const std::size_t below = i / points.perTime() * points.perLevel() + i % points.perLevel();
        heights[i] = static_cast<float>(geopotential[i % geopotential.size()] * _geopotentialScale -
                                        ground[below % ground.size()] * _groundScale);
    }
    return heights;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfLevels.h>

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

/// The levels at one point and time. `stride` is the number of points between levels.
struct LevelColumn {
    float* heights;
    float* values;
    std::size_t levels, stride;
};

/// Extrapolates missing heights in steps of 1 m; without any height the wind becomes NaN.
void completeHeights(const LevelColumn& column) {
    const auto height = [&](std::size_t z) -> float& { return column.heights[z * column.stride]; };
    std::size_t known = 0;
    while (known < column.levels && std::isnan(height(known)))
        ++known;
    if (known == column.levels)
        for (std::size_t z = 0; z < column.levels; ++z) {
            height(z) = static_cast<float>(z + 1);
            column.values[3 * z * column.stride] = std::numeric_limits<float>::quiet_NaN();
        }
    for (std::size_t z = std::min(known, column.levels - 1); z-- > 0;)
        height(z) = height(z + 1) - 1.0f;
    for (std::size_t z = known + 1; z < column.levels; ++z)
        if (std::isnan(height(z)))
            height(z) = height(z - 1) + 1.0f;
}

/// Replaces winds at heights of 0 or less by that of the lowest level above. @return their number.
std::size_t fillBelowGround(const LevelColumn& column) {
    std::size_t lowest = 0;
    while (lowest < column.levels && column.heights[lowest * column.stride] <= 0.0f)
        ++lowest;
    if (lowest == column.levels)
        return 0;
    for (std::size_t z = 0; z < lowest; ++z)
        std::copy_n(column.values + 3 * lowest * column.stride, 3, column.values + 3 * z * column.stride);
    return lowest;
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
    grid.aboveGround = _aboveGround;
    if (!_geopotential)
        return;
    const std::vector<float> geopotential = readAtPoints(file, *_geopotential, points),
                             ground =
                                 _ground ? readAtPoints(file, *_ground, points, true) : std::vector<float>(1);
    if (!file.good())
        return;
    grid.aboveGround = _ground != nullptr;
    grid.heights.resize(points.count());
    for (std::size_t i = 0; i < grid.heights.size(); ++i) {
        const std::size_t below = i / points.perTime() * points.perLevel() + i % points.perLevel();
        grid.heights[i] = static_cast<float>(geopotential[i % geopotential.size()] * _geopotentialScale -
                                             (_ground ? ground[below % ground.size()] * _groundScale : 0.0));
    }
    std::size_t held = 0;
    for (std::size_t t = 0; t < points.times.size(); ++t)
        for (std::size_t i = 0; i < points.perLevel(); ++i) {
            const std::size_t at = t * points.perTime() + i;
            const LevelColumn column{&grid.heights[at], &grid.values[3 * at], points.levels.size(),
                                     points.perLevel()};
            completeHeights(column);
            held += grid.aboveGround ? fillBelowGround(column) : 0;
        }
    for (std::size_t i = points.perLevel(); i < grid.heights.size(); ++i)
        if (i % points.perTime() >= points.perLevel() &&
            !(grid.heights[i] > grid.heights[i - points.perLevel()]))
            return file.fail(_geopotential->name, "expected heights that increase upward, found " +
                                                      numberText(grid.heights[i - points.perLevel()]) +
                                                      " m below " + numberText(grid.heights[i]) + " m");
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

} // namespace osgTreeWind

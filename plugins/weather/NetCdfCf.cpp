// SPDX-License-Identifier: MIT
#include <plugins/weather/CfTime.h>
#include <plugins/weather/NetCdfCrs.h>
#include <plugins/weather/NetCdfLevels.h>
#include <plugins/weather/TrueNorth.h>

#include <osgTreeWind/wind/WindLimits.h>

#include <osgTreeWind/base/Number.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

using Array = NetCdfFile::Array;

/// Reads files of the CF conventions.
class CfReader {
public:
    CfReader(NetCdfFile& file, const WindRequest& request) : _file(file), _request(request) {}

    Result<WindContent> read() {
        summary().format = "NetCDF";
        _winds = windsOf(_file, _request.variable);
        if (_file.good())
            findPoints();
        summary().mayIncludeTrees = !isOfWeatherModel();
        if (_file.good())
            readValues();
        if (!_file.good())
            return _file.problem();
        _content.data = std::move(_grid);
        return std::move(_content);
    }

private:
    WindSummary& summary() { return _content.summary; }

    void findPoints() {
        const NetCdfArray &first = *_winds.pairs.front().first, &second = *_winds.pairs.front().second;
        const NetCdfRoles roles = rolesOf(_file, first);
        summary().direction = _winds.direction;
        summary().unit = _winds.unit;
        summary().notes = _winds.notes;
        _crs = readCrs(_file, first, _points, summary());
        useCentredColumns(second);
        if (!_file.good())
            return;
        chooseWindow();
        findTimes(first, roles);
        if (_file.good() && roles.level)
            _points.level = first.dimensions[*roles.level];
        noteOtherDimensions(first, roles);
    }

    /// Staggered components: takes x from the array that is staggered in y, which is centred in x.
    void useCentredColumns(const NetCdfArray& second) {
        const NetCdfRoles roles = rolesOf(_file, second);
        if (!_file.good() || !roles.x)
            return;
        const NetCdfAxis other = axisOf(_file, second.dimensions[*roles.x]);
        if (_file.good() && matchOf(_points.xAxis, other) == NetCdfMatch::Midway)
            _points.xAxis = other;
    }

    void chooseWindow() {
        const Result<GridPart> part = gridPartFor(_request, summary().crs, _points.xAxis.points,
                                                  _points.yAxis.points, _points.mapOffset);
        if (!part)
            return _file.fail({}, part.problems().front().message);
        AxisPart wholeX = wholeAxis(_points.xAxis.points), wholeY = wholeAxis(_points.yAxis.points);
        _points.x = part.value().x;
        _points.y = part.value().y;
        for (const Array& array : _winds.arrays()) {
            const NetCdfRoles roles = rolesOf(_file, *array);
            const auto clip = [&](const std::optional<std::size_t>& dimension, const NetCdfAxis& axis,
                                  AxisPart& wanted, AxisPart& whole) {
                if (!dimension)
                    return;
                const NetCdfAxis own = axisOf(_file, array->dimensions[*dimension]);
                clipToAxis(own, axis, wanted);
                clipToAxis(own, axis, whole);
            };
            clip(roles.x, _points.xAxis, _points.x, wholeX);
            clip(roles.y, _points.yAxis, _points.y, wholeY);
        }
        _content.fileExtent =
            extentOf(wholeX, _points.xAxis.points, wholeY, _points.yAxis.points, _points.mapOffset);
        _grid.origin = {_points.x.first + _points.mapOffset.x, _points.y.first + _points.mapOffset.y, 0.0};
        _grid.cell = {_points.x.step, _points.y.step, 1.0};
    }

    /// The array of times of a dimension: its coordinates, or another array with a reference date.
    Array timesOf(const NetCdfDimension& dimension) const {
        Array own = _file.array(dimension.coordinates);
        if (own && own->unit.find(" since ") != std::string::npos)
            return own;
        const Array other = _file.find([&](const NetCdfArray& array) {
            return array.dimensions.size() == 1 && array.dimensions[0].name == dimension.name &&
                   array.unit.find(" since ") != std::string::npos;
        });
        return other ? other : own;
    }

    void findTimes(const NetCdfArray& wind, const NetCdfRoles& roles) {
        _points.times = {0};
        Array times;
        if (roles.time) {
            _points.time = wind.dimensions[*roles.time];
            _points.times = allOf(_points.time->size);
            times = timesOf(*_points.time);
        } else
            times = _file.find([](const NetCdfArray& array) {
                return (array.dimensions.empty() ||
                        (array.dimensions.size() == 1 && array.dimensions[0].size == 1)) &&
                       array.unit.find(" since ") != std::string::npos &&
                       array.text("standard_name") != "forecast_reference_time";
            });
        if (times) {
            const Result<CfTimes> known =
                decodeCfTimes(_file.coordinates(*times), times->unit, times->text("calendar"));
            if (!known)
                return _file.fail(times->name, known.problems().front().message);
            summary().start = known.value().start;
            if (roles.time)
                _grid.times = known.value().seconds;
        }
        if (roles.time && (_grid.times.size() != _points.time->size || _grid.times.empty()))
            _file.fail(_points.time->name, "expected times of this dimension");
    }

    /// Notes ignored dimensions: months without a date, members of an ensemble.
    void noteOtherDimensions(const NetCdfArray& wind, const NetCdfRoles& roles) {
        for (std::size_t d = 0; d < wind.dimensions.size(); ++d) {
            const bool known =
                roles.time == d || roles.level == d || roles.y == d || roles.x == d || roles.version == d;
            const NetCdfDimension& dimension = wind.dimensions[d];
            if (!known && dimension.size == 0)
                _file.fail(dimension.name, "expected at least 1 of this dimension");
            if (!known && dimension.size > 1)
                summary().notes.push_back("only the first of " + std::to_string(dimension.size) + " along " +
                                          dimension.name +
                                          " is read, because this dimension is neither time nor space");
        }
    }

    /// Whether the cells are too large, or the levels of a kind that only weather models have.
    bool isOfWeatherModel() const {
        constexpr double coarse = 1000.0; // metres
        const NetCdfMeasure level = _points.level ? measureOf(_file, *_points.level) : NetCdfMeasure::None;
        return level == NetCdfMeasure::Pressure || level == NetCdfMeasure::Model ||
               _points.xAxis.isDegrees() || _grid.cell.x >= coarse;
    }

    void readValues() {
        const NetCdfLevels levels(_file, _winds, _points);
        const bool layered = _winds.pairs.size() > 1;
        const std::size_t layers = layered ? _winds.pairs.size() : _points.levels.size();
        _grid.points = {static_cast<int>(_points.x.indices.size()),
                        static_cast<int>(_points.y.indices.size()), static_cast<int>(layers)};
        if (!_file.good())
            return;
        for (std::size_t layer = 0; layer < _winds.pairs.size(); ++layer)
            addPair(_winds.pairs[layer], layer, layers);
        if (_file.good())
            levels.setHeights(_file, _points, _grid, summary());
        if (_file.good() && _winds.fromTrueNorth)
            turnToGrid();
    }

    /// @param layer the first layer of the pair; more follow if its arrays have levels.
    void addPair(const NetCdfWindPair& pair, std::size_t layer, std::size_t layers) {
        const std::vector<float> first = readAtPoints(_file, *pair.first, _points),
                                 second = readAtPoints(_file, *pair.second, _points),
                                 up = _winds.up ? readAtPoints(_file, *_winds.up, _points)
                                                : std::vector<float>();
        if (!_file.good())
            return;
        const auto expectAll = [&](const Array& array, const std::vector<float>& numbers) {
            if (numbers.size() != first.size() || first.size() != _points.count())
                _file.fail(array->name, "expected " + std::to_string(_points.count()) +
                                            " numbers, at all times, found " +
                                            std::to_string(numbers.size()));
        };
        expectAll(pair.first, first);
        expectAll(pair.second, second);
        if (_winds.up)
            expectAll(_winds.up, up);
        _grid.values.resize(3 * _points.times.size() * layers * _points.perLevel());
        for (std::size_t i = 0; i < first.size() && _file.good(); ++i) {
            const std::size_t time = i / _points.perTime(), rest = i % _points.perTime();
            const glm::vec3 velocity = velocityOf(pair, first[i], second[i], up.empty() ? 0.0f : up[i]);
            std::copy_n(&velocity.x, 3,
                        &_grid.values[3 * ((time * layers + layer) * _points.perLevel() + rest)]);
        }
    }

    glm::vec3 velocityOf(const NetCdfWindPair& pair, float a, float b, float up) {
        if (!_winds.isPolar)
            return {a, b, up};
        if (a < 0.0f || std::abs(b) > maxDirection)
            _file.fail(pair.second->name,
                       "expected speeds not below 0 and directions of -360 to 360, found " + numberText(a) +
                           " and " + numberText(b));
        return std::isnan(a) || std::isnan(b) ? glm::vec3(std::numeric_limits<float>::quiet_NaN())
                                              : windVelocity({a, glm::radians(b)}, _winds.sense);
    }

    /// Turns velocities from true north to the y axis of the grid, or only adds a note.
    void turnToGrid() {
        std::vector<std::string>& notes = summary().notes;
        if (!_crs) {
            notes.emplace_back(
                _request.asStored ? "velocities are relative to true north and the file gives no projection; "
                                    "in a forest its y axis is assumed to be true north"
                                  : "the file gives no projection; its y axis is assumed to be true north");
            return;
        }
        if (_crs->isDegrees() && !isRotated(*_crs))
            return;
        if (const auto note = turnFromTrueNorth(_grid, *_crs, _request.asStored))
            notes.push_back(*note);
        else if (_request.asStored)
            notes.emplace_back(
                "velocities are relative to true north; the projection does not cover the points");
        else
            _file.fail(_winds.pairs.front().first->name,
                       "the projection of this array does not cover its points");
    }

    NetCdfFile& _file;
    const WindRequest& _request;
    WindContent _content;
    GridWind::Grid _grid;
    NetCdfWinds _winds;
    NetCdfPoints _points;
    std::optional<Crs> _crs;
};

} // namespace

Result<WindContent> readNetCdfCf(NetCdfFile& file, const WindRequest& request) {
    return CfReader(file, request).read();
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

using Array = NetCdfFile::Array;

/// The array with one of these standard names, else with one of these names of its own.
Array named(const NetCdfFile& file, const std::vector<std::string>& standard,
            const std::vector<std::string>& own) {
    const auto among = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (Array found = file.find([&](const NetCdfArray& array) {
            return array.dimensions.size() >= 2 && among(standard, array.text("standard_name"));
        }))
        return found;
    return file.find([&](const NetCdfArray& array) {
        return array.dimensions.size() >= 2 && among(own, lower(array.name));
    });
}

/// The array whose name begins like this.
Array beginning(const NetCdfFile& file, const std::string& begin) {
    return file.find([&](const NetCdfArray& array) {
        return array.dimensions.size() >= 2 && lower(array.name).compare(0, begin.size(), begin) == 0;
    });
}

/// An even axis, upward or downward.
struct Axis {
    double first = 0.0, step = 1.0;
    std::size_t count = 1;
    bool backwards = false;
};

/// Which array holds what, on which axes.
class CfReader {
public:
    CfReader(NetCdfFile& file, bool asStored) : _file(file), _asStored(asStored) {}

    Result<WindContent> read() {
        findArrays();
        if (_file.good())
            readAxes();
        if (_file.good())
            readValues();
        if (!_file.good())
            return _file.problem();
        _content.data = std::move(_grid);
        return std::move(_content);
    }

private:
    void findArrays() {
        _content.summary.format = "NetCDF";
        if (!findComponents() && !findSpeedAndDirection())
            _file.fail({}, "expected arrays of wind: x_wind and y_wind, eastward_wind and northward_wind, u "
                           "and v, or wind_speed and wind_from_direction");
    }

    bool findComponents() {
        static constexpr const char* pairs[][2] = {{"x_wind", "y_wind"},
                                                   {"eastward_wind", "northward_wind"},
                                                   {"grid_eastward_wind", "grid_northward_wind"}};
        Array u, v;
        for (const auto& [east, north] : pairs)
            if (!u || !v) {
                u = named(_file, {east}, {});
                v = named(_file, {north}, {});
            }
        if (!u || !v) {
            u = named(_file, {}, {"u", "u10", "u-component"});
            v = named(_file, {}, {"v", "v10", "v-component"});
        }
        if (!u || !v)
            return false;
        _arrays = {u, v};
        const Array w = named(_file, {"upward_air_velocity"}, {"w"});
        if (w && w->dimensions.size() == u->dimensions.size())
            _arrays.push_back(w);
        // Data from GRIB have a flag; their name is the same either way.
        const std::string ofGrid = u->text("GRIB_uvRelativeToGrid");
        _fromTrueNorth = ofGrid.empty() ? u->text("standard_name") == "eastward_wind" : ofGrid == "0";
        _content.summary.direction = _fromTrueNorth ? "components toward true east, true north and up"
                                                    : "components toward x (east), y (north) and up";
        _content.summary.unit = _file.speedUnitOf(_arrays);
        return true;
    }

    bool findSpeedAndDirection() {
        const Array speed = named(_file, {"wind_speed"}, {"wind_speed", "speed"});
        const Array from =
            named(_file, {"wind_from_direction"}, {"wind_from_direction", "wind_direction", "direction"});
        const Array toward = named(_file, {"wind_to_direction"}, {"wind_to_direction"});
        _arrays = {speed ? speed : beginning(_file, "wind_speed"),
                   from     ? from
                   : toward ? toward
                            : beginning(_file, "wind_direction_from")};
        if (!_arrays[0] || !_arrays[1])
            return false;
        _polar = true;
        _sense = !from && toward ? DirectionSense::Toward : DirectionSense::From;
        const std::string unit = _arrays[1]->unit;
        if (!unit.empty() && unit.compare(0, 3, "deg") != 0)
            _file.fail(_arrays[1]->name, expectedFound("degrees", unit));
        const std::string name = _arrays[1]->text("standard_name");
        _fromTrueNorth = unit == "degree_true" || unit == "degrees_true" || name == "wind_from_direction" ||
                         name == "wind_to_direction";
        _content.summary.direction = std::string(_sense == DirectionSense::From ? "from" : "toward") +
                                     ", degrees clockwise from " +
                                     (_fromTrueNorth ? "true north" : "the grid's north");
        _content.summary.unit = _file.speedUnitOf({_arrays[0]});
        return true;
    }

    static bool isTime(const NetCdfDimension& dimension) {
        return dimension.temporal || lower(dimension.name)[0] == 't';
    }

    Axis evenAxis(const NetCdfDimension& dimension) {
        const std::vector<double> at = _file.metres(dimension);
        Axis axis;
        axis.count = dimension.size;
        if (at.size() != axis.count || axis.count < 1 || axis.count > 100000) {
            _file.fail(dimension.name, "expected coordinates of this dimension, 1 to 100000 of them");
            return axis;
        }
        const double step =
            axis.count > 1 ? (at.back() - at.front()) / static_cast<double>(axis.count - 1) : 1.0;
        axis.backwards = step < 0.0;
        axis.first = std::min(at.front(), at.back());
        axis.step = std::abs(step);
        for (std::size_t i = 0; i < at.size(); ++i)
            if (!(std::abs(at[i] - (at.front() + step * static_cast<double>(i))) <= 0.01 * axis.step))
                _file.fail(dimension.name, "expected evenly spaced coordinates");
        return axis;
    }

    void readHeights(const NetCdfDimension& dimension) {
        std::vector<double> at = _file.metres(dimension);
        _layers = dimension.size;
        if (at.size() != _layers || _layers < 1 || _layers > 100000)
            return _file.fail(dimension.name, "expected heights of this dimension, 1 to 100000 of them");
        _downward = at.front() > at.back();
        if (_downward)
            std::reverse(at.begin(), at.end());
        _grid.heights.assign(at.begin(), at.end());
    }

    void readTimes(const NetCdfDimension& dimension) {
        _steps = dimension.size;
        if (const Array times = _file.array(dimension.coordinates))
            _grid.times = _file.seconds(*times, _content.summary.start);
        if (_grid.times.size() != _steps || _steps < 1)
            _file.fail(dimension.name, "expected times of this dimension");
    }

    void readAxes() {
        const auto& dimensions = _arrays[0]->dimensions;
        const std::size_t count = dimensions.size();
        if (count > 4)
            return _file.fail(_arrays[0]->name, "expected dimensions (time, height, y, x) or fewer");
        _projection = _arrays[0]->projection();
        _content.summary.coordinates = _projection ? _projection->name() : "";
        _x = evenAxis(dimensions[count - 1]);
        _y = evenAxis(dimensions[count - 2]);
        if (count == 4 || (count == 3 && isTime(dimensions[0])))
            readTimes(dimensions[0]);
        if (count == 4 || (count == 3 && !isTime(dimensions[0])))
            readHeights(dimensions[count - 3]);
        _grid.points = {static_cast<int>(_x.count), static_cast<int>(_y.count), static_cast<int>(_layers)};
        _grid.origin = {_x.first, _y.first, 0.0};
        _grid.cell = {_x.step, _y.step, 1.0};
    }

    void readValues() {
        const double count = static_cast<double>(_x.count) * static_cast<double>(_y.count) *
                             static_cast<double>(_layers) * static_cast<double>(_steps);
        std::vector<std::vector<float>> values;
        for (const Array& array : _arrays)
            values.push_back(_file.read(*array, count));
        if (!_file.good())
            return;
        _grid.values.reserve(3 * values[0].size());
        for (std::size_t t = 0; t < _steps; ++t)
            for (std::size_t z = 0; z < _layers; ++z)
                for (std::size_t y = 0; y < _y.count; ++y)
                    for (std::size_t x = 0; x < _x.count; ++x)
                        add(values, indexOf(t, z, y, x));
        if (_file.good() && _fromTrueNorth)
            turnToGrid();
    }

    /// From true north to the y axis of the grid, or a note of what that would be.
    void turnToGrid() {
        std::vector<std::string>& notes = _content.summary.notes;
        if (!_projection || !_projection->isMap()) {
            notes.emplace_back(_asStored ? "the file counts from true north and names no projection; in a "
                                           "forest its y is taken as true north"
                                         : "the file names no projection; its y is taken as true north");
            return;
        }
        std::vector<glm::dvec2> points;
        for (std::size_t y = 0; y < _y.count; ++y)
            for (std::size_t x = 0; x < _x.count; ++x)
                points.emplace_back(_x.first + _x.step * static_cast<double>(x),
                                    _y.first + _y.step * static_cast<double>(y));
        const std::vector<glm::dvec2> norths = _projection->trueNorth(std::move(points));
        if (norths.empty() && _asStored)
            notes.emplace_back("the file counts from true north; its projection does not hold its points");
        else if (norths.empty())
            _file.fail(_arrays[0]->name, "the projection of this array does not hold its points");
        if (norths.empty())
            return;
        double least = 360.0, most = -360.0;
        for (const glm::dvec2& north : norths) {
            const double degrees = glm::degrees(std::atan2(north.x, north.y));
            least = std::min(least, degrees);
            most = std::max(most, degrees);
        }
        const auto rounded = [](double degrees) { return numberText(std::round(100.0 * degrees) / 100.0); };
        notes.push_back("the file counts from true north; " +
                        std::string(_asStored ? "in a forest its velocities" : "velocities here") +
                        " are turned to the grid's y axis, by " + rounded(least) + " to " + rounded(most) +
                        " degrees clockwise");
        if (_asStored)
            return;
        for (std::size_t i = 0; i < _grid.values.size(); i += 3) {
            const glm::dvec2 north = norths[i / 3 % norths.size()];
            const double u = _grid.values[i], v = _grid.values[i + 1];
            _grid.values[i] = static_cast<float>(u * north.y + v * north.x);
            _grid.values[i + 1] = static_cast<float>(v * north.y - u * north.x);
        }
    }

    /// The place in the file of a point of the grid.
    std::size_t indexOf(std::size_t t, std::size_t z, std::size_t y, std::size_t x) const {
        const std::size_t layer = t * _layers + (_downward ? _layers - 1 - z : z);
        const std::size_t row = layer * _y.count + (_y.backwards ? _y.count - 1 - y : y);
        return row * _x.count + (_x.backwards ? _x.count - 1 - x : x);
    }

    void add(const std::vector<std::vector<float>>& values, std::size_t i) {
        const float a = values[0][i], b = values[1][i];
        glm::vec3 velocity(a, b, values.size() > 2 ? values[2][i] : 0.0f);
        if (_polar && (a < 0.0f || std::abs(b) > maxDirection))
            _file.fail(_arrays[1]->name, "expected speeds not below 0 and directions of -360 to 360, found " +
                                             numberText(a) + " and " + numberText(b));
        else if (_polar)
            velocity = std::isnan(a) || std::isnan(b) ? glm::vec3(std::numeric_limits<float>::quiet_NaN())
                                                      : windVelocity({a, b}, _sense);
        _grid.values.insert(_grid.values.end(), {velocity.x, velocity.y, velocity.z});
    }

    NetCdfFile& _file;
    bool _asStored;
    WindContent _content;
    GridWind::Grid _grid;
    std::vector<Array> _arrays;
    std::optional<Projection> _projection;
    bool _polar = false, _fromTrueNorth = false, _downward = false;
    DirectionSense _sense = DirectionSense::From;
    Axis _x, _y;
    std::size_t _layers = 1, _steps = 1;
};

} // namespace

Result<WindContent> readNetCdfCf(NetCdfFile& file, const WindRequest& request) {
    return CfReader(file, request.asStored).read();
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfPoints.h>

#include <osgTreeWind/base/Number.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace osgTreeWind {

namespace {

std::vector<double> coordinatesOf(const EvenAxis& axis) {
    std::vector<double> at;
    for (std::size_t i = 0; i < axis.count; ++i)
        at.push_back(axis.first + axis.step * static_cast<double>(i));
    return at;
}

/// A coordinate shifted by whole periods into the range of a periodic axis.
double wrapToAxis(const EvenAxis& axis, double coordinate) {
    const double middle = axis.first + 0.5 * axis.step * static_cast<double>(axis.count - 1);
    return axis.period > 0.0 ? coordinate - axis.period * std::round((coordinate - middle) / axis.period)
                             : coordinate;
}

double coordinateAt(const AxisPart& part, std::size_t i) {
    return part.first + part.step * static_cast<double>(i);
}

/// Reads one array at the points.
class ArrayReader {
public:
    ArrayReader(NetCdfFile& file, const NetCdfArray& array, const NetCdfPoints& points, bool isFlat)
        : _file(file), _array(array), _points(points), _roles(rolesOf(file, array)), _isFlat(isFlat),
          _selection(array.dimensions.size(), {0}) {}

    std::vector<float> read() {
        chooseTimes();
        chooseLevels();
        if (_roles.version)
            _selection[*_roles.version] = allOf(_array.dimensions[*_roles.version].size);
        chooseAlong(_roles.y, _points.yAxis, _points.y, _y);
        chooseAlong(_roles.x, _points.xAxis, _points.x, _x);
        if (!_file.good())
            return {};
        std::vector<float> numbers = inGridOrder(_file.read(_array, _selection));
        if (!_file.good())
            return {};
        const std::size_t columns = sizeOf(_roles.x), rows = sizeOf(_roles.y);
        numbers = interpolate(numbers, rows * columns, _levels);
        numbers = interpolate(numbers, columns, _y);
        return interpolate(numbers, 1, _x);
    }

private:
    void expectAs(const NetCdfDimension& wanted, const std::string& found) {
        _file.fail(_array.name, "expected the dimension " + wanted.name +
                                    " of the other arrays of wind, or one "
                                    "of the same coordinates, found " +
                                    found);
    }

    void chooseTimes() {
        if (!_roles.time)
            return;
        const NetCdfDimension& own = _array.dimensions[*_roles.time];
        if (!_points.time) {
            if (own.size > 1)
                _file.fail(_array.name, "expected no times, as the other arrays of wind, found " + own.name);
            return;
        }
        if (own.name != _points.time->name &&
            (own.size != _points.time->size ||
             osgTreeWind::coordinatesOf(_file, own) != osgTreeWind::coordinatesOf(_file, *_points.time)))
            return expectAs(*_points.time, own.name);
        _selection[*_roles.time] = _points.times;
    }

    void chooseLevels() {
        if (_isFlat || !_points.level) {
            if (_roles.level && _array.dimensions[*_roles.level].size > 1)
                _file.fail(_array.name, "expected one level, as the other arrays of wind, found those of " +
                                            _array.dimensions[*_roles.level].name);
            return;
        }
        if (!_roles.level)
            return expectAs(*_points.level, "none");
        const NetCdfDimension& own = _array.dimensions[*_roles.level];
        if (own.name == _points.level->name) {
            _selection[*_roles.level] = _points.levels;
            return;
        }
        const std::vector<double> at = osgTreeWind::coordinatesOf(_file, own);
        if (at.size() != own.size || at.empty() || !between(at))
            return expectAs(*_points.level, own.name);
        _levels = interpolationBetween(at, _points.levelsAt);
        _selection[*_roles.level] = _levels.indices;
    }

    /// Whether the levels of the points are between these, or at most a layer beyond.
    bool between(const std::vector<double>& at) const {
        const std::vector<double>& wanted = _points.levelsAt;
        const auto [low, high] = std::minmax_element(at.begin(), at.end());
        const auto [lowest, highest] = std::minmax_element(wanted.begin(), wanted.end());
        const double layer = (*high - *low) / static_cast<double>(std::max<std::size_t>(1, at.size() - 1));
        const bool monotonic = std::is_sorted(at.begin(), at.end()) || std::is_sorted(at.rbegin(), at.rend());
        return monotonic && at.size() + 1 >= wanted.size() && at.size() <= wanted.size() + 1 &&
               *lowest >= *low - layer && *highest <= *high + layer;
    }

    void chooseAlong(std::optional<std::size_t> role, const NetCdfAxis& axis, const AxisPart& part,
                     NetCdfInterpolation& places) {
        if (!_file.good())
            return;
        if (!role)
            return _file.fail(_array.name, "expected the dimension " + axis.name);
        const NetCdfAxis own = axisOf(_file, _array.dimensions[*role]);
        if (!_file.good())
            return;
        const NetCdfMatch match = matchOf(axis, own);
        if (match == NetCdfMatch::Neither)
            return _file.fail(_array.name,
                              "its dimension " + own.name + " is neither the same as " + axis.name +
                                  " of the other arrays of wind nor midway between its points: " +
                                  text(own.points) + " against " + text(axis.points));
        if (match == NetCdfMatch::Same) {
            _selection[*role] = part.indices;
            return;
        }
        std::vector<double> wanted;
        for (std::size_t i = 0; i < part.indices.size(); ++i)
            wanted.push_back(wrapToAxis(own.points, coordinateAt(part, i)));
        places = interpolationBetween(coordinatesOf(own.points), wanted);
        _selection[*role] = places.indices;
    }

    static std::string text(const EvenAxis& axis) {
        return std::to_string(axis.count) + " points from " + numberText(axis.first) + " by " +
               numberText(axis.step);
    }

    std::size_t sizeOf(std::optional<std::size_t> role) const { return role ? _selection[*role].size() : 1; }

    /// Reorders numbers to time, level, row, column; uses the first version with data.
    std::vector<float> inGridOrder(const std::vector<float>& numbers) const {
        std::vector<std::size_t> strides(_selection.size(), 1);
        for (std::size_t d = _selection.size(); d-- > 1;)
            strides[d - 1] = strides[d] * _selection[d].size();
        const auto stride = [&](std::optional<std::size_t> role) { return role ? strides[*role] : 0; };
        const std::size_t times = sizeOf(_roles.time), levels = sizeOf(_roles.level), rows = sizeOf(_roles.y),
                          columns = sizeOf(_roles.x), versions = sizeOf(_roles.version);
        std::vector<float> ordered;
        if (numbers.empty())
            return ordered;
        ordered.reserve(times * levels * rows * columns);
        for (std::size_t t = 0; t < times; ++t)
            for (std::size_t z = 0; z < levels; ++z)
                for (std::size_t y = 0; y < rows; ++y)
                    for (std::size_t x = 0; x < columns; ++x) {
                        std::size_t at = t * stride(_roles.time) + z * stride(_roles.level) +
                                         y * stride(_roles.y) + x * stride(_roles.x);
                        for (std::size_t version = 1; version < versions && std::isnan(numbers[at]);
                             ++version)
                            at += stride(_roles.version);
                        ordered.push_back(numbers[at]);
                    }
        return ordered;
    }

    NetCdfFile& _file;
    const NetCdfArray& _array;
    const NetCdfPoints& _points;
    NetCdfRoles _roles;
    bool _isFlat;
    NetCdfSelection _selection;
    NetCdfInterpolation _levels, _y, _x;
};

} // namespace

void clipToAxis(const NetCdfAxis& other, const NetCdfAxis& axis, AxisPart& part) {
    if (matchOf(axis, other) != NetCdfMatch::Midway)
        return;
    const double last = other.points.first + other.points.step * static_cast<double>(other.points.count - 1),
                 low = std::min(other.points.first, last) - 0.1 * part.step,
                 high = std::max(other.points.first, last) + 0.1 * part.step;
    const auto reached = [&](std::size_t i) {
        const double at = wrapToAxis(other.points, coordinateAt(part, i));
        return at >= low && at <= high;
    };
    while (part.indices.size() > 1 && !reached(part.indices.size() - 1))
        part.indices.pop_back();
    while (part.indices.size() > 1 && !reached(0)) {
        part.indices.erase(part.indices.begin());
        part.first += part.step;
    }
}

std::vector<float> readAtPoints(NetCdfFile& file, const NetCdfArray& array, const NetCdfPoints& points,
                                bool isFlat) {
    return ArrayReader(file, array, points, isFlat).read();
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfWinds.h>

#include <plugins/weather/NetCdfAxes.h>
#include <plugins/weather/Words.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <regex>

namespace osgTreeWind {

namespace {

using Array = NetCdfFile::Array;
using Names = std::vector<std::string>;

/// The arrays of at least two dimensions with one of these standard names or names.
std::vector<Array> arraysNamed(const NetCdfFile& file, const Names& standard, const Names& own) {
    std::vector<Array> found;
    for (const Array& array : file.arrays())
        if (array->dimensions.size() >= 2 &&
            (isOneOf(array->text("standard_name"), standard) || isOneOf(lower(array->name), own)))
            found.push_back(array);
    return found;
}

/// The first of these arrays, preferring standard names; null if there is none.
Array firstArrayNamed(const NetCdfFile& file, const Names& standard, const Names& own) {
    std::vector<Array> found = arraysNamed(file, standard, {});
    if (found.empty())
        found = arraysNamed(file, {}, own);
    return found.empty() ? nullptr : found.front();
}

/// The arrays of at least two dimensions whose names have this prefix.
std::vector<Array> arraysWithPrefix(const NetCdfFile& file, const std::string& begin) {
    std::vector<Array> found;
    for (const Array& array : file.arrays())
        if (array->dimensions.size() >= 2 && startsWithAny(lower(array->name), {begin}))
            found.push_back(array);
    return found;
}

Array firstArrayWithPrefix(const NetCdfFile& file, const std::string& begin) {
    const std::vector<Array> found = arraysWithPrefix(file, begin);
    return found.empty() ? nullptr : found.front();
}

/// The height in the name of a component: 10 for u10, U10M, u_10m, 10u, 10m_u and uas.
std::optional<double> heightIn(const std::string& name, char component) {
    static const std::regex after("([uv])_?(\\d{1,3})(m?)"), before("(\\d{1,3})(m_)?([uv])");
    const std::string small = lower(name);
    if (small == std::string(1, component) + "as")
        return 10.0;
    std::smatch parts;
    const bool isAfter = std::regex_match(small, parts, after);
    if (!isAfter && !std::regex_match(small, parts, before))
        return std::nullopt;
    const double height = parseNumber(parts[isAfter ? 2 : 1].str()).value_or(0.0);
    const bool isMetres = !isAfter || parts[3].length() > 0;
    if (parts[isAfter ? 1 : 3].str()[0] != component || height <= 0.0 ||
        (height > 100.0 && !isMetres)) // u850 is on a pressure level
        return std::nullopt;
    return height;
}

/// The height above ground in a scalar coordinate.
std::optional<double> scalarHeight(NetCdfFile& file, const NetCdfArray& array) {
    const std::string names = ' ' + array.text("coordinates") + ' ';
    for (const Array& one : file.arrays()) {
        const bool isScalar =
            one->dimensions.empty() || (one->dimensions.size() == 1 && one->dimensions[0].size == 1);
        if (!isScalar || names.find(' ' + one->name + ' ') == std::string::npos)
            continue;
        if (one->text("standard_name") == "height" || startsWithAny(lower(one->name), {"height"})) {
            const std::vector<double> height = file.coordinates(*one);
            if (!height.empty())
                return height.front();
        }
    }
    return std::nullopt;
}

/// The second component for a first: the array with the same name except for the letter of the component. If
/// there is only one first component, any array with as many dimensions.
Array partnerOf(const NetCdfArray& first, const std::vector<Array>& seconds, bool isOnly) {
    static const std::pair<const char*, const char*> letters[] = {
        {"u", "v"}, {"U", "V"}, {"x", "y"}, {"X", "Y"}, {"east", "north"}};
    for (const auto& [from, to] : letters)
        if (const std::size_t at = first.name.find(from); at != std::string::npos) {
            std::string name = first.name;
            name.replace(at, std::string(from).size(), to);
            for (const Array& second : seconds)
                if (second->name == name)
                    return second;
        }
    for (const Array& second : seconds)
        if (isOnly && second->dimensions.size() == first.dimensions.size())
            return second;
    return nullptr;
}

std::vector<NetCdfWindPair> pairsOf(NetCdfFile& file, const std::vector<Array>& firsts,
                                    const std::vector<Array>& seconds) {
    std::vector<NetCdfWindPair> pairs;
    for (const Array& first : firsts)
        if (const Array second = partnerOf(*first, seconds, firsts.size() == 1)) {
            std::optional<double> height = scalarHeight(file, *first);
            pairs.push_back({first, second, height ? height : heightIn(first->name, 'u')});
        }
    return pairs;
}

/// Components with a height in their names, such as ERA5's u10 and v100.
std::vector<NetCdfWindPair> pairsAtHeights(NetCdfFile& file) {
    std::vector<Array> firsts, seconds;
    for (const Array& array : file.arrays()) {
        if (array->dimensions.size() < 2)
            continue;
        if (heightIn(array->name, 'u'))
            firsts.push_back(array);
        else if (heightIn(array->name, 'v'))
            seconds.push_back(array);
    }
    return pairsOf(file, firsts, seconds);
}

/// The first pair with levels, preferably in metres; otherwise all pairs at heights on the same dimensions.
std::vector<NetCdfWindPair> chosen(const NetCdfFile& file, const std::vector<NetCdfWindPair>& pairs) {
    for (const bool metres : {true, false})
        for (const NetCdfWindPair& pair : pairs) {
            const std::optional<std::size_t> level = rolesOf(file, *pair.first).level;
            if (level &&
                (!metres || measureOf(file, pair.first->dimensions[*level]) == NetCdfMeasure::Metres))
                return {pair};
        }
    std::vector<NetCdfWindPair> layers = {pairs.front()};
    const auto names = [](const NetCdfArray& array) {
        Names all;
        for (const NetCdfDimension& dimension : array.dimensions)
            all.push_back(dimension.name);
        return all;
    };
    for (const NetCdfWindPair& pair : pairs) {
        const bool isNew = std::none_of(layers.begin(), layers.end(), [&](const NetCdfWindPair& layer) {
            return layer.first == pair.first || layer.height == pair.height;
        });
        if (layers.front().height && pair.height && isNew &&
            names(*pair.first) == names(*layers.front().first))
            layers.push_back(pair);
    }
    std::sort(layers.begin(), layers.end(),
              [](const NetCdfWindPair& a, const NetCdfWindPair& b) { return a.height < b.height; });
    return layers;
}

/// The vertical velocity; not the change of pressure.
Array upOf(const NetCdfFile& file, const NetCdfArray& first, std::vector<std::string>& notes) {
    Array up = firstArrayNamed(file, {"upward_air_velocity"}, {"w"});
    if (!up || up->dimensions.size() != first.dimensions.size())
        return nullptr;
    if (lower(up->unit).find("pa") == std::string::npos)
        return up;
    notes.push_back(up->name + " is the change of pressure, in " + up->unit + ", and is ignored");
    return nullptr;
}

bool findComponents(NetCdfFile& file, NetCdfWinds& winds) {
    static constexpr const char* standard[][2] = {{"x_wind", "y_wind"},
                                                  {"eastward_wind", "northward_wind"},
                                                  {"grid_eastward_wind", "grid_northward_wind"}};
    std::vector<NetCdfWindPair> pairs;
    for (const auto& [east, north] : standard)
        if (pairs.empty())
            pairs = pairsOf(file, arraysNamed(file, {east}, {}), arraysNamed(file, {north}, {}));
    if (pairs.empty())
        pairs = pairsOf(file, arraysNamed(file, {}, {"u", "ua", "uwnd", "ugrd"}),
                        arraysNamed(file, {}, {"v", "va", "vwnd", "vgrd"}));
    if (pairs.empty())
        pairs = pairsOf(file, arraysWithPrefix(file, "u-component"), arraysWithPrefix(file, "v-component"));
    for (const NetCdfWindPair& pair : pairsAtHeights(file))
        pairs.push_back(pair);
    if (pairs.empty())
        return false;
    winds.pairs = chosen(file, pairs);
    const NetCdfArray& u = *winds.pairs.front().first;
    winds.up = winds.pairs.size() == 1 ? upOf(file, u, winds.notes) : nullptr;
    // Data converted from GRIB have a flag, because their names do not tell.
    const std::string ofGrid = u.text("GRIB_uvRelativeToGrid");
    winds.fromTrueNorth = ofGrid.empty() ? u.text("standard_name") == "eastward_wind" : ofGrid == "0";
    winds.direction = winds.fromTrueNorth ? "components toward true east, true north and up"
                                          : "components toward x (east), y (north) and up";
    winds.unit = file.speedUnitOf(winds.arrays());
    return true;
}

bool findSpeedAndDirection(NetCdfFile& file, NetCdfWinds& winds) {
    Array speed = firstArrayNamed(file, {"wind_speed"}, {"wind_speed", "speed"});
    const Array from = firstArrayNamed(file, {"wind_from_direction"},
                                       {"wind_from_direction", "wind_direction", "direction"}),
                toward = firstArrayNamed(file, {"wind_to_direction"}, {"wind_to_direction"});
    if (!speed)
        speed = firstArrayWithPrefix(file, "wind_speed");
    const Array direction = from ? from : toward ? toward : firstArrayWithPrefix(file, "wind_direction_from");
    if (!speed || !direction)
        return false;
    winds.pairs = {{speed, direction, scalarHeight(file, *speed)}};
    winds.isPolar = true;
    winds.sense = !from && toward ? DirectionSense::Toward : DirectionSense::From;
    const std::string unit = direction->unit, name = direction->text("standard_name");
    if (!unit.empty() && unit.compare(0, 3, "deg") != 0)
        file.fail(direction->name, expectedFound("degrees", unit));
    winds.fromTrueNorth = unit == "degree_true" || unit == "degrees_true" || name == "wind_from_direction" ||
                          name == "wind_to_direction";
    winds.direction = std::string(winds.sense == DirectionSense::From ? "from" : "toward") +
                      ", degrees clockwise from " + (winds.fromTrueNorth ? "true north" : "the grid's north");
    winds.unit = file.speedUnitOf({speed});
    return true;
}

} // namespace

std::vector<NetCdfFile::Array> NetCdfWinds::arrays() const {
    std::vector<Array> all;
    for (const NetCdfWindPair& pair : pairs)
        all.insert(all.end(), {pair.first, pair.second});
    if (up)
        all.push_back(up);
    return all;
}

NetCdfWinds windsOf(NetCdfFile& file) {
    NetCdfWinds winds;
    if (!findComponents(file, winds) && !findSpeedAndDirection(file, winds))
        file.fail({},
                  "expected arrays of wind: x_wind and y_wind, eastward_wind and northward_wind, u and v, "
                  "u10 and v10, or wind_speed and wind_from_direction");
    return winds;
}

} // namespace osgTreeWind

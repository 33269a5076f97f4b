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

/// The arrays of at least two dimensions that satisfy a condition.
template <typename Condition>
std::vector<Array> arraysWhere(const NetCdfFile& file, Condition condition) {
    std::vector<Array> found;
    for (const Array& array : file.arrays())
        if (array->dimensions.size() >= 2 && condition(*array))
            found.push_back(array);
    return found;
}

std::vector<Array> arraysOfStandard(const NetCdfFile& file, const char* name) {
    return arraysWhere(file, [&](const NetCdfArray& array) { return array.text("standard_name") == name; });
}

/// The arrays with one of these names in any case.
std::vector<Array> arraysNamed(const NetCdfFile& file, const Names& names) {
    return arraysWhere(file, [&](const NetCdfArray& array) { return isOneOf(lower(array.name), names); });
}

std::vector<Array> arraysWithPrefix(const NetCdfFile& file, const std::string& begin) {
    return arraysWhere(file,
                       [&](const NetCdfArray& array) { return startsWithAny(lower(array.name), {begin}); });
}

/// The arrays with a standard name, otherwise with one of these names, otherwise with a prefix unless it is
/// empty.
std::vector<Array> arraysLike(const NetCdfFile& file, const char* standard, const Names& names,
                              const std::string& prefix = {}) {
    std::vector<Array> found = arraysOfStandard(file, standard);
    if (found.empty())
        found = arraysNamed(file, names);
    return found.empty() && !prefix.empty() ? arraysWithPrefix(file, prefix) : found;
}

Names dimensionsOf(const NetCdfArray& array) {
    Names names;
    for (const NetCdfDimension& dimension : array.dimensions)
        names.push_back(dimension.name);
    return names;
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
/// there is only one first component, the only array with as many dimensions.
Array partnerOf(const NetCdfArray& first, const std::vector<Array>& seconds, bool isOnly) {
    static const std::pair<std::string, std::string> letters[] = {{"u", "v"},
                                                                  {"U", "V"},
                                                                  {"x", "y"},
                                                                  {"X", "Y"},
                                                                  {"east", "north"},
                                                                  {"zonal", "meridional"},
                                                                  {"speed", "direction"},
                                                                  {"ws", "wd"},
                                                                  {"WS", "WD"}};
    for (const auto& [from, to] : letters)
        for (std::size_t at = 0; (at = first.name.find(from, at)) != std::string::npos; ++at) {
            const std::string name = std::string(first.name).replace(at, from.size(), to);
            for (const Array& second : seconds)
                if (second->name == name)
                    return second;
        }
    std::vector<Array> alike;
    for (const Array& second : seconds)
        if (isOnly && second->dimensions.size() == first.dimensions.size())
            alike.push_back(second);
    return alike.size() == 1 ? alike.front() : nullptr;
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
    const auto ofComponent = [&](char component) {
        return arraysWhere(
            file, [&](const NetCdfArray& array) { return heightIn(array.name, component).has_value(); });
    };
    return pairsOf(file, ofComponent('u'), ofComponent('v'));
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
    for (const NetCdfWindPair& pair : pairs) {
        const bool isNew = std::none_of(layers.begin(), layers.end(), [&](const NetCdfWindPair& layer) {
            return layer.first == pair.first || layer.height == pair.height;
        });
        if (layers.front().height && pair.height && isNew &&
            dimensionsOf(*pair.first) == dimensionsOf(*layers.front().first))
            layers.push_back(pair);
    }
    std::sort(layers.begin(), layers.end(),
              [](const NetCdfWindPair& a, const NetCdfWindPair& b) { return a.height < b.height; });
    return layers;
}

/// The vertical velocity; not the change of pressure.
Array upOf(const NetCdfFile& file, const NetCdfArray& first, std::vector<std::string>& notes) {
    const std::vector<Array> found = arraysLike(file, "upward_air_velocity", {"w"});
    if (found.empty() || found.front()->dimensions.size() != first.dimensions.size())
        return nullptr;
    const Array& up = found.front();
    if (lower(up->unit).find("pa") == std::string::npos)
        return up;
    notes.push_back(up->name + " is the change of pressure, in " + up->unit + ", and is ignored");
    return nullptr;
}

/// Notes arrays of wind that are not used. It is a problem if one has the dimensions of the first that is
/// used.
void reportOthers(NetCdfFile& file, const std::vector<Array>& used, const std::vector<Array>& found,
                  std::vector<std::string>& notes) {
    Names others;
    for (const Array& array : found) {
        if (std::find(used.begin(), used.end(), array) != used.end())
            continue;
        others.push_back(array->name);
        if (dimensionsOf(*array) == dimensionsOf(*used.front()))
            file.fail({}, "expected one wind, found " + used.front()->name + " and " + array->name +
                              " on the same points; wind.variable names one");
    }
    if (!others.empty())
        notes.push_back("the wind is read from " + used.front()->name +
                        "; wind.variable chooses another of " + joined(others));
}

void setComponents(NetCdfFile& file, std::vector<NetCdfWindPair> pairs, NetCdfWinds& winds) {
    winds.pairs = std::move(pairs);
    const NetCdfArray& u = *winds.pairs.front().first;
    // Data converted from GRIB have a flag, because their names do not tell.
    const std::string ofGrid = u.text("GRIB_uvRelativeToGrid");
    winds.fromTrueNorth = ofGrid.empty() ? u.text("standard_name") == "eastward_wind" : ofGrid == "0";
    winds.direction = winds.fromTrueNorth ? "components toward true east, true north and up"
                                          : "components toward x (east), y (north) and up";
    winds.unit = file.speedUnitOf(winds.arrays());
}

bool findComponents(NetCdfFile& file, NetCdfWinds& winds) {
    static constexpr const char* standard[][2] = {{"x_wind", "y_wind"},
                                                  {"eastward_wind", "northward_wind"},
                                                  {"grid_eastward_wind", "grid_northward_wind"}};
    std::vector<NetCdfWindPair> pairs;
    for (const auto& [east, north] : standard)
        if (pairs.empty())
            pairs = pairsOf(file, arraysOfStandard(file, east), arraysOfStandard(file, north));
    if (pairs.empty())
        pairs = pairsOf(file, arraysNamed(file, {"u", "ua", "uwnd", "ugrd"}),
                        arraysNamed(file, {"v", "va", "vwnd", "vgrd"}));
    if (pairs.empty())
        pairs = pairsOf(file, arraysWithPrefix(file, "u-component"), arraysWithPrefix(file, "v-component"));
    std::vector<Array> firsts, used;
    for (const NetCdfWindPair& pair : pairs)
        firsts.push_back(pair.first);
    for (const NetCdfWindPair& pair : pairsAtHeights(file))
        if (std::find(firsts.begin(), firsts.end(), pair.first) == firsts.end()) {
            pairs.push_back(pair);
            firsts.push_back(pair.first);
        }
    if (pairs.empty())
        return false;
    pairs = chosen(file, pairs);
    for (const NetCdfWindPair& pair : pairs)
        used.push_back(pair.first);
    reportOthers(file, used, firsts, winds.notes);
    winds.up = pairs.size() == 1 ? upOf(file, *used.front(), winds.notes) : nullptr;
    setComponents(file, std::move(pairs), winds);
    return true;
}

void setPolar(NetCdfFile& file, const Array& speed, const Array& direction, NetCdfWinds& winds) {
    const std::string unit = direction->unit, name = direction->text("standard_name");
    winds.pairs = {{speed, direction, scalarHeight(file, *speed)}};
    winds.isPolar = true;
    const bool isToward = name == "wind_to_direction" || lower(direction->name) == "wind_to_direction";
    winds.sense = isToward ? DirectionSense::Toward : DirectionSense::From;
    if (!unit.empty() && unit.compare(0, 3, "deg") != 0)
        file.fail(direction->name, expectedFound("degrees", unit));
    winds.fromTrueNorth = unit == "degree_true" || unit == "degrees_true" || name == "wind_from_direction" ||
                          name == "wind_to_direction";
    winds.direction = std::string(isToward ? "toward" : "from") + ", degrees clockwise from " +
                      (winds.fromTrueNorth ? "true north" : "the grid's north");
    winds.unit = file.speedUnitOf({speed});
}

std::vector<Array> speedsOf(const NetCdfFile& file) {
    return arraysLike(file, "wind_speed", {"wind_speed", "speed"}, "wind_speed");
}

/// The direction of a speed, preferably on the same points; null if there is none.
Array directionOf(const NetCdfFile& file, const NetCdfArray& speed) {
    std::vector<Array> found =
        arraysLike(file, "wind_from_direction", {"wind_from_direction", "wind_direction", "direction"});
    if (found.empty())
        found = arraysLike(file, "wind_to_direction", {"wind_to_direction"}, "wind_direction_from");
    for (const Array& direction : found)
        if (dimensionsOf(*direction) == dimensionsOf(speed))
            return direction;
    return found.empty() ? nullptr : found.front();
}

bool findSpeedAndDirection(NetCdfFile& file, NetCdfWinds& winds) {
    const std::vector<Array> speeds = speedsOf(file);
    const Array direction = speeds.empty() ? nullptr : directionOf(file, *speeds.front());
    if (!direction)
        return false;
    reportOthers(file, {speeds.front()}, speeds, winds.notes);
    setPolar(file, speeds.front(), direction, winds);
    return true;
}

std::vector<Array> arraysOfPoints(const NetCdfFile& file) {
    return arraysWhere(file, [](const NetCdfArray&) { return true; });
}

Names namesIn(const NetCdfFile& file) {
    Names names;
    for (const Array& array : arraysOfPoints(file))
        names.push_back(array->name);
    return names;
}

/// Finds the arrays that the user names: both components and an upward one, or speed and direction, or only
/// the first of a pair.
void findNamed(NetCdfFile& file, const Names& variable, NetCdfWinds& winds) {
    std::vector<Array> named;
    for (const std::string& name : variable) {
        const std::vector<Array> found =
            arraysWhere(file, [&](const NetCdfArray& array) { return array.name == name; });
        if (found.empty() || named.size() == 3)
            return file.fail(
                {}, expectedFound("1 to 3 arrays of wind that wind.variable names: " + joined(namesIn(file)),
                                  name));
        named.push_back(found.front());
    }
    const Array first = named.front();
    Array second = named.size() > 1 ? named[1] : partnerOf(*first, arraysOfPoints(file), false);
    const std::vector<Array> speeds = speedsOf(file);
    if (!second && std::find(speeds.begin(), speeds.end(), first) != speeds.end())
        second = directionOf(file, *first);
    if (!second)
        return file.fail({}, "expected the second component or the direction beside " + first->name +
                                 "; wind.variable names both, as [\"EAST\", \"NORTH\"], of " +
                                 joined(namesIn(file)));
    if (second->unit.compare(0, 3, "deg") == 0 ||
        second->text("standard_name").find("direction") != std::string::npos)
        return setPolar(file, first, second, winds);
    std::optional<double> height = scalarHeight(file, *first);
    winds.up = named.size() == 3 ? named[2] : nullptr;
    setComponents(file, {{first, second, height ? height : heightIn(first->name, 'u')}}, winds);
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

NetCdfWinds windsOf(NetCdfFile& file, const std::vector<std::string>& variable) {
    NetCdfWinds winds;
    if (!variable.empty())
        findNamed(file, variable, winds);
    else if (!findComponents(file, winds) && !findSpeedAndDirection(file, winds))
        file.fail({},
                  "expected arrays of wind: x_wind and y_wind, eastward_wind and northward_wind, u and v, "
                  "u10 and v10, or wind_speed and wind_from_direction; wind.variable names others, of " +
                      joined(namesIn(file)));
    return winds;
}

} // namespace osgTreeWind

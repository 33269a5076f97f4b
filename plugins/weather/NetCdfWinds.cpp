// SPDX-License-Identifier: MIT
#include <plugins/weather/NetCdfWinds.h>

#include <plugins/weather/NetCdfAxes.h>
#include <plugins/weather/Words.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <algorithm>
#include <regex>

namespace osgTreeWind {

namespace {

using Array = NetCdfFile::Array;
using Names = std::vector<std::string>;

/// The arrays of at least two dimensions with one of these standard names, or of these names of their own.
std::vector<Array> called(const NetCdfFile& file, const Names& standard, const Names& own) {
    std::vector<Array> found;
    for (const Array& array : file.arrays())
        if (array->dimensions.size() >= 2 &&
            (among(array->text("standard_name"), standard) || among(lower(array->name), own)))
            found.push_back(array);
    return found;
}

/// The same, standard names before own ones; null for none.
Array firstCalled(const NetCdfFile& file, const Names& standard, const Names& own) {
    std::vector<Array> found = called(file, standard, {});
    if (found.empty())
        found = called(file, {}, own);
    return found.empty() ? nullptr : found.front();
}

/// The arrays whose names begin like this.
std::vector<Array> beginning(const NetCdfFile& file, const std::string& begin) {
    std::vector<Array> found;
    for (const Array& array : file.arrays())
        if (array->dimensions.size() >= 2 && begins(lower(array->name), {begin}))
            found.push_back(array);
    return found;
}

Array firstBeginning(const NetCdfFile& file, const std::string& begin) {
    const std::vector<Array> found = beginning(file, begin);
    return found.empty() ? nullptr : found.front();
}

/// The height in the name of a component: 10 of u10, U10M, u_10m, 10u, 10m_u and uas.
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
        (height > 100.0 && !isMetres)) // u850 stands on a level of pressure
        return std::nullopt;
    return height;
}

/// The height above ground that a scalar coordinate states.
std::optional<double> scalarHeight(NetCdfFile& file, const NetCdfArray& array) {
    const std::string names = ' ' + array.text("coordinates") + ' ';
    for (const Array& one : file.arrays()) {
        const bool isScalar =
            one->dimensions.empty() || (one->dimensions.size() == 1 && one->dimensions[0].size == 1);
        if (!isScalar || names.find(' ' + one->name + ' ') == std::string::npos)
            continue;
        if (one->text("standard_name") == "height" || begins(lower(one->name), {"height"})) {
            const std::vector<double> height = file.coordinates(*one);
            if (!height.empty())
                return height.front();
        }
    }
    return std::nullopt;
}

/// The array that goes with another: as its name but for the letters of its component; of a first that is
/// the only one, else any on as many dimensions.
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

/// Components that their names put at a height, as ERA5's u10 and v100.
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

/// The first pair with levels, of several that in metres; else all that stand at a height on the dimensions
/// of the first.
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

/// The velocity upward; not what is upward in pressure.
Array upOf(const NetCdfFile& file, const NetCdfArray& first, std::vector<std::string>& notes) {
    Array up = firstCalled(file, {"upward_air_velocity"}, {"w"});
    if (!up || up->dimensions.size() != first.dimensions.size())
        return nullptr;
    if (lower(up->unit).find("pa") == std::string::npos)
        return up;
    notes.push_back(up->name + " is the change of pressure, in " + up->unit + ", and is left out");
    return nullptr;
}

bool findComponents(NetCdfFile& file, NetCdfWinds& winds) {
    static constexpr const char* standard[][2] = {{"x_wind", "y_wind"},
                                                  {"eastward_wind", "northward_wind"},
                                                  {"grid_eastward_wind", "grid_northward_wind"}};
    std::vector<NetCdfWindPair> pairs;
    for (const auto& [east, north] : standard)
        if (pairs.empty())
            pairs = pairsOf(file, called(file, {east}, {}), called(file, {north}, {}));
    if (pairs.empty())
        pairs = pairsOf(file, called(file, {}, {"u", "ua", "uwnd", "ugrd"}),
                        called(file, {}, {"v", "va", "vwnd", "vgrd"}));
    if (pairs.empty())
        pairs = pairsOf(file, beginning(file, "u-component"), beginning(file, "v-component"));
    for (const NetCdfWindPair& pair : pairsAtHeights(file))
        pairs.push_back(pair);
    if (pairs.empty())
        return false;
    winds.pairs = chosen(file, pairs);
    const NetCdfArray& u = *winds.pairs.front().first;
    winds.up = winds.pairs.size() == 1 ? upOf(file, u, winds.notes) : nullptr;
    // Data from GRIB have a flag; their name is the same either way.
    const std::string ofGrid = u.text("GRIB_uvRelativeToGrid");
    winds.fromTrueNorth = ofGrid.empty() ? u.text("standard_name") == "eastward_wind" : ofGrid == "0";
    winds.direction = winds.fromTrueNorth ? "components toward true east, true north and up"
                                          : "components toward x (east), y (north) and up";
    std::vector<Array> all;
    for (const NetCdfWindPair& pair : winds.pairs)
        all.insert(all.end(), {pair.first, pair.second});
    if (winds.up)
        all.push_back(winds.up);
    winds.unit = file.speedUnitOf(all);
    return true;
}

bool findSpeedAndDirection(NetCdfFile& file, NetCdfWinds& winds) {
    Array speed = firstCalled(file, {"wind_speed"}, {"wind_speed", "speed"});
    const Array from = firstCalled(file, {"wind_from_direction"},
                                   {"wind_from_direction", "wind_direction", "direction"}),
                toward = firstCalled(file, {"wind_to_direction"}, {"wind_to_direction"});
    if (!speed)
        speed = firstBeginning(file, "wind_speed");
    const Array direction = from ? from : toward ? toward : firstBeginning(file, "wind_direction_from");
    if (!speed || !direction)
        return false;
    winds.pairs = {{speed, direction, scalarHeight(file, *speed)}};
    winds.polar = true;
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

NetCdfWinds windsOf(NetCdfFile& file) {
    NetCdfWinds winds;
    if (!findComponents(file, winds) && !findSpeedAndDirection(file, winds))
        file.fail({},
                  "expected arrays of wind: x_wind and y_wind, eastward_wind and northward_wind, u and v, "
                  "u10 and v10, or wind_speed and wind_from_direction");
    return winds;
}

} // namespace osgTreeWind

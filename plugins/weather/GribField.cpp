// SPDX-License-Identifier: MIT
#include <plugins/weather/GribField.h>

#include <plugins/weather/GribHandle.h>
#include <plugins/weather/GribTime.h>

#include <osgTreeWind/base/Problem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace osgTreeWind {

namespace {

/// What is wrong with a message.
using Problem = std::optional<std::string>;

constexpr std::string_view start = "GRIB", end = "7777";

struct LevelRow {
    int edition, type;
    GribLevelKind kind;
    double unit = 1.0;
};

constexpr LevelRow levelRows[] = {
    {1, 1, GribLevelKind::Surface},       {1, 100, GribLevelKind::Isobaric, 100.0}, // hPa
    {1, 210, GribLevelKind::Isobaric},    {1, 103, GribLevelKind::AboveSea},
    {1, 105, GribLevelKind::AboveGround}, {1, 109, GribLevelKind::Model},
    {1, 110, GribLevelKind::Model}, // between two half levels
    {2, 1, GribLevelKind::Surface},       {2, 100, GribLevelKind::Isobaric},
    {2, 102, GribLevelKind::AboveSea},    {2, 103, GribLevelKind::AboveGround},
    {2, 105, GribLevelKind::Model},  // hybrid
    {2, 111, GribLevelKind::Model},  // eta
    {2, 118, GribLevelKind::Model},  // hybrid height
    {2, 119, GribLevelKind::Model},  // hybrid pressure
    {2, 150, GribLevelKind::Model}}; // height that follows the ground

GribLevel levelOf(const GribHandle& handle, int edition) {
    const auto type = static_cast<int>(
        handle.whole(edition == 1 ? "indicatorOfTypeOfLevel" : "typeOfFirstFixedSurface").value_or(255));
    const auto row = std::find_if(std::begin(levelRows), std::end(levelRows), [&](const LevelRow& each) {
        return each.edition == edition && each.type == type;
    });
    GribLevel level{row == std::end(levelRows) ? GribLevelKind::Other : row->kind, type, 0.0};
    if (edition == 1)
        level.value = (row == std::end(levelRows) ? 1.0 : row->unit) *
                      static_cast<double>(handle.whole(type == 110 ? "topLevel" : "level").value_or(0));
    else {
        const auto value = handle.whole("scaledValueOfFirstFixedSurface");
        const auto scale = handle.whole("scaleFactorOfFirstFixedSurface").value_or(0);
        level.value = value ? static_cast<double>(*value) * std::pow(10.0, -static_cast<double>(scale)) : 0.0;
        if (handle.whole("typeOfSecondFixedSurface").value_or(255) != 255 &&
            level.kind != GribLevelKind::Model)
            level.kind = GribLevelKind::Other; // from one level to another
    }
    return level;
}

/// Sets what its times are. False for a date that does not exist.
bool readTimes(const GribHandle& handle, GribField& field) {
    const auto part = [&](const char* key) { return static_cast<int>(handle.whole(key).value_or(0)); };
    const int date = part("dataDate");
    const auto reference = GribTime::secondsOf(
        {date / 10000, date / 100 % 100, date % 100, part("hour"), part("minute"), part("second")});
    if (!reference)
        return false;
    field.reference = field.valid = *reference;
    const int edition = field.parameter.edition, range = part("timeRangeIndicator");
    constexpr int analysis = 1, ofP1 = 0, ofTwoOctets = 10; // of edition 1
    constexpr int lastMomentary = 2; // of edition 2: a forecast, that of a member, one made of all members
    if (edition == 1 ? range != analysis && range != ofP1 && range != ofTwoOctets
                     : part("productDefinitionTemplateNumber") > lastMomentary)
        return true;
    const auto unit = GribTime::secondsOfUnit(edition, part("indicatorOfUnitOfTimeRange"));
    field.momentary = unit || (edition == 1 && range == analysis);
    if (unit && edition == 2)
        field.valid += *unit * part("forecastTime");
    else if (unit && range != analysis)
        field.valid += *unit * (range == ofP1 ? part("P1") : part("P1") * 256 + part("P2"));
    return true;
}

struct GridRow {
    const char *type, *name;
    bool even = false;
};

/// By ecCodes' gridType.
constexpr GridRow gridRows[] = {{"regular_ll", "latitude and longitude", true},
                                {"rotated_ll", "rotated latitude and longitude"},
                                {"stretched_ll", "stretched latitude and longitude"},
                                {"mercator", "Mercator", true},
                                {"transverse_mercator", "transverse Mercator", true},
                                {"polar_stereographic", "polar stereographic", true},
                                {"lambert", "Lambert conformal", true},
                                {"albers", "Albers", true},
                                {"lambert_azimuthal_equal_area", "Lambert azimuthal equal area", true},
                                {"regular_gg", "Gaussian"},
                                {"rotated_gg", "rotated Gaussian"},
                                {"reduced_ll", "reduced latitude and longitude"},
                                {"reduced_gg", "reduced Gaussian"},
                                {"sh", "spherical harmonics"},
                                {"space_view", "space view"},
                                {"unstructured_grid", "unstructured"}};

GribGrid gridOf(const GribHandle& handle, int edition, std::string_view section) {
    const std::string type = handle.text("gridType");
    GribGrid grid{type, false, false, 0, 0, std::string(section)};
    for (const GridRow& row : gridRows)
        if (type == row.type) {
            grid.kind = row.name;
            grid.even = row.even;
        }
    const auto sizeOf = [&](const char* degrees, const char* metres) {
        const auto size = handle.whole(degrees);
        return static_cast<std::uint64_t>((size ? size : handle.whole(metres)).value_or(0));
    };
    grid.columns = sizeOf("Ni", "Nx");
    grid.rows = sizeOf("Nj", "Ny");
    constexpr int toGridFlag = 0x08;
    const char* const key = "resolutionAndComponentFlags";
    grid.relativeToGrid = handle.whole(key).value_or(0) & toGridFlag;
    const auto flags = handle.offset(key);
    const auto begin = handle.whole(edition == 1 ? "offsetSection2" : "offsetSection3");
    if (const std::size_t at = flags && begin ? *flags - static_cast<std::size_t>(*begin) : 0;
        at > 0 && at < section.size())
        grid.definition[at] = static_cast<char>(grid.definition[at] & ~toGridFlag);
    return grid;
}

/// A file from one message to the next, and from one section to the next.
class Walk {
public:
    explicit Walk(std::string_view bytes) : _bytes(bytes) {}

    Result<std::vector<GribField>> read(const std::string& file) {
        while ((_at = _bytes.find(start, _at)) != std::string_view::npos) {
            const std::size_t begin = _at;
            ++_message;
            if (const Problem problem = readMessage())
                return fileProblem(file, "message " + std::to_string(_message) + ", at byte " +
                                             std::to_string(begin) + ": " + *problem);
        }
        return std::move(_fields);
    }

private:
    /// A whole number, the most significant octet first.
    std::uint64_t number(std::size_t at, std::size_t count) const {
        std::uint64_t value = 0;
        for (std::size_t i = at; i < at + count; ++i)
            value = value << 8 | (i < _bytes.size() ? static_cast<unsigned char>(_bytes[i]) : 0u);
        return value;
    }

    Problem readMessage() {
        if (_bytes.size() - _at < 16)
            return "cut in its first section";
        const auto edition = static_cast<int>(number(_at + 7, 1));
        if (edition != 1 && edition != 2)
            return "expected edition 1 or 2, found " + std::to_string(edition);
        const std::uint64_t size = edition == 1 ? number(_at + 4, 3) : number(_at + 8, 8);
        if (size > _bytes.size() - _at)
            return "expected " + std::to_string(size) + " bytes, the file ends after " +
                   std::to_string(_bytes.size() - _at);
        _end = _at + static_cast<std::size_t>(size);
        if (size < 20 || _bytes.substr(_end - end.size(), end.size()) != end)
            return "it does not end where it says, after " + std::to_string(size) + " bytes";
        _field = {};
        _begin = _at;
        _fieldsBefore = _fields.size();
        _field.parameter.edition = edition;
        _sections = {};
        _sections[0] = _bytes.substr(_at, edition == 1 ? 8 : 16);
        _at += _sections[0].size();
        _end -= end.size();
        Problem problem = edition == 1 ? readEdition1() : readEdition2();
        _at = _end + end.size();
        return problem;
    }

    /// The next section, whose length its first octets say.
    Problem take(std::size_t section, std::size_t lengthOctets) {
        const std::uint64_t length = number(_at, lengthOctets);
        if (length < lengthOctets + 1 || length > _end - _at)
            return "section " + std::to_string(section) + " is longer than what is left of the message";
        _sections[section] = _bytes.substr(_at, static_cast<std::size_t>(length));
        _at += static_cast<std::size_t>(length);
        return {};
    }

    Problem readEdition1() {
        const std::uint64_t present = number(_at + 7, 1);
        constexpr std::uint64_t hasGrid = 0x80, hasBitmap = 0x40;
        for (const std::size_t section : {1u, 2u, 3u, 4u})
            if ((section != 2 || present & hasGrid) && (section != 3 || present & hasBitmap))
                if (Problem problem = take(section, 3))
                    return problem;
        return addField(_sections[2].substr(0, gridEnd1()));
    }

    /// Where the grid of section 2 of edition 1 ends, after which there may be vertical coordinates.
    std::size_t gridEnd1() const {
        const auto octet = [&](std::size_t at) {
            return at < _sections[2].size() ? static_cast<unsigned char>(_sections[2][at]) : 0u;
        };
        return octet(3) > 0 && octet(4) > 28 && octet(4) != 255 ? octet(4) - 1 : std::string_view::npos;
    }

    Problem readEdition2() {
        bool hasProduct = false;
        while (_at < _end) {
            const auto section = static_cast<std::size_t>(_end - _at > 4 ? number(_at + 4, 1) : 0);
            if (section < 1 || section > 7)
                return "expected a section 1 to 7, found " + std::to_string(section);
            const std::string_view bitmap = _sections[6];
            if (Problem problem = take(section, 4))
                return problem;
            constexpr unsigned char asBefore = 254;
            if (section == 6 && !bitmap.empty() && _sections[6].size() > 5 &&
                static_cast<unsigned char>(_sections[6][5]) == asBefore)
                _sections[6] = bitmap;
            hasProduct = (hasProduct || section == 4) && section != 7;
            if (section != 7)
                continue;
            if (_sections[1].empty() || _sections[3].empty() || _sections[4].empty())
                return "numbers without sections 1, 3 and 4";
            if (Problem problem = addField(_sections[3]))
                return problem;
        }
        return hasProduct ? Problem("section 4 without numbers") : Problem();
    }

    Problem addField(std::string_view grid) {
        if (_field.parameter.edition == 1 || (_fields.size() == _fieldsBefore && _at == _end))
            _field.parts = {_bytes.substr(_begin, _end + end.size() - _begin)};
        else {
            _field.parts.assign(_sections.begin(), _sections.end());
            _field.parts.push_back(end);
        }
        const GribHandle handle(_field.parts);
        if (!handle)
            return "ecCodes cannot decode it";
        const auto part = [&](const char* key) { return static_cast<int>(handle.whole(key).value_or(0)); };
        GribParameter& parameter = _field.parameter;
        const bool first = parameter.edition == 1;
        const char* const number = first ? "indicatorOfParameter" : "parameterNumber";
        if (!handle.whole(number))
            return "ecCodes cannot decode its grid, of template " +
                   std::to_string(part("gridDefinitionTemplateNumber"));
        if (handle.text("gridType").empty())
            return "ecCodes cannot decode how its numbers are packed";
        parameter = {parameter.edition, part("centre"), part(first ? "table2Version" : "discipline"),
                     part("parameterCategory"), part(number)};
        _field.level = levelOf(handle, parameter.edition);
        if (!readTimes(handle, _field))
            return "section 1 has a date that does not exist";
        _field.grid = gridOf(handle, parameter.edition, grid);
        if (grid.empty())
            _field.grid.kind = "catalogued";
        _fields.push_back(_field);
        _field.momentary = false;
        return {};
    }

    std::string_view _bytes;
    std::size_t _at = 0, _begin = 0, _end = 0, _message = 0, _fieldsBefore = 0;
    std::array<std::string_view, 8> _sections;
    GribField _field;
    std::vector<GribField> _fields;
};

} // namespace

Result<std::vector<GribField>> readGribFields(std::string_view bytes, const std::string& file) {
    Result<std::vector<GribField>> fields = Walk(bytes).read(file);
    if (fields && fields.value().empty())
        return fileProblem(file, "holds no field of GRIB");
    return fields;
}

} // namespace osgTreeWind

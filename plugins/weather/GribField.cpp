// SPDX-License-Identifier: MIT
#include <plugins/weather/GribField.h>

#include <plugins/weather/GribHandle.h>
#include <plugins/weather/GribMeaning.h>

#include <osgTreeWind/base/IsoTime.h>
#include <osgTreeWind/base/Problem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <optional>

namespace osgTreeWind {

namespace {

/// The problem of a message, if any.
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

/// The row of a level type; null if unknown.
const LevelRow* rowOf(int edition, int type) {
    const auto row = std::find_if(std::begin(levelRows), std::end(levelRows), [&](const LevelRow& each) {
        return each.edition == edition && each.type == type;
    });
    return row == std::end(levelRows) ? nullptr : row;
}

double valueOf(const GribLevel& level, const GribHandle& handle, int edition) {
    if (edition == 1) {
        const LevelRow* row = rowOf(edition, level.type);
        return (row ? row->unit : 1.0) *
               static_cast<double>(handle.integer(level.type == 110 ? "topLevel" : "level").value_or(0));
    }
    const auto value = handle.integer("scaledValueOfFirstFixedSurface");
    const auto scale = handle.integer("scaleFactorOfFirstFixedSurface").value_or(0);
    return value ? static_cast<double>(*value) * std::pow(10.0, -static_cast<double>(scale)) : 0.0;
}

/// Seconds in a unit of time; empty for months, years and unknown units.
std::optional<double> secondsOfUnit(int edition, int unit) {
    struct Unit {
        int edition, number; // edition 0: both
        double seconds;
    };
    constexpr Unit units[] = {{0, 0, 60.0},     {0, 1, 3600.0},   {0, 2, 86400.0}, {0, 10, 10800.0},
                              {0, 11, 21600.0}, {0, 12, 43200.0}, {1, 13, 900.0},  {1, 14, 1800.0},
                              {1, 254, 1.0},    {2, 13, 1.0}};
    for (const Unit& each : units)
        if (each.number == unit && (each.edition == 0 || each.edition == edition))
            return each.seconds;
    return std::nullopt;
}

constexpr int analysis = 1, ofP1 = 0, ofTwoOctets = 10; // time ranges of edition 1

/// Sets the times of a field. @return false if the date does not exist.
bool readTimes(const GribHandle& handle, GribField& field) {
    const auto part = [&](const char* key) { return static_cast<int>(handle.integer(key).value_or(0)); };
    const int date = part("dataDate");
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d:%02dZ", date / 10000, date / 100 % 100,
                  date % 100, part("hour"), part("minute"), part("second"));
    const auto reference = parseIsoTime(text.data());
    if (!reference)
        return false;
    field.reference = field.valid = *reference;
    if (!field.isInstantaneous)
        return true;
    const int edition = field.parameter.edition, range = part("timeRangeIndicator");
    const auto unit = secondsOfUnit(edition, part("indicatorOfUnitOfTimeRange"));
    field.isInstantaneous = unit || (edition == 1 && range == analysis);
    if (unit && edition == 2)
        field.valid += *unit * part("forecastTime");
    else if (unit && range != analysis)
        field.valid += *unit * (range == ofP1 ? part("P1") : part("P1") * 256 + part("P2"));
    return true;
}

struct GridRow {
    const char *type, *name;
    bool isEven = false;
};

/// Grids by gridType of ecCodes.
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
            grid.isEven = row.isEven;
        }
    const auto sizeOf = [&](const char* degrees, const char* metres) {
        const auto size = handle.integer(degrees);
        return static_cast<std::uint64_t>((size ? size : handle.integer(metres)).value_or(0));
    };
    grid.columns = sizeOf("Ni", "Nx");
    grid.rows = sizeOf("Nj", "Ny");
    constexpr int toGridFlag = 0x08;
    const char* const key = "resolutionAndComponentFlags";
    grid.relativeToGrid = handle.integer(key).value_or(0) & toGridFlag;
    const auto flags = handle.offset(key);
    const auto begin = handle.integer(edition == 1 ? "offsetSection2" : "offsetSection3");
    if (const std::size_t at = flags && begin ? *flags - static_cast<std::size_t>(*begin) : 0;
        at > 0 && at < section.size())
        grid.definition[at] = static_cast<char>(grid.definition[at] & ~toGridFlag);
    return grid;
}

/// Scans the messages of a file and their sections.
class MessageScanner {
public:
    explicit MessageScanner(std::string_view bytes) : _bytes(bytes) {}

    Result<std::vector<GribField>> read(const std::string& file) {
        while ((_at = _bytes.find(start, _at)) != std::string_view::npos) {
            _begin = _at;
            ++_message;
            if (const Problem problem = readMessage())
                return fileProblem(file, place() + *problem);
        }
        if (_fieldCount == 0)
            return fileProblem(file, "contains no GRIB field");
        return std::move(_fields);
    }

private:
    std::string place() const {
        return "message " + std::to_string(_message) + ", at byte " + std::to_string(_begin) + ": ";
    }

    /// A big-endian integer.
    std::uint64_t number(std::size_t at, std::size_t count) const {
        std::uint64_t value = 0;
        for (std::size_t i = at; i < at + count; ++i)
            value = value << 8 | (i < _bytes.size() ? static_cast<unsigned char>(_bytes[i]) : 0u);
        return value;
    }

    Problem readMessage() {
        if (_bytes.size() - _at < 16)
            return "truncated in its first section";
        const auto edition = static_cast<int>(number(_at + 7, 1));
        if (edition != 1 && edition != 2)
            return "expected edition 1 or 2, found " + std::to_string(edition);
        const std::uint64_t size = edition == 1 ? number(_at + 4, 3) : number(_at + 8, 8);
        if (size > _bytes.size() - _at)
            return "expected " + std::to_string(size) + " bytes, the file ends after " +
                   std::to_string(_bytes.size() - _at);
        _end = _at + static_cast<std::size_t>(size);
        if (size < 20 || _bytes.substr(_end - end.size(), end.size()) != end)
            return "expected its end after " + std::to_string(size) + " bytes";
        _previousFieldCount = _fieldCount;
        _edition = edition;
        _sections = {};
        _sections[0] = _bytes.substr(_at, edition == 1 ? 8 : 16);
        _at += _sections[0].size();
        _end -= end.size();
        Problem problem = edition == 1 ? readEdition1() : readEdition2();
        _at = _end + end.size();
        return problem;
    }

    /// Reads the next section, which begins with its length.
    Problem readSection(std::size_t section, std::size_t lengthOctets) {
        const std::uint64_t length = number(_at, lengthOctets);
        if (length < lengthOctets + 1 || length > _end - _at)
            return "section " + std::to_string(section) + " is longer than the rest of the message";
        _sections[section] = _bytes.substr(_at, static_cast<std::size_t>(length));
        _at += static_cast<std::size_t>(length);
        return {};
    }

    Problem readEdition1() {
        const std::uint64_t present = number(_at + 7, 1);
        constexpr std::uint64_t hasGrid = 0x80, hasBitmap = 0x40;
        for (const std::size_t section : {1u, 2u, 3u, 4u})
            if ((section != 2 || present & hasGrid) && (section != 3 || present & hasBitmap))
                if (Problem problem = readSection(section, 3))
                    return problem;
        addField(_sections[2].substr(0, gridEnd1()));
        return {};
    }

    /// End of the grid definition in section 2 of edition 1; vertical coordinates may follow.
    std::size_t gridEnd1() const {
        const int numbers = octet(2, 3), begin = octet(2, 4);
        return numbers > 0 && begin > 28 && begin != 255 ? static_cast<std::size_t>(begin - 1)
                                                         : std::string_view::npos;
    }

    Problem readEdition2() {
        bool hasProduct = false;
        while (_at < _end) {
            const auto section = static_cast<std::size_t>(_end - _at > 4 ? number(_at + 4, 1) : 0);
            if (section < 1 || section > 7)
                return "expected a section 1 to 7, found " + std::to_string(section);
            const std::string_view bitmap = _sections[6];
            if (Problem problem = readSection(section, 4))
                return problem;
            constexpr unsigned char asBefore = 254;
            if (section == 6 && !bitmap.empty() && _sections[6].size() > 5 &&
                static_cast<unsigned char>(_sections[6][5]) == asBefore)
                _sections[6] = bitmap;
            hasProduct = (hasProduct || section == 4) && section != 7;
            if (section != 7)
                continue;
            if (_sections[1].empty() || _sections[3].empty() || _sections[4].empty())
                return "section 7 without sections 1, 3 and 4";
            addField(_sections[3]);
        }
        return hasProduct ? Problem("section 4 without section 7") : Problem();
    }

    /// The octet of a section at an offset; 255 ("missing") beyond its end.
    int octet(std::size_t section, std::size_t at) const {
        return at < _sections[section].size() ? static_cast<unsigned char>(_sections[section][at]) : 255;
    }

    /// Reads quantity and level from octets, which works with any grid and packing.
    GribField identifyField() const {
        GribField field;
        int type = 0;
        bool isLayer = false;
        if (_edition == 1) {
            field.parameter = {1, octet(1, 4), octet(1, 3), 0, octet(1, 8)};
            const int range = octet(1, 20);
            field.isInstantaneous = range == analysis || range == ofP1 || range == ofTwoOctets;
            type = octet(1, 9);
        } else {
            constexpr int lastInstantaneous =
                2; // templates 0 to 2: forecast, ensemble member, derived from members
            field.parameter = {2, 0, octet(0, 6), octet(4, 9), octet(4, 10)};
            field.isInstantaneous = octet(4, 7) == 0 && octet(4, 8) <= lastInstantaneous;
            type = octet(4, 22);
            isLayer = octet(4, 28) != 255; // from one level to another
        }
        const LevelRow* row = rowOf(_edition, type);
        const GribLevelKind kind = row ? row->kind : GribLevelKind::Other;
        field.level = {isLayer && kind != GribLevelKind::Model ? GribLevelKind::Other : kind, type, 0.0};
        return field;
    }

    void addField(std::string_view grid) {
        const bool isOnly = _edition == 1 || (_fieldCount == _previousFieldCount && _at == _end);
        ++_fieldCount;
        GribField field = identifyField();
        if (GribMeaning::of(field).quantity == GribMeaning::Quantity::None)
            return;
        if (isOnly)
            field.parts = {_bytes.substr(_begin, _end + end.size() - _begin)};
        else {
            field.parts.assign(_sections.begin(), _sections.end());
            field.parts.push_back(end);
        }
        if (const Problem problem = decode(grid, field))
            field.problem = place() + *problem;
        _fields.push_back(std::move(field));
    }

    Problem decode(std::string_view grid, GribField& field) const {
        const GribHandle handle(field.parts);
        if (!handle)
            return "ecCodes cannot decode it";
        if (_edition == 2 && !handle.integer("parameterNumber"))
            return "ecCodes cannot decode its grid, of template " +
                   std::to_string(handle.integer("gridDefinitionTemplateNumber").value_or(0));
        if (handle.text("gridType").empty())
            return "ecCodes cannot decode the packing of its values";
        field.level.value = valueOf(field.level, handle, _edition);
        if (!readTimes(handle, field))
            return "section 1 has a date that does not exist";
        field.grid = gridOf(handle, _edition, grid);
        if (grid.empty())
            field.grid.kind = "catalogued";
        return {};
    }

    std::string_view _bytes;
    std::size_t _at = 0, _begin = 0, _end = 0, _message = 0;
    std::size_t _fieldCount = 0, _previousFieldCount = 0; ///< All fields; fields in previous messages.
    int _edition = 2;
    std::array<std::string_view, 8> _sections;
    std::vector<GribField> _fields;
};

} // namespace

Result<std::vector<GribField>> readGribFields(std::string_view bytes, const std::string& file) {
    return MessageScanner(bytes).read(file);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/weather/GribField.h>

#include <plugins/weather/GribHandle.h>
#include <plugins/weather/GribMeaning.h>
#include <plugins/weather/Words.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/Problem.h>

#include <array>
#include <cstdio>
#include <optional>
#include <utility>

namespace osgTreeWind {

namespace {

/// The problem of a message, if any.
using Problem = std::optional<std::string>;

constexpr std::string_view start = "GRIB", end = "7777";

GribParameter parameterOf(const GribHandle& product) {
    if (const long table = product.integer("table2Version", -1); table >= 0)
        return {1, product.integer("centre"), table, 0, product.integer("indicatorOfParameter")};
    return {2, 0, product.integer("discipline"), product.integer("parameterCategory", 255),
            product.integer("parameterNumber", 255)};
}

GribLevelKind kindOf(const std::string& typeOfLevel) {
    if (isOneOf(typeOfLevel, {"isobaricInPa", "isobaricInhPa"}))
        return GribLevelKind::Isobaric;
    if (startsWithAny(typeOfLevel, {"hybrid", "eta", "generalVertical"}))
        return GribLevelKind::Model;
    return typeOfLevel == "heightAboveGround" ? GribLevelKind::AboveGround
           : typeOfLevel == "heightAboveSea"  ? GribLevelKind::AboveSea
           : typeOfLevel == "surface"         ? GribLevelKind::Surface
                                              : GribLevelKind::Other;
}

GribLevel levelOf(const GribHandle& product) {
    product.set("pressureUnits", "Pa"); // in hPa, ecCodes rounds the levels of edition 2
    const std::string type = product.text("typeOfLevel");
    const double unit = type == "isobaricInhPa" ? 100.0 : 1.0;
    return {kindOf(type), product.integer("levelType"), unit * product.real("level")};
}

/// Seconds from the start of the forecast; empty if the field is not at a single time.
std::optional<double> leadTimeOf(const GribHandle& product) {
    // Months differ in length.
    constexpr std::pair<const char*, double> units[] = {{"s", 1.0},      {"m", 60.0},      {"15m", 900.0},
                                                        {"30m", 1800.0}, {"h", 3600.0},    {"3h", 10800.0},
                                                        {"6h", 21600.0}, {"12h", 43200.0}, {"D", 86400.0}};
    constexpr long lastTemplate = 2; // 0 to 2: forecast, ensemble member, derived from members
    if (product.text("stepType") != "instant" ||
        product.integer("productDefinitionTemplateNumber") > lastTemplate)
        return {};
    for (const auto& [unit, seconds] : units)
        if (product.text("indicatorOfUnitOfTimeRange") == unit) {
            product.set("stepUnits", unit);
            return seconds * static_cast<double>(product.integer("startStep"));
        }
    return {};
}

/// Start of the forecast; empty if its date does not exist.
std::optional<double> referenceOf(const GribHandle& product) {
    const long date = product.integer("dataDate");
    std::array<char, 120> text{};
    std::snprintf(text.data(), text.size(), "%04ld-%02ld-%02ldT%02ld:%02ld:%02ldZ", date / 10000,
                  date / 100 % 100, date % 100, product.integer("hour"), product.integer("minute"),
                  product.integer("second"));
    return parseDate(text.data());
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

GribGrid gridOf(const GribHandle& message) {
    GribGrid grid;
    grid.kind = message.text("gridType");
    for (const GridRow& row : gridRows)
        if (grid.kind == row.type) {
            grid.kind = row.name;
            grid.isEven = row.isEven;
        }
    if (message.integer("gridDescriptionSectionPresent") == 0)
        grid.kind = "catalogued";
    grid.columns = static_cast<std::uint64_t>(message.integer("Ni", message.integer("Nx")));
    grid.rows = static_cast<std::uint64_t>(message.integer("Nj", message.integer("Ny")));
    grid.relativeToGrid = message.integer("uvRelativeToGrid") != 0;
    message.set("uvRelativeToGrid", "0");
    grid.definition = message.text("md5GridSection");
    return grid;
}

/// Sum of the sections, in octets.
std::uint64_t sizeOf(const GribHandle& message) {
    long size = 0;
    for (const char* key :
         {"section0Length", "section1Length", "section2Length", "section3Length", "section4Length"})
        size += message.integer(key);
    return static_cast<std::uint64_t>(size);
}

/// Scans the messages of a file and their sections.
class MessageScanner {
public:
    explicit MessageScanner(std::string_view bytes) : _bytes(bytes) {}

    Result<std::vector<GribField>> read(const std::string& file) {
        while ((_begin = _bytes.find(start, _end)) != std::string_view::npos) {
            ++_message;
            if (const Problem problem = readMessage(_bytes.substr(_begin)))
                return fileProblem(file, place() + *problem);
        }
        if (!_hasField)
            return fileProblem(file, "contains no GRIB field");
        return std::move(_fields);
    }

private:
    using Sections = std::array<std::string_view, 8>;

    std::string place() const {
        return "message " + std::to_string(_message) + ", at byte " + std::to_string(_begin) + ": ";
    }

    /// A big-endian integer.
    static std::uint64_t number(std::string_view octets) {
        std::uint64_t value = 0;
        for (const char octet : octets)
            value = value << 8 | static_cast<unsigned char>(octet);
        return value;
    }

    Problem readMessage(std::string_view bytes) {
        if (bytes.size() < 16)
            return "truncated in its first section";
        const std::uint64_t edition = number(bytes.substr(7, 1));
        if (edition != 1 && edition != 2)
            return "expected edition 1 or 2, found " + std::to_string(edition);
        const std::uint64_t size = number(edition == 1 ? bytes.substr(4, 3) : bytes.substr(8, 8));
        if (size > bytes.size())
            return "expected " + std::to_string(size) + " bytes, the file ends after " +
                   std::to_string(bytes.size());
        bytes = bytes.substr(0, static_cast<std::size_t>(size));
        if (size < 20 || bytes.substr(bytes.size() - end.size()) != end)
            return "expected its end after " + std::to_string(size) + " bytes";
        _end = _begin + bytes.size();
        bytes.remove_suffix(end.size());
        return edition == 1 ? readField({bytes}) : readEdition2(bytes);
    }

    /// Reads the fields of a message, which share sections.
    Problem readEdition2(std::string_view bytes) {
        Sections sections = {bytes.substr(0, 16)};
        bytes.remove_prefix(sections[0].size());
        bool hasProduct = false;
        while (!bytes.empty()) {
            const std::uint64_t section = bytes.size() > 4 ? number(bytes.substr(4, 1)) : 0;
            if (section < 1 || section > 7)
                return "expected a section 1 to 7, found " + std::to_string(section);
            const std::uint64_t size = number(bytes.substr(0, 4));
            if (size < 5 || size > bytes.size())
                return "section " + std::to_string(section) + " is longer than the rest of the message";
            const std::string_view content = bytes.substr(0, static_cast<std::size_t>(size));
            bytes.remove_prefix(content.size());
            constexpr char asBefore = '\xfe';
            const bool repeatsBitmap = section == 6 && content.size() > 5 && content[5] == asBefore;
            if (!repeatsBitmap || sections[6].empty())
                sections[section] = content;
            hasProduct = (hasProduct || section == 4) && section != 7;
            if (section != 7)
                continue;
            if (sections[1].empty() || sections[3].empty() || sections[4].empty())
                return "section 7 without sections 1, 3 and 4";
            if (Problem problem = readField(sections))
                return problem;
        }
        return hasProduct ? Problem("section 4 without section 7") : Problem();
    }

    /// @param sections of edition 2; of edition 1, the first is the whole message.
    Problem readField(const Sections& sections) {
        _hasField = true;
        // ecCodes reads sections 1 and 4 of any message if it does not see its grid and packing.
        const GribHandle product({sections[0], sections[1], sections[4], end});
        if (!product)
            return "ecCodes cannot decode it";
        if (sections[1].empty() && sizeOf(product) > sections[0].size())
            return "its sections are longer than the message";
        GribField field;
        field.parameter = parameterOf(product);
        field.level = levelOf(product);
        const auto lead = leadTimeOf(product);
        field.isInstantaneous = lead.has_value();
        if (GribMeaning::of(field).quantity == GribMeaning::Quantity::None)
            return {};
        field.name = product.text("shortName");
        field.variable = product.text("cfVarName");
        field.parts.assign(sections.begin(), sections.end());
        field.parts.push_back(end);
        const auto reference = referenceOf(product);
        field.reference = reference.value_or(0.0);
        field.valid = field.reference + lead.value_or(0.0);
        const Problem problem = reference ? readGrid(field) : "section 1 has a date that does not exist";
        if (problem)
            field.problem = place() + *problem;
        _fields.push_back(std::move(field));
        return {};
    }

    static Problem readGrid(GribField& field) {
        const GribHandle message(field.parts);
        if (!message)
            return "ecCodes cannot decode it";
        if (field.parameter.edition == 2 && message.integer("parameterNumber", -1) < 0)
            return "ecCodes cannot decode its grid, of template " +
                   std::to_string(message.integer("gridDefinitionTemplateNumber"));
        if (message.text("gridType").empty())
            return "ecCodes cannot decode the packing of its values";
        field.grid = gridOf(message);
        return {};
    }

    std::string_view _bytes;
    std::size_t _begin = 0, _end = 0; ///< Of the message.
    std::size_t _message = 0;
    bool _hasField = false;
    std::vector<GribField> _fields;
};

} // namespace

Result<std::vector<GribField>> readGribFields(std::string_view bytes, const std::string& file) {
    return MessageScanner(bytes).read(file);
}

} // namespace osgTreeWind

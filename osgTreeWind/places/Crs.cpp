// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/Crs.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/places/GdalErrors.h>

#include <cpl_conv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// Whether PROJ would look into a file or ask the network for it.
bool isFileOrAddress(const std::string& text) {
    std::error_code ignored;
    return text.find("/vsi") != std::string::npos || std::filesystem::exists(text, ignored) ||
           (text.find("://") != std::string::npos && text.find("opengis.net/def/crs") == std::string::npos);
}

} // namespace

Crs::Crs(void* reference) : _reference(reference, [](void* held) { OSRRelease(held); }) {
    if (OSRIsCompound(reference))
        OSRStripVertical(reference);
}

Result<Crs> Crs::parse(const std::string& text) {
    const GdalErrors errors;
    const std::string expected =
        "expected a coordinate reference system that PROJ knows, as EPSG:25832, found ";
    if (text.empty() || isFileOrAddress(text))
        return keyProblem("crs", expected + inQuotes(text));
    std::unique_ptr<void, decltype(&OSRRelease)> read(OSRNewSpatialReference(nullptr), &OSRRelease);
    if (OSRSetFromUserInput(read.get(), text.c_str()) != OGRERR_NONE)
        return keyProblem("crs", expected + inQuotes(text) +
                                     (errors.text().empty() ? "" : " (" + errors.text() + ')'));
    OSRSetAxisMappingStrategy(read.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return Crs(read.release());
}

Result<Crs> Crs::parseMap(const std::string& text) {
    Result<Crs> crs = parse(text);
    if (crs)
        if (const std::string problem = crs.value().problemOfMap(); !problem.empty())
            return keyProblem("crs", problem);
    return crs;
}

Result<Crs> Crs::utmOf(const glm::dvec2& longitudeLatitude) {
    const double turns = std::floor((longitudeLatitude.x + 180.0) / 6.0);
    const int zone = 1 + static_cast<int>(turns - 60.0 * std::floor(turns / 60.0));
    return parse("EPSG:" + std::to_string((longitudeLatitude.y < 0.0 ? 32700 : 32600) + zone));
}

Result<Crs> Crs::degrees() {
    return parse("EPSG:4326");
}

bool Crs::isSame(const Crs& other) const {
    const GdalErrors errors;
    return OSRIsSame(reference(), other.reference());
}

bool Crs::isDegrees() const {
    return OSRIsGeographic(reference());
}

std::string Crs::problemOfMap() const {
    const std::string found = ", found " + name();
    if (!OSRIsProjected(reference()))
        return "expected a projected system in metres" + found + (isDegrees() ? ", which is on degrees" : "");
    char* unit = nullptr;
    if (std::abs(OSRGetLinearUnits(reference(), &unit) - 1.0) > 1e-9)
        return "expected a projected system in metres" + found + " in " + orEmpty(unit);
    for (int axis = 0; axis < 2; ++axis) {
        OGRAxisOrientation orientation = OAO_Other;
        OSRGetAxis(reference(), nullptr, axis, &orientation);
        if (orientation == OAO_West)
            return "expected x to the east and y to the north" + found;
    }
    return {};
}

std::string Crs::name() const {
    const std::string known = orEmpty(OSRGetName(reference()));
    return known.empty() || known == "unknown" || known == "unnamed" ? text() : known;
}

std::string Crs::text() const {
    const GdalErrors errors;
    const std::string authority = orEmpty(OSRGetAuthorityName(reference(), nullptr)),
                      code = orEmpty(OSRGetAuthorityCode(reference(), nullptr));
    if (!authority.empty() && !code.empty())
        return authority + ':' + code;
    char* written = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
    OSRExportToWktEx(reference(), &written, options);
    std::string text = orEmpty(written);
    CPLFree(written);
    return text;
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <plugins/map/GdalCrs.h>

#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/system/Path.h>

#include <cpl_conv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// Whether PROJ would read a file or use the network for a text.
bool isFileOrAddress(const std::string& text) {
    std::error_code ignored;
    return text.find("/vsi") != std::string::npos || std::filesystem::exists(toPath(text), ignored) ||
           (text.find("://") != std::string::npos && text.find("opengis.net/def/crs") == std::string::npos);
}

} // namespace

GdalCrs::GdalCrs(void* reference) : _reference(reference, [](void* held) { OSRRelease(held); }) {
    if (OSRIsCompound(reference))
        OSRStripVertical(reference);
}

Result<GdalCrs> GdalCrs::parse(const std::string& text) {
    const GdalErrors errors;
    const std::string expected =
        "expected a coordinate reference system that PROJ knows, such as EPSG:25832, found ";
    if (text.empty() || isFileOrAddress(text))
        return keyProblem("crs", expected + inQuotes(text));
    std::unique_ptr<void, decltype(&OSRRelease)> read(OSRNewSpatialReference(nullptr), &OSRRelease);
    if (OSRSetFromUserInput(read.get(), text.c_str()) != OGRERR_NONE)
        return keyProblem("crs", expected + inQuotes(text) +
                                     (errors.text().empty() ? "" : " (" + errors.text() + ')'));
    OSRSetAxisMappingStrategy(read.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return GdalCrs(read.release());
}

Crs GdalCrs::crs() const {
    return Crs({text(), name(), problemOfMap(), OSRIsGeographic(reference()) != 0});
}

std::string GdalCrs::problemOfMap() const {
    const std::string found = ", found " + name();
    if (!OSRIsProjected(reference()))
        return "expected a projected system in metres" + found +
               (OSRIsGeographic(reference()) ? ", which uses degrees" : "");
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

std::string GdalCrs::name() const {
    const std::string known = orEmpty(OSRGetName(reference()));
    return known.empty() || known == "unknown" || known == "unnamed" ? text() : known;
}

std::string GdalCrs::text() const {
    const GdalErrors errors;
    const std::string authority = orEmpty(OSRGetAuthorityName(reference(), nullptr)),
                      code = orEmpty(OSRGetAuthorityCode(reference(), nullptr));
    if (!authority.empty() && !code.empty())
        return authority + ':' + code;
    return wkt();
}

std::string GdalCrs::wkt() const {
    char* written = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
    OSRExportToWktEx(reference(), &written, options);
    std::string text = orEmpty(written);
    CPLFree(written);
    return text;
}

std::string projText(const Crs& crs) {
    const GdalErrors errors;
    char* text = nullptr;
    const Result<GdalCrs> known = GdalCrs::parse(crs.text());
    const OGRErr error = known ? OSRExportToProj4(known.value().reference(), &text) : OGRERR_FAILURE;
    std::string written = error == OGRERR_NONE && text && *text ? text : crs.name();
    CPLFree(text);
    return written;
}

} // namespace osgTreeWind

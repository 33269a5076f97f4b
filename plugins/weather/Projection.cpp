// SPDX-License-Identifier: MIT
#include <plugins/weather/Projection.h>

#include <cpl_conv.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

Projection::Projection(OGRSpatialReferenceH reference) : _reference(reference, &OSRDestroySpatialReference) {
    findWays();
}

Projection::Projection(const std::string& text)
    : _reference(OSRNewSpatialReference(nullptr), &OSRDestroySpatialReference) {
    if (OSRImportFromProj4(_reference.get(), text.c_str()) == OGRERR_NONE)
        findWays();
}

void Projection::findWays() {
    const std::unique_ptr<std::remove_pointer_t<OGRSpatialReferenceH>, decltype(&OSRDestroySpatialReference)>
        globe(OSRCloneGeogCS(_reference.get()), &OSRDestroySpatialReference);
    if (!globe)
        return;
    OSRSetAxisMappingStrategy(_reference.get(), OAMS_TRADITIONAL_GIS_ORDER);
    OSRSetAxisMappingStrategy(globe.get(), OAMS_TRADITIONAL_GIS_ORDER);
    _toMap.reset(OCTNewCoordinateTransformation(globe.get(), _reference.get()));
    _toGlobe.reset(OCTNewCoordinateTransformation(_reference.get(), globe.get()));
}

bool Projection::go(OGRCoordinateTransformationH way, std::vector<glm::dvec2>& places) {
    for (glm::dvec2& place : places)
        if (!OCTTransform(way, 1, &place.x, &place.y, nullptr))
            return false;
    return true;
}

std::string Projection::name() const {
    const char* known = OSRGetName(_reference.get());
    std::string name = known ? known : "";
    if (!name.empty() && name != "unnamed" && name != "unknown")
        return name;
    char* text = nullptr;
    name = OSRExportToProj4(_reference.get(), &text) == OGRERR_NONE && text ? text : "";
    CPLFree(text);
    return name;
}

std::vector<glm::dvec2> Projection::trueNorth(std::vector<glm::dvec2> points) const {
    const double unit = OSRGetLinearUnits(_reference.get(), nullptr);
    std::vector<glm::dvec2> places = points;
    for (glm::dvec2& place : places)
        place /= unit;
    if (!good() || !go(_toGlobe.get(), places))
        return {};
    std::vector<double> steps;
    for (glm::dvec2& place : places) {
        steps.push_back(place.y > 0.0 ? -1e-4 : 1e-4); // some metres, never across a pole
        place.y += steps.back();
    }
    if (!toMap(places))
        return {};
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = glm::normalize((places[i] * unit - points[i]) / steps[i]);
    return points;
}

} // namespace osgTreeWind

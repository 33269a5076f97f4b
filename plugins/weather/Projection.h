// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <ogr_srs_api.h>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace osgTreeWind {

/// A reference system: the ways between its map and the longitudes and latitudes of its globe.
class Projection {
public:
    /// @param reference becomes its own; not null.
    explicit Projection(OGRSpatialReferenceH reference);
    /// @param text as PROJ writes it; a text it does not know makes one that is not good().
    explicit Projection(const std::string& text);

    /// Whether it has a map and ways to and from it.
    bool good() const { return _toMap && _toGlobe; }
    bool isMap() const { return OSRIsProjected(_reference.get()); }
    /// Its name; its PROJ text where it has none.
    std::string name() const;

    /// Places on the map, in its unit, of longitudes and latitudes in degrees. False where one has none.
    bool toMap(std::vector<glm::dvec2>& places) const { return go(_toMap.get(), places); }

    /// The way true north lies at points of the map: unit vectors along its x and y. Empty where it cannot
    /// say. @param points metres.
    std::vector<glm::dvec2> trueNorth(std::vector<glm::dvec2> points) const;

private:
    using Way = std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>,
                                decltype(&OCTDestroyCoordinateTransformation)>;

    void findWays();
    static bool go(OGRCoordinateTransformationH way, std::vector<glm::dvec2>& places);

    std::unique_ptr<std::remove_pointer_t<OGRSpatialReferenceH>, decltype(&OSRDestroySpatialReference)>
        _reference;
    Way _toMap{nullptr, &OCTDestroyCoordinateTransformation};
    Way _toGlobe{nullptr, &OCTDestroyCoordinateTransformation};
};

} // namespace osgTreeWind

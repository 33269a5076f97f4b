// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <memory>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// A transform of places from one CRS to another. Only one thread at a time may use it and its copies.
class CrsTransform {
public:
    /// The identity.
    CrsTransform() = default;
    static Result<CrsTransform> between(const Crs& from, const Crs& to);

    bool isIdentity() const { return !_handle; }
    const Crs& from() const { return _from; }
    const Crs& to() const { return _to; }

    /// Transforms many places at once. A place that cannot be transformed becomes NaN.
    void apply(std::vector<glm::dvec2>& places) const;
    /// Transforms one place. @return false if it cannot be transformed and became NaN.
    bool apply(glm::dvec2& place) const;

    /// The implementation: an OGRCoordinateTransformationH in programs that link GDAL, or else a MapProgram.
    void* handle() const { return _handle.get(); }

private:
    Crs _from, _to;
    std::shared_ptr<void> _handle; ///< Null for the identity.
};

/// Longitude and latitude of a place on WGS 84, degrees; empty if it cannot be transformed.
std::optional<glm::dvec2> longitudeLatitudeOf(glm::dvec2 place, const Crs& crs);

/// The UTM zone that contains a place. @param crs of the place. @param key in which a file states the system,
/// for the error message if the place is not valid in `crs`.
Result<Crs> utmZoneOf(glm::dvec2 place, const Crs& crs, const std::string& key);

} // namespace osgTreeWind

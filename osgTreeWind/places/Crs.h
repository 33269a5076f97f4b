// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec2.hpp>

#include <memory>
#include <string>

namespace osgTreeWind {

/// A coordinate reference system: what the numbers of a place on the Earth mean. Its places are x east and
/// y north, or longitude and latitude in degrees, whatever order its authority has. A value; its copies share
/// what PROJ holds, and are used by one thread at a time.
class Crs {
public:
    /// @param text any that PROJ knows: "EPSG:25832", "+proj=utm +zone=32", WKT.
    static Result<Crs> parse(const std::string& text);
    /// The same, for a scene: a map in metres.
    static Result<Crs> parseMap(const std::string& text);
    /// The UTM zone of a place.
    static Result<Crs> utmOf(const glm::dvec2& longitudeLatitude);
    /// Longitude and latitude (WGS 84).
    static Result<Crs> degrees();

    Crs() = default;
    /// @param reference an OGRSpatialReferenceH, which becomes its own; its order of axes counts, and nothing
    /// that it says of heights.
    explicit Crs(void* reference);

    /// Whether places of both mean the same.
    bool isSame(const Crs& other) const;
    /// Longitude and latitude, not a map.
    bool isDegrees() const;
    /// What keeps it from being a scene's, a map in metres with x east and y north; empty: nothing.
    std::string problemOfMap() const;
    /// As people call it: "WGS 84 / UTM zone 10N".
    std::string name() const;
    /// What parse() reads back: "EPSG:32610", or WKT where no authority has it.
    std::string text() const;

    void* reference() const { return _reference.get(); }

private:
    std::shared_ptr<void> _reference;
};

} // namespace osgTreeWind

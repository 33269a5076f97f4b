// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec2.hpp>

#include <string>
#include <tuple>
#include <utility>

namespace osgTreeWind {

/// A coordinate reference system (CRS). Its axes are always x east and y north, or longitude and latitude in
/// degrees, regardless of the order that its authority defines. A value type.
class Crs {
public:
    struct Facts {
        std::string text;         ///< Input for parse(): "EPSG:32610", or WKT if it has no code.
        std::string name;         ///< For users: "WGS 84 / UTM zone 10N".
        std::string problemOfMap; ///< See below.
        bool isDegrees = false;

        auto parts() { return std::tie(text, name, problemOfMap, isDegrees); } ///< For Wire.
    };

    /// @param text in any form that PROJ accepts: "EPSG:25832", "+proj=utm +zone=32", WKT.
    static Result<Crs> parse(const std::string& text);
    /// Parses a CRS for a scene. It is an error if problemOfMap() is not empty.
    static Result<Crs> parseMap(const std::string& text);
    /// The UTM zone that contains a place.
    static Result<Crs> utmOf(const glm::dvec2& longitudeLatitude);
    /// Longitude and latitude on WGS 84 (EPSG:4326).
    static Crs wgs84();

    Crs() = default;
    explicit Crs(Facts facts) : _facts(std::move(facts)) {}

    /// Whether both systems give the same coordinates to every place.
    bool isSame(const Crs& other) const;
    /// Whether it is geographic: longitude and latitude in degrees.
    bool isDegrees() const { return _facts.isDegrees; }
    /// Why it cannot be the CRS of a scene (projected, in metres, x east and y north); empty if it can.
    const std::string& problemOfMap() const { return _facts.problemOfMap; }
    const std::string& name() const { return _facts.name; }
    const std::string& text() const { return _facts.text; }
    const Facts& facts() const { return _facts; }

private:
    Facts _facts;
};

} // namespace osgTreeWind

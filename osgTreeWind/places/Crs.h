// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec2.hpp>

#include <string>
#include <tuple>
#include <utility>

namespace osgTreeWind {

/// A coordinate reference system: what the numbers of a place on the Earth mean. Its places are x east and
/// y north, or longitude and latitude in degrees, whatever order its authority has. A value.
class Crs {
public:
    /// What is known of one.
    struct Facts {
        std::string text; ///< What parse() reads back: "EPSG:32610", or WKT where no authority has it.
        std::string name; ///< As people call it: "WGS 84 / UTM zone 10N".
        std::string problemOfMap; ///< As below.
        bool isDegrees = false;

        auto parts() { return std::tie(text, name, problemOfMap, isDegrees); } ///< For Wire.
    };

    /// @param text any that PROJ knows: "EPSG:25832", "+proj=utm +zone=32", WKT.
    static Result<Crs> parse(const std::string& text);
    /// The same, for a scene: a map in metres.
    static Result<Crs> parseMap(const std::string& text);
    /// The UTM zone of a place.
    static Result<Crs> utmOf(const glm::dvec2& longitudeLatitude);
    /// Longitude and latitude (WGS 84).
    static Crs degrees();

    Crs() = default;
    explicit Crs(Facts facts) : _facts(std::move(facts)) {}

    /// Whether places of both mean the same.
    bool isSame(const Crs& other) const;
    /// Longitude and latitude, not a map.
    bool isDegrees() const { return _facts.isDegrees; }
    /// What keeps it from being a scene's, a map in metres with x east and y north; empty: nothing.
    const std::string& problemOfMap() const { return _facts.problemOfMap; }
    const std::string& name() const { return _facts.name; }
    const std::string& text() const { return _facts.text; }
    const Facts& facts() const { return _facts; }

private:
    Facts _facts;
};

} // namespace osgTreeWind

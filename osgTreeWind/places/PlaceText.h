// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <optional>
#include <string_view>

namespace osgTreeWind {

/// A coordinate as people write it: "9.981", "9°58'51.6\"E", "E9 58.86", "-9 58 51,6".
struct CoordinateText {
    double value = 0.0;
    char axis = 0;          ///< 'x' with E or W, 'y' with N or S, otherwise 0.
    bool isDegrees = false; ///< Whether it has such a letter, a mark, minutes or seconds.
};

/// Empty for anything else, also for minutes and seconds above 60, a latitude above 90, and "O", which is
/// east in German and west in French.
std::optional<CoordinateText> parseCoordinate(std::string_view text);

/// The place in a cell.
struct PlaceText {
    enum class Kind {
        None,
        Pair,    ///< Two coordinates: "48.88, 2.30", "(48.88, 2.30)", "N48°52.8' E2°18'".
        Point,   ///< A point as WKT.
        Geometry ///< Presumably another geometry as WKT, or one as GeoJSON, or hexadecimal WKB or EWKB.
    };
    Kind kind = Kind::None;
    glm::dvec2 place{0.0};     ///< Of a pair, as written, but (x, y) if its letters tell; of a point, (x, y).
    bool isOrdered = false;    ///< Whether letters tell which coordinate of a pair is x.
    bool hasBrackets = false;  ///< Whether it is a pair in brackets.
    std::optional<double> z{}; ///< Of a point.
    std::string_view geometry{}; ///< The text without "SRID=4326;".
    int srid = 0;                ///< Of EWKT; 0: none.
};

PlaceText parsePlace(std::string_view text);

} // namespace osgTreeWind

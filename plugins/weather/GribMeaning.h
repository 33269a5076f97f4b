// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribField.h>

#include <string>

/// What fields of GRIB are to someone who looks for wind.
namespace osgTreeWind::GribMeaning {

enum class Quantity { None, East, North, Up, PressureChange, Speed, Direction, Height };

/// A quantity, and where it was wanted.
struct Meaning {
    Quantity quantity = Quantity::None;
    double metres = 1.0; ///< Of a Height: what one of its unit is.
    GribLevel level;     ///< That of the field, or the one its parameter means.
};

Meaning of(const GribField& field);

/// "U", "geopotential height".
std::string nameOf(Quantity quantity);
/// "10 m above ground", "850 hPa".
std::string nameOf(const GribLevel& level);
/// "heights above ground", "isobaric levels".
std::string nameOf(GribLevelKind kind);

} // namespace osgTreeWind::GribMeaning

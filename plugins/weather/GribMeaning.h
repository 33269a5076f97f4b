// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribField.h>

#include <string>

/// Interprets GRIB fields as quantities of wind.
namespace osgTreeWind::GribMeaning {

enum class Quantity { None, East, North, Up, PressureChange, Speed, Direction, Height };

/// Quantity and level of a field.
struct Meaning {
    Quantity quantity = Quantity::None;
    double metres = 1.0; ///< Metres per unit of a Height.
    GribLevel level;     ///< Level of the field, or implied by its parameter.
};

Meaning of(const GribField& field);

/// "U", "geopotential height".
std::string nameOf(Quantity quantity);
/// "10 m above ground", "850 hPa".
std::string nameOf(const GribLevel& level);
/// "heights above ground", "isobaric levels".
std::string nameOf(GribLevelKind kind);

} // namespace osgTreeWind::GribMeaning

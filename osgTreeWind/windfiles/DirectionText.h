// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace osgTreeWind {

/// Degrees in a unit of directions: "deg", "10 deg" or "rad", and their spellings in names of columns ("°",
/// "degrees", "10s deg", "tens of degrees", "radians"); empty for other units.
std::optional<double> directionUnit(const std::string& name);

/// The unit of directions that ends the name of a column, "WD (10s deg)" or "wd_rad"; empty without one.
std::string directionUnitInName(const std::string& column);

/// Degrees clockwise from north of one of the 16 compass points: "N", "nne", "north-east", "West South West".
std::optional<double> compassDirection(const std::string& text);

/// Whether a cell says that the direction varies: "VRB", "VAR", "variable".
bool isVariableDirection(const std::string& text);

} // namespace osgTreeWind

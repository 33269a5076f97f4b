// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace osgTreeWind {

/// Degrees clockwise from north of one of the 16 compass points: "N", "nne", "north-east", "West South West".
std::optional<double> compassDirection(const std::string& text);

/// Whether a cell says that the direction varies: "VRB", "VAR", "variable".
bool isVariableDirection(const std::string& text);

} // namespace osgTreeWind

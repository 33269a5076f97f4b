// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace osgTreeWind {

/// What a unit measures. Sizes of units are in metres, metres per second, seconds and degrees.
enum class Dimension { Length, Speed, Time, Direction };

/// Size of a unit, by its name in .treewind files or another spelling that data files use, in upper or lower
/// case. Empty if the name is unknown; sizeOfUnit() knows more.
std::optional<double> knownUnit(Dimension dimension, const std::string& name);

/// The name of a unit in .treewind files: "m/s" for "m s-1" or "meters per second". Unknown names are
/// returned unchanged.
std::string canonicalUnit(Dimension dimension, const std::string& name);

/// For messages: "a unit of speed (m/s, km/h, kn, mph, ft/s)".
std::string expectedUnit(Dimension dimension);

/// The unit in a column's name: "ft" of "Height (ft)" and "DBH_ft", "km/h" of "Speed [km/h] mean". It stands
/// in brackets, even an unknown one at the end, or else, known, after a separator or in CamelCase at the end,
/// or as a word of three letters elsewhere. Empty without one.
std::string unitInName(Dimension dimension, const std::string& column);

} // namespace osgTreeWind

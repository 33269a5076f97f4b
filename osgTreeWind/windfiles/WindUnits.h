// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>

namespace osgTreeWind {

/// One unit of speed in m/s: "m/s", "km/h", "kn" (knots), "mph" or "ft/s". Any other name is an error that
/// lists them; its diagnostic has a message only.
Result<double> speedUnit(const std::string& name);

/// The unit as speedUnit() calls it: "m/s" for "m s-1", "meters per second", ...; the text itself otherwise.
std::string usualSpeedUnit(const std::string& text);

/// One unit of time in seconds: "s", "min" or "h". Any other name is an error that lists them.
Result<double> timeUnit(const std::string& name);

} // namespace osgTreeWind

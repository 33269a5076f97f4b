// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>

namespace osgTreeWind {

/// Conversion factor to m/s of "m/s", "km/h", "kn" (knots), "mph" or "ft/s". Any other name is an error that
/// lists them; the diagnostic has only a message.
Result<double> speedUnit(const std::string& name);

/// The name that speedUnit() uses for a unit: "m/s" for "m s-1", "meters per second", ...; unknown names are
/// returned unchanged.
std::string canonicalSpeedUnit(const std::string& text);

/// Conversion factor to seconds of "s", "min", "h", "days" or "ms". Any other name is an error that lists
/// them.
Result<double> timeUnit(const std::string& name);

} // namespace osgTreeWind

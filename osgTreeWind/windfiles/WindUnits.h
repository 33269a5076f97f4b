// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>

namespace osgTreeWind {

/// One unit of speed in m/s: "m/s", "km/h", "kn" (knots), "mph" or "ft/s". Any other name is an error that
/// lists them; its diagnostic has a message only.
Result<double> speedUnit(const std::string& name);

/// One unit of time in seconds: "s", "min" or "h". Any other name is an error that lists them.
Result<double> timeUnit(const std::string& name);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// Limits of measured winds. Codes for missing values, such as -999, 999.9 or 990 degrees, lie outside.
constexpr double maxMeasuredSpeed = 200.0; ///< m/s; the strongest gust ever measured is 113.
constexpr double maxDirection = 360.0;     ///< Degrees, absolute.

constexpr double maxCoordinate = 1e9; ///< Metres, absolute.
constexpr double maxTime = 1e15;      ///< Seconds, absolute.

/// Readers of records stop after this many problems.
constexpr std::size_t maxRecordProblems = 100;

/// Checks that times are within `maxTime` and strictly increasing; otherwise a problem with key "times".
Diagnostics checkTimes(const std::vector<double>& times);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace osgTreeWind {

/// What a record of measured wind may hold. Codes for missing values, such as -999, 999.9 or 990 degrees,
/// lie outside.
constexpr double maxMeasuredSpeed = 200.0; ///< m/s; the strongest gust ever measured is 113.
constexpr double maxDirection = 360.0;     ///< Degrees, either way round.

constexpr double maxCoordinate = 1e9; ///< Metres, either way.
constexpr double maxTime = 1e15;      ///< Seconds, either way.

/// Readers of records stop after this many problems.
constexpr std::size_t maxRecordProblems = 100;

} // namespace osgTreeWind

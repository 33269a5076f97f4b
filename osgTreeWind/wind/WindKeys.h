// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>
#include <osgTreeWind/wind/CanopySettings.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/ThesisWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/Wind.h>

namespace osgTreeWind {

/// Range of velocity components in files, m/s; no wind on Earth has been faster.
constexpr Range windSpeeds = within(-200, 200);
/// Number of points along a side of a grid, and their spacing in metres.
constexpr Range gridPoints = within(1, 100000), gridCells = above(0, 1e6);

/// Keys of files for each struct.
template <>
const Keys& keysOf<WindGusts>();
template <>
const Keys& keysOf<GridWind::Grid>();
template <>
const Keys& keysOf<ThesisWind::Array>();
/// Without the profile.
template <>
const Keys& keysOf<WindSeries>();
template <>
const Keys& keysOf<LogProfile>();
template <>
const Keys& keysOf<CanopySettings>();
/// Without `travel` and `origin`.
template <>
const Keys& keysOf<WindClock>();
template <>
const Keys& keysOf<WindAdjustment>();
template <>
const Keys& keysOf<WindSource>();

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/wind/CanopySettings.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/ThesisWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/Wind.h>

namespace osgTreeWind {

/// Range of velocity components in files, m/s; no wind on Earth has been faster.
constexpr Range windSpeeds = within(-200, 200);
/// Number of points along a side of a grid, and their spacing in metres.
constexpr Range gridPoints = within(1, 100000), gridCells = above(0, 1e6);

/// Keys of files for each struct. Without mean and profile, which have keys of their own.
template <>
const Fields& fieldsOf<GustWind::Parameters>();
template <>
const Fields& fieldsOf<GridWind::Grid>();
template <>
const Fields& fieldsOf<ThesisWind::Array>();
/// Without the profile.
template <>
const Fields& fieldsOf<WindSeries>();
template <>
const Fields& fieldsOf<LogProfile>();
template <>
const Fields& fieldsOf<CanopySettings>();
/// Without `travel` and `origin`.
template <>
const Fields& fieldsOf<WindClock>();
template <>
const Fields& fieldsOf<WindAdjustment>();
template <>
const Fields& fieldsOf<WindSource>();

} // namespace osgTreeWind

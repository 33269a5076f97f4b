// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/wind/ForestWind.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/Wind.h>

namespace osgTreeWind {

/// Components of a velocity that a file may say, m/s; no wind on Earth was faster.
constexpr Range windSpeeds = within(-200, 200);
/// Points along a side of a grid, and metres between them.
constexpr Range gridPoints = within(1, 100000), gridCells = above(0, 1e6);

/// But for mean and profile.
template <>
const Fields& fieldsOf<GustWind::Parameters>();
template <>
const Fields& fieldsOf<GridWind::Grid>();
template <>
const Fields& fieldsOf<ForestWind::Array>();
/// But for the profile.
template <>
const Fields& fieldsOf<WindSeries>();
template <>
const Fields& fieldsOf<LogProfile>();
template <>
const Fields& fieldsOf<WindCanopy>();
/// But for the plane.
template <>
const Fields& fieldsOf<WindClock>();
template <>
const Fields& fieldsOf<WindAdjustment>();
template <>
const Fields& fieldsOf<WindSource>();

} // namespace osgTreeWind

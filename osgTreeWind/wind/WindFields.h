// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/wind/GustWind.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/RetimedWind.h>

namespace osgTreeWind {

/// Components of a velocity that a file may say, m/s; no wind on Earth was faster.
constexpr Range windSpeeds = within(-200, 200);

/// But for mean and profile.
template <>
const Fields& fieldsOf<GustWind::Parameters>();
template <>
const Fields& fieldsOf<LogProfile>();
/// But for the plane.
template <>
const Fields& fieldsOf<RetimedWind::Clock>();

} // namespace osgTreeWind

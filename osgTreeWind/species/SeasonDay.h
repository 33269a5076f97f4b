// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Season.h>

namespace osgTreeWind {

constexpr float midwinterDay = 34.5f, seasonDays = 365.25f / 4.0f; // noon of 4 February; days in a season

/// The season at noon of a day. @param day days since 1 January, 0 to 365.
inline float seasonOfDay(int day) {
    return wrapSeason((static_cast<float>(day) + 0.5f - midwinterDay) / seasonDays);
}

/// The day of a season in a year without 29 February: days since 1 January, 0 to 364.
inline int dayOfSeason(float season) {
    return static_cast<int>(midwinterDay + seasonDays * wrapSeason(season)) % 365;
}

} // namespace osgTreeWind

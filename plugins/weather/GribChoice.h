// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribMeaning.h>

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Which fields of a file are its wind.
struct GribChoice {
    std::vector<double> times;     ///< Seconds since 1970, increasing.
    std::vector<GribLevel> levels; ///< All of one kind; upward, as far as their numbers tell.

    /// For each time and in it each level.
    std::vector<const GribField*> east, north;
    std::vector<const GribField*> up;     ///< Empty: it has none.
    std::vector<const GribField*> height; ///< Heights of the levels above sea level; empty: levels say.
    const GribField* ground = nullptr;    ///< Height of the model's ground; null: none, or not needed.

    bool polar = false; ///< `east` is a speed, `north` the direction it comes from.
    std::vector<std::string> notes;

    std::size_t indexOf(std::size_t time, std::size_t level) const { return time * levels.size() + level; }
    /// All that is to be read.
    std::vector<const GribField*> all() const;
};

/// Takes heights above ground before isobaric levels, those before model levels, and those before heights
/// above sea level; isobaric and model levels only where their heights are known. Where several forecasts
/// hold at one time the latest is taken. A problem where something is missing or there twice.
Result<GribChoice> chooseGribWind(const std::vector<GribField>& fields, const std::string& file);

/// "U at 850 hPa at 2017-06-03T18:00:00Z".
std::string textOf(const GribField& field);

} // namespace osgTreeWind

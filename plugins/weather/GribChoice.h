// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribMeaning.h>

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The fields of a GRIB file that make up its wind.
struct GribChoice {
    std::vector<double> times;     ///< Seconds since 1970, increasing.
    std::vector<GribLevel> levels; ///< All of the same kind, upward as far as their values tell.

    /// One for each time and level; see indexOf().
    std::vector<const GribField*> east, north;
    std::vector<const GribField*> up;     ///< Empty if the file has no vertical velocity.
    std::vector<const GribField*> height; ///< Above sea level; empty if the levels are heights.
    const GribField* ground = nullptr;    ///< Terrain height of the model; null if unavailable or not needed.

    bool isPolar = false; ///< `east` is the speed, `north` the direction the wind comes from.
    std::vector<std::string> notes;

    std::size_t indexOf(std::size_t time, std::size_t level) const { return time * levels.size() + level; }
    /// All fields to be read.
    std::vector<const GribField*> allFields() const;
};

/// Chooses the wind at heights above ground, otherwise at isobaric levels, model levels or heights above sea
/// level; isobaric and model levels only if their heights are known. Of several forecasts for the same time
/// the latest is used. A missing or duplicate field is a problem.
/// @param variable as WindFileOptions::variable: only fields at the levels of these are used.
Result<GribChoice> chooseGribWind(const std::vector<GribField>& fields, const std::string& file,
                                  const std::vector<std::string>& variable);

/// Name for messages: "U at 850 hPa at 2017-06-03T18:00:00Z".
std::string textOf(const GribField& field);

} // namespace osgTreeWind

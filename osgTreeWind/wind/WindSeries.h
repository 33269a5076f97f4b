// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/LogProfile.h>

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// A wind record taken at one point, as plain values: what the readers give and TimeSeriesWind takes.
struct WindSeries {
    std::vector<double> times;         ///< Seconds, strictly increasing; readers start them at 0.
    std::vector<glm::vec3> velocities; ///< m/s toward, one per time.
    bool repeat = false;               ///< Start again after the last time (period last - first) or hold it.
    std::optional<LogProfile> profile; ///< Over the ground of each place; empty: all heights alike.
};

} // namespace osgTreeWind

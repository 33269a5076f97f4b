// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// A wind record from one point, as file readers return it and TimeSeriesWind uses it.
struct WindSeries {
    std::vector<double> times;         ///< Seconds, strictly increasing; readers start at 0.
    std::vector<glm::vec3> velocities; ///< m/s toward, one for each time.
    bool repeat = false;               ///< Repeat with the period last - first instead of holding the ends.
    std::optional<LogProfile> profile; ///< Above the ground of each place; empty: the same at all heights.
    std::optional<double> date{};      ///< Of time 0, seconds since 1970-01-01T00:00Z; empty: unknown.
};

/// Mean velocity of a record, m/s, each weighted by the time in which it is the nearest; 0 if empty.
OSGTREEWIND_EXPORT glm::dvec3 meanVelocity(const WindSeries& series);

/// The wind record of one point, applied to the whole forest. Velocity components (not directions) are
/// interpolated linearly in time and, if the record has a profile, scaled with the height above the ground.
/// Times before the first and after the last clamp to them, or the record repeats.
///
///     WindSeries record;
///     record.times = {0.0, 600.0};
///     record.velocities = {{4.0f, 0.0f, 0.0f}, {0.0f, 7.0f, 0.0f}};
///     if (const auto wind = TimeSeriesWind::create(record))
///         report(forest->setWind(wind.value()));
class OSGTREEWIND_EXPORT TimeSeriesWind final : public WindField {
public:
    /// Checks the record and returns the wind, or diagnostics with the member's name as key.
    static Result<std::shared_ptr<const TimeSeriesWind>> create(WindSeries series);

    const WindSeries& series() const { return _series; } ///< The record as given.

    std::optional<LogProfile> profile() const override { return _series.profile; }
    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

private:
    explicit TimeSeriesWind(WindSeries series);

    glm::dvec3 measured(double time) const;

    WindSeries _series;
};

} // namespace osgTreeWind

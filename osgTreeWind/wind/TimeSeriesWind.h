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

/// A wind record taken at one point, as plain values: what the readers give and TimeSeriesWind takes.
struct WindSeries {
    std::vector<double> times;         ///< Seconds, strictly increasing; readers start them at 0.
    std::vector<glm::vec3> velocities; ///< m/s toward, one per time.
    bool repeat = false;               ///< Start again after the last time (period last - first) or hold it.
    std::optional<LogProfile> profile; ///< Over the ground of each place; empty: all heights alike.
};

/// Of all of a record, each velocity for as long as it is the nearest, m/s; of one that is empty 0.
OSGTREEWIND_EXPORT glm::dvec3 meanVelocity(const WindSeries& series);

/// A record of wind at one point, blowing over the whole forest: components linear in time (directions are
/// never interpolated), scaled with height above the ground where the record has a profile. Before the first
/// record the first holds; after the last the last holds or the record repeats.
///
///     WindSeries record;
///     record.times = {0.0, 600.0};
///     record.velocities = {{4.0f, 0.0f, 0.0f}, {0.0f, 7.0f, 0.0f}};
///     if (const auto wind = TimeSeriesWind::create(record))
///         forest->setWind(wind.value());
class OSGTREEWIND_EXPORT TimeSeriesWind final : public WindField {
public:
    /// A field over the record, or what is wrong with it: diagnostics with the member's name as key.
    static Result<std::shared_ptr<const TimeSeriesWind>> create(WindSeries series);

    const WindSeries& series() const { return _series; } ///< As given.

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    KindOfWind kind() const override { return this; }

private:
    explicit TimeSeriesWind(WindSeries series);

    glm::dvec3 measured(double time) const;
    glm::vec3 atHeight(const glm::dvec3& measured, float height) const;

    WindSeries _series;
};

} // namespace osgTreeWind

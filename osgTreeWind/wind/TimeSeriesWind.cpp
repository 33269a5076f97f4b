// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/TimeSeriesWind.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/FiniteVelocity.h>
#include <osgTreeWind/wind/Interpolation.h>
#include <osgTreeWind/wind/LogFactor.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

Diagnostics check(const WindSeries& series) {
    Diagnostics problems = checkTimes(series.times);
    if (series.times.empty())
        problems.push_back(keyProblem("times", "expected at least one record"));
    if (series.velocities.size() != series.times.size())
        problems.push_back(keyProblem("velocities", "expected one per time, " +
                                                        std::to_string(series.times.size()) + ", found " +
                                                        std::to_string(series.velocities.size())));
    for (std::size_t i = 0; i < series.velocities.size(); ++i)
        if (calmUnlessFinite(series.velocities[i]) != series.velocities[i])
            problems.push_back(
                keyProblem("velocities", "expected finite m/s at velocities[" + std::to_string(i) + "]"));
    if (series.profile && !series.profile->valid())
        problems.push_back(
            keyProblem("profile", "expected 0 < roughness < height in metres, found roughness " +
                                      numberText(series.profile->roughness) + " and height " +
                                      numberText(series.profile->height)));
    return problems;
}

/// The time wrapped into the first period.
double wrapped(double time, const std::vector<double>& times) {
    const double first = times.front(), period = times.back() - first;
    const double phase =
        std::fmod(time - first, period); // NaN if the period is 0, which gives the first record
    return first + (phase < 0.0 ? phase + period : phase);
}

} // namespace

glm::dvec3 meanVelocity(const WindSeries& series) {
    const std::size_t count = std::min(series.times.size(), series.velocities.size());
    glm::dvec3 sum(0.0);
    double duration = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double before = series.times[i > 0 ? i - 1 : i],
                     after = series.times[i + 1 < count ? i + 1 : i];
        const double span = count > 1 ? 0.5 * (after - before) : 1.0;
        sum += span * glm::dvec3(series.velocities[i]);
        duration += span;
    }
    return duration > 0.0 ? sum / duration : sum;
}

TimeSeriesWind::TimeSeriesWind(WindSeries series) : _series(std::move(series)) {}

Result<std::shared_ptr<const TimeSeriesWind>> TimeSeriesWind::create(WindSeries series) {
    Diagnostics problems = check(series);
    if (!problems.empty())
        return problems;
    return std::shared_ptr<const TimeSeriesWind>(new TimeSeriesWind(std::move(series)));
}

glm::dvec3 TimeSeriesWind::measured(double time) const {
    const Interpolation span =
        interpolationAtTime(_series.repeat ? wrapped(time, _series.times) : time, _series.times);
    return span.mix(glm::dvec3(_series.velocities[span.lower]), glm::dvec3(_series.velocities[span.upper]));
}

glm::vec3 TimeSeriesWind::velocity(const WindPlace& place, double time) const {
    glm::vec3 result;
    sample(&place, 1, time, &result);
    return result;
}

void TimeSeriesWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    const glm::dvec3 now = measured(time);
    if (!_series.profile) {
        std::fill_n(out, count, clampedVelocity(now));
        return;
    }
    const LogFactor factor(*_series.profile);
    for (std::size_t i = 0; i < count; ++i)
        out[i] = clampedVelocity(now * static_cast<double>(factor(places[i].height)));
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/Interpolation.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

Interpolation interpolationAtIndex(double index, std::size_t count) {
    const std::size_t last = count - 1;
    if (!(index > 0.0))
        return {0, 0, 0.0};
    if (index >= static_cast<double>(last))
        return {last, last, 0.0};
    const auto lower = static_cast<std::size_t>(index);
    return {lower, lower + 1, index - static_cast<double>(lower)};
}

Interpolation interpolationAtTime(double time, const std::vector<double>& times) {
    const std::size_t last = times.size() - 1;
    if (!(time > times.front()))
        return {0, 0, 0.0};
    if (time >= times.back())
        return {last, last, 0.0};
    const auto next = std::upper_bound(times.begin(), times.end(), time);
    const auto upper = static_cast<std::size_t>(next - times.begin());
    const double begin = times[upper - 1];
    return {upper - 1, upper, (time - begin) / (times[upper] - begin)};
}

Diagnostics checkTimes(const std::vector<double>& times) {
    for (std::size_t i = 0; i < times.size(); ++i) {
        const std::string which = "times[" + std::to_string(i) + "]";
        if (!(std::abs(times[i]) <= maxTime))
            return {keyProblem("times", "expected seconds within 1e15, found " + which + " = " +
                                            numberText(times[i]))};
        if (i > 0 && times[i] <= times[i - 1])
            return {keyProblem("times", "expected increasing seconds, found " + which + " = " +
                                            numberText(times[i]) + " after " + numberText(times[i - 1]))};
    }
    return {};
}

} // namespace osgTreeWind

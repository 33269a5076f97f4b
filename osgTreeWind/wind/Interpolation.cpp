// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/Interpolation.h>

#include <algorithm>

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

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/EvenAxis.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// Points `from` to `to` in ascending order; indices beyond the ends wrap around the seam.
AxisPart axisPart(const EvenAxis& axis, long long from, long long to) {
    const double step = std::abs(axis.step);
    const auto count = static_cast<long long>(axis.count);
    const double lowest =
        axis.step > 0.0 ? axis.first : axis.first + axis.step * static_cast<double>(count - 1);
    AxisPart part{lowest + step * static_cast<double>(from), step, {}};
    for (long long i = from; i <= to; ++i) {
        const long long upward = ((i % count) + count) % count;
        part.indices.push_back(static_cast<std::size_t>(axis.step > 0.0 ? upward : count - 1 - upward));
    }
    return part;
}

} // namespace

bool isCyclic(const EvenAxis& axis) {
    const double step = std::abs(axis.step), length = step * static_cast<double>(axis.count - 1);
    return axis.period > 0.0 && std::abs(length + step - axis.period) < 0.01 * step;
}

AxisPart wholeAxis(const EvenAxis& axis) {
    return axisPart(axis, 0, static_cast<long long>(axis.count) - 1);
}

AxisPart partAround(const EvenAxis& axis, double low, double high) {
    const double step = std::abs(axis.step), length = step * static_cast<double>(axis.count - 1),
                 lowest = std::min(axis.first, axis.first + axis.step * static_cast<double>(axis.count - 1));
    const auto last = static_cast<long long>(axis.count) - 1;
    double turns = 0.0; // offset of the requested interval from the axis, whole periods
    if (axis.period > 0.0)
        turns = axis.period * std::round((0.5 * (low + high) - lowest - 0.5 * length) / axis.period);
    const auto pointAt = [&](double coordinate) {
        return std::clamp((coordinate - turns - lowest) / step, -1e9, 1e9);
    };
    auto from = static_cast<long long>(std::floor(pointAt(low))) - 1,
         to = static_cast<long long>(std::ceil(pointAt(high))) + 1;
    if (!isCyclic(axis)) {
        constexpr long long minSteps = 2; // so that staggered components have both neighbours at an edge
        from = std::clamp(from, 0LL, std::max(0LL, last - minSteps));
        to = std::clamp(to, std::min(last, minSteps), last);
    } else if (to - from > last)
        to = from + last;
    AxisPart part = axisPart(axis, from, to);
    part.first += turns;
    return part;
}

} // namespace osgTreeWind

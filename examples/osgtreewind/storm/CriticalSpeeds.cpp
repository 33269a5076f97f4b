// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/CriticalSpeeds.h>

#include <osgTreeWind/base/PortableMath.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgTreeWind {

namespace {

/// Logarithms of the speed of a storm, and of its moment over the limit.
struct Point {
    double speed, ratio;

    double distance() const { return std::abs(ratio); }
};

/// Storms as points, the nearest to the limit first.
std::vector<Point> byDistance(const MomentsBySpeed& moments, double limit) {
    std::vector<Point> points;
    for (const auto& [speed, moment] : moments)
        if (limit > 0.0 && moment > 0.0)
            points.push_back({math::log(speed), math::log(moment / limit)});
    std::stable_sort(points.begin(), points.end(),
                     [](const Point& a, const Point& b) { return a.distance() < b.distance(); });
    return points;
}

/// Speed at which the moment reaches the limit.
double crossing(const std::vector<Point>& points) {
    double power = 2.0;
    if (points.size() > 1 && std::abs(points[1].speed - points[0].speed) > 0.01)
        power =
            std::clamp((points[1].ratio - points[0].ratio) / (points[1].speed - points[0].speed), 0.7, 3.0);
    return math::exp(points[0].speed - points[0].ratio / power);
}

/// Simulates more storms until one is close to the limit.
void addStormsNear(MomentsBySpeed& moments, const std::function<double(double)>& storm, double limit) {
    constexpr double near = 0.05; // of the moment; interpolation does the rest
    constexpr int most = 5;
    for (int i = 0; i < most; ++i) {
        const std::vector<Point> points = byDistance(moments, limit);
        if (points.empty() || points[0].distance() < near)
            return;
        const double speed = std::clamp(crossing(points), 1.0, CriticalSpeeds::fastest);
        if (moments.count(speed) > 0)
            return;
        moments.emplace(speed, storm(speed));
    }
}

} // namespace

std::optional<double> criticalSpeed(const MomentsBySpeed& moments, double limit) {
    const std::vector<Point> points = byDistance(moments, limit);
    const double speed = points.empty() ? CriticalSpeeds::fastest : crossing(points);
    return speed < CriticalSpeeds::fastest ? std::optional(speed) : std::nullopt;
}

CriticalSpeeds criticalSpeeds(const MomentsBySpeed& moments, const TreeStrength& strength) {
    return {criticalSpeed(moments, strength.uproot), criticalSpeed(moments, strength.breaking)};
}

CriticalSpeeds findCriticalSpeeds(const std::function<double(double)>& storm, const TreeStrength& strength) {
    constexpr double first = 20.0;
    MomentsBySpeed moments{{first, storm(first)}};
    addStormsNear(moments, storm, strength.uproot);
    addStormsNear(moments, storm, strength.breaking);
    return criticalSpeeds(moments, strength);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/CriticalSpeeds.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgTreeWind {

namespace {

/// One storm, by logarithms of its speed and of its moment over the limit.
struct Point {
    double speed, ratio;

    double distance() const { return std::abs(ratio); }
};

/// The nearest to the limit first.
std::vector<Point> byDistance(const Storms& storms, double limit) {
    std::vector<Point> points;
    for (const auto& storm : storms)
        if (limit > 0.0 && storm.second > 0.0)
            points.push_back({std::log(storm.first), std::log(storm.second / limit)});
    std::stable_sort(points.begin(), points.end(),
                     [](const Point& a, const Point& b) { return a.distance() < b.distance(); });
    return points;
}

/// Where the moment is the limit.
double crossing(const std::vector<Point>& points) {
    double power = 2.0;
    if (points.size() > 1 && std::abs(points[1].speed - points[0].speed) > 0.01)
        power =
            std::clamp((points[1].ratio - points[0].ratio) / (points[1].speed - points[0].speed), 0.7, 3.0);
    return std::exp(points[0].speed - points[0].ratio / power);
}

/// Adds storms until one is near.
void approach(Storms& storms, const std::function<double(double)>& storm, double limit) {
    constexpr double near = 0.05; // of the moment: what is left is on a line
    constexpr int most = 5;
    for (int i = 0; i < most; ++i) {
        const std::vector<Point> points = byDistance(storms, limit);
        if (points.empty() || points[0].distance() < near)
            return;
        const double speed = std::clamp(crossing(points), 1.0, CriticalSpeeds::fastest);
        if (storms.count(speed) > 0)
            return;
        storms.emplace(speed, storm(speed));
    }
}

} // namespace

std::optional<double> criticalSpeed(const Storms& storms, double limit) {
    const std::vector<Point> points = byDistance(storms, limit);
    const double speed = points.empty() ? CriticalSpeeds::fastest : crossing(points);
    return speed < CriticalSpeeds::fastest ? std::optional(speed) : std::nullopt;
}

CriticalSpeeds criticalSpeeds(const Storms& storms, const TreeStrength& strength) {
    return {criticalSpeed(storms, strength.uproot), criticalSpeed(storms, strength.breaking)};
}

CriticalSpeeds findCriticalSpeeds(const std::function<double(double)>& storm, const TreeStrength& strength) {
    constexpr double first = 20.0;
    Storms storms{{first, storm(first)}};
    approach(storms, storm, strength.uproot);
    approach(storms, storm, strength.breaking);
    return criticalSpeeds(storms, strength);
}

} // namespace osgTreeWind

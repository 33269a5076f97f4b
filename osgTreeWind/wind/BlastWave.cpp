// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/BlastWave.h>

#include <osgTreeWind/base/PortableMath.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double pressure = 101325.0, sound = 340.3; // Pa and m/s of air, standard atmosphere at sea level
constexpr double hemisphere = 1.8;
constexpr double minScaled = 0.05, maxScaled = 500.0;  // scaled distance, m/kg^(1/3): the range of the fits
constexpr double averagingTime = 0.2, maxWind = 200.0; // seconds, m/s

double square(double x) {
    return x * x;
}

/// Over the ambient pressure. @param z scaled distance.
double overpressureAt(double z) {
    return 808.0 * (1.0 + square(z / 4.5)) /
           std::sqrt((1.0 + square(z / 0.048)) * (1.0 + square(z / 0.32)) * (1.0 + square(z / 1.35)));
}

/// Seconds over the cube root of the charge.
double durationAt(double z) {
    return 0.98 * (1.0 + math::pow(z / 0.54, 10.0)) /
           ((1.0 + math::pow(z / 0.02, 3.0)) * (1.0 + math::pow(z / 0.74, 6.0)) *
            std::sqrt(1.0 + square(z / 6.9)));
}

/// @param p overpressure over the ambient pressure.
double machNumber(double p) {
    return std::sqrt(1.0 + 6.0 / 7.0 * p);
}

/// Table of arrival times of the front, in even steps of the logarithm of the scaled distance.
class ArrivalTimes {
public:
    ArrivalTimes() {
        for (std::size_t i = 1; i < _seconds.size(); ++i) {
            const double from = distance(i - 1), to = distance(i), middle = 0.5 * (from + to);
            _seconds[i] = _seconds[i - 1] + (to - from) / (sound * machNumber(overpressureAt(middle)));
        }
    }
    double at(double z) const {
        const double position = math::log(z / minScaled) / step();
        const auto i = std::min(static_cast<std::size_t>(position), _seconds.size() - 2);
        const double share = (z - distance(i)) / (distance(i + 1) - distance(i));
        return _seconds[i] + share * (_seconds[i + 1] - _seconds[i]);
    }

private:
    static constexpr std::size_t count = 256;
    static double step() { return math::log(maxScaled / minScaled) / (count - 1); }
    static double distance(std::size_t i) { return minScaled * math::exp(step() * static_cast<double>(i)); }
    std::array<double, count> _seconds{};
};

/// The integral from 0 to s of (1 - s) |1 - s| exp(-2 s).
double impulse(double s) {
    const auto integral = [](double x) {
        return -0.25 * math::exp(-2.0 * x) * (2.0 * x * x - 2.0 * x + 1.0);
    };
    if (s <= 0.0)
        return 0.0;
    const double outward = integral(std::min(s, 1.0)) - integral(0.0);
    return s <= 1.0 ? outward : outward - (integral(s) - integral(1.0));
}

} // namespace

BlastWave::BlastWave(double charge) : _scale(math::cbrt(hemisphere * charge)) {}

BlastWave::Front BlastWave::front(double distance) const {
    static const ArrivalTimes arrivals;
    const double z = std::clamp(distance / _scale, minScaled, maxScaled), beyond = distance / _scale - z;
    const double p = overpressureAt(z) * (beyond > 0.0 ? z / (z + beyond) : 1.0);
    Front front;
    front.overpressure = pressure * p;
    front.wind = sound * 5.0 / 7.0 * p / machNumber(p);
    front.arrival = _scale * (arrivals.at(z) + std::max(beyond, 0.0) / sound);
    front.duration = _scale * durationAt(z);
    return front;
}

double BlastWave::reach(double wind) const {
    const auto isFaster = [&](double distance) {
        const Front at = front(distance);
        return square(at.wind) * at.duration / averagingTime * impulse(1.0) > square(wind);
    };
    double distance = _scale;
    while (isFaster(distance) && distance < 1e7)
        distance *= 1.1;
    return distance;
}

double BlastWave::wind(double distance, double time) const {
    const Front at = front(distance);
    const double now = (time - at.arrival) / at.duration, before = now - averagingTime / at.duration;
    const double push = square(at.wind) * at.duration / averagingTime * (impulse(now) - impulse(before));
    return std::clamp(std::copysign(std::sqrt(std::abs(push)), push), -maxWind, maxWind);
}

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <functional>
#include <map>
#include <optional>

namespace osgTreeWind {

/// Mean winds, m/s, at which the largest moment expected in an hour reaches the strength of a tree.
struct CriticalSpeeds {
    static constexpr double fastest = 80.0;

    std::optional<double> uproot, breaking; ///< Empty if unknown or above `fastest`.
};

/// Largest load in an hour by the mean wind of that hour, m/s. The load is usually the moment at the foot, N
/// m.
using MomentsBySpeed = std::map<double, double>;

/// Interpolates the wind at which the load reaches a limit: on the line through the logarithms of the two
/// storms nearest to it, with its slope clamped to 0.7 to 3, or with slope 2 if there is only one storm.
/// Empty if there is no limit, or the wind is above CriticalSpeeds::fastest.
std::optional<double> criticalSpeed(const MomentsBySpeed& moments, double limit);
/// The same for the strength of roots and stem.
CriticalSpeeds criticalSpeeds(const MomentsBySpeed& moments, const TreeStrength& strength);

/// Finds the critical speeds by simulating a few storms. @param storm largest moment in an hour of a mean
/// wind.
CriticalSpeeds findCriticalSpeeds(const std::function<double(double speed)>& storm,
                                  const TreeStrength& strength);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/damage/TreeStrength.h>

#include <functional>
#include <map>
#include <optional>

namespace osgTreeWind {

/// Mean winds in which the largest moment to be expected in an hour is what a tree bears, m/s.
struct CriticalSpeeds {
    static constexpr double fastest = 80.0;

    std::optional<double> uproot, breaking; ///< None: not known, or above `fastest`.
};

/// By the mean wind of an hour, m/s, the largest moment at the foot of a tree in it, N m.
using Storms = std::map<double, double>;

/// From storms that there were, the one in which the load is a limit: on a line through the logarithms of the
/// two nearest to a limit, of a slope within 0.7 to 3; of slope 2 where there is but one. None: there is no
/// limit, or it is above CriticalSpeeds::fastest.
std::optional<double> criticalSpeed(const Storms& storms, double limit);
/// The same for roots and stem.
CriticalSpeeds criticalSpeeds(const Storms& storms, const TreeStrength& strength);

/// Looks for them with a few storms. @param storm the largest moment in an hour of a mean wind.
CriticalSpeeds findCriticalSpeeds(const std::function<double(double speed)>& storm,
                                  const TreeStrength& strength);

} // namespace osgTreeWind

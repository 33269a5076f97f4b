// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindLimits.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <cmath>

namespace osgTreeWind {

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

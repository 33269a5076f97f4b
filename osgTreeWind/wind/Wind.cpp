// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/Wind.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <string>

namespace osgTreeWind {

Diagnostics check(const Wind& wind) {
    Diagnostics problems;
    if (wind.frame < WindFrame::Forest || wind.frame > WindFrame::Geocentric)
        problems.push_back(keyProblem("wind.frame", "expected a value of the enumeration, found " +
                                                        std::to_string(static_cast<int>(wind.frame))));
    checkKeys(wind.gusts, "wind", problems);
    return problems;
}

} // namespace osgTreeWind

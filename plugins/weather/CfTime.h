// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// When the steps of a file are.
struct CfTimes {
    std::vector<double> seconds; ///< Since the first.
    std::string start;           ///< As WindSummary::start.
};

/// What numbers mean in a unit of time as the CF conventions have it: "hours since 1900-01-01 00:00:00.0", or
/// without a date. A problem has a message only.
/// @param calendar its attribute; empty where there is none.
Result<CfTimes> cfTimes(const std::vector<double>& numbers, const std::string& unit,
                        const std::string& calendar);

} // namespace osgTreeWind

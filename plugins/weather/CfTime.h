// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// Times of the steps of a file.
struct CfTimes {
    std::vector<double> seconds; ///< Since the first step.
    std::string start;           ///< As WindSummary::start.
};

/// Decodes times of the CF conventions. A problem has only a message.
/// @param unit such as "hours since 1900-01-01 00:00:00.0", or without a date.
/// @param calendar the attribute; empty if there is none.
Result<CfTimes> decodeCfTimes(const std::vector<double>& numbers, const std::string& unit,
                              const std::string& calendar);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <functional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Joins time steps from several files to one wind, for readWindFiles(). Heights of single points may differ
/// from file to file; the rest of the grid must be the same.
/// @param times one for each file; empty if the files contain their times, as dates or seconds.
/// @param read reads and checks one file, with velocities in m/s.
Result<WindContent> readWindSteps(const std::vector<std::string>& files, const std::vector<double>& times,
                                  const std::function<Result<WindContent>(const std::string&)>& read);

} // namespace osgTreeWind

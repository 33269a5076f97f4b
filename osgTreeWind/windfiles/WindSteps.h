// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <functional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Reads files as one wind over these times, of one time each, or over all of their own: what readWindFiles()
/// begins with. Heights of single points may move from file to file; all else of the grid must be alike. Not
/// part of the interface.
/// @param times none: each file says its own, as dates or as seconds.
/// @param read one of the files, sound on its own, velocities in m/s.
Result<WindContent> readWindSteps(const std::vector<std::string>& files, const std::vector<double>& times,
                                  const std::function<Result<WindContent>(const std::string&)>& read);

} // namespace osgTreeWind

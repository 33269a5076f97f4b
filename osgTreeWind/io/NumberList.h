// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <istream>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Reads all numbers of a text, separated by blanks, line ends, commas or semicolons; '#' starts a comment.
/// Anything else, and a number that is not finite, is a problem with line and column.
/// @param file name for diagnostics only.
Result<std::vector<double>> readNumberList(std::istream& input, const std::string& file);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// The word closest to `word` by edit distance; empty if none is similar.
std::string nearestName(const std::string& word, const std::vector<std::string>& words);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Keeps this process from what a damaged file may not cost: a core file, and more memory and time than a
/// whole one would take.
/// @param files that it reads. @param memory bytes that are left beside 256 for each of the files'; both
/// together at most memoryLimit(), but never less than 256 MiB.
/// @param seconds that are left beside one for each of their MiB.
/// @return for how many seconds the alarm is set.
unsigned limitReader(const std::vector<std::string>& files, std::size_t memory, unsigned seconds);

} // namespace osgTreeWind

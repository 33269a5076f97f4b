// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace osgTreeWind {

/// Keeps this process from what a damaged file may not cost: a core file, and more memory and time than a
/// whole one would take.
/// @param memory bytes that are left beside 256 for each of the file's.
/// @param seconds that are left beside one for each of its MiB.
void limitReader(const std::string& path, std::size_t memory, unsigned seconds);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <string>

/// Writes a CSV row for every tree as it stands: sizes that were given, and where they were not those of its
/// shape, and which were. False where the file cannot be written.
bool writeTrees(const osgTreeWind::ForestDescription& forest, const std::string& path);

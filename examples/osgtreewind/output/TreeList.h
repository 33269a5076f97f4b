// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <string>

/// Writes a CSV row for every tree as it stands: sizes that were given, and where they were not those of its
/// shape, and which were. Ends the command where it cannot.
void writeTrees(const osgTreeWind::ForestDescription& forest, const std::string& path);

// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <string>

/// Writes a CSV row for every tree: its given sizes, the sizes of its shape where none are given, and which
/// sizes were given. Throws CommandError if the file cannot be written.
void writeTrees(const osgTreeWind::ForestDescription& forest, const std::string& path);

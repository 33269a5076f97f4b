// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Reads `[species.growth]`, by which version 1 described the form of a tree. Its size holds, and angles and
/// bends become the nearest numbers of a habit. A note says so.
/// @param species with the habit of the species that it is like, if any.
/// @param palm whether the species is a palm, and its form becomes `[species.palm]`.
void readFormerGrowth(TableReader& table, ForestReading& reading, Species& species, bool palm);

} // namespace osgTreeWind

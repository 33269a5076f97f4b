// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/DocumentSpecies.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Reads the table `[species.growth]` of version 1 and converts it to a habit or palm. The size is kept, and
/// angles and bends are approximated. Adds a note.
/// @param species with the habit of its `like` species, if any. @param isPalm convert to `[species.palm]`.
void readLegacyGrowth(TableReader& table, DocumentSpecies& known, Species& species, bool isPalm);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// Finds the scientific name, or the genus, of a tree's common name in English, German, French, Spanish,
/// Dutch or Italian, as osgTreeWind/species/names.csv has it. Empty for a name that is not in the table.
const std::string& scientificName(const std::string& commonName);

/// Finds the scientific name of the common name with which a name ends: a maple for "Kugelahorn". Empty if
/// no common name of the table ends it.
const std::string& scientificNameOfEnd(const std::string& name);

} // namespace osgTreeWind

// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// The scientific name, or the genus, of a tree's common name in English, German, French, Spanish, Dutch or
/// Italian: osgTreeWind/species/names.csv. Empty where there is none.
const std::string& scientificName(const std::string& commonName);

/// The same of the common name with which a name ends: a maple for "Kugelahorn". Empty where there is none.
const std::string& scientificNameOfEnd(const std::string& name);

} // namespace osgTreeWind
